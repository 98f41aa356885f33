#include "profiles/profile_features.hpp"

#include "contact/base/root.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::profiles {

namespace {

constexpr double last_digits = 1e-13;  // mm along a profile

/// Length of a piece by Simpson's rule on the speed of the parameter, which is close to 1.
double length_of(const ProfileKnots& knots, std::size_t k) {
  const double h = knots.parameter[k + 1] - knots.parameter[k];
  const auto middle = [&](const std::vector<double>& x, const std::vector<double>& dx) {
    return 1.5 * (x[k + 1] - x[k]) / h - 0.25 * (dx[k] + dx[k + 1]);
  };
  const double speed = std::hypot(middle(knots.y, knots.dy), middle(knots.z, knots.dz));
  return h / 6.0 *
         (std::hypot(knots.dy[k], knots.dz[k]) + 4.0 * speed +
          std::hypot(knots.dy[k + 1], knots.dz[k + 1]));
}

/// Just before a knot, on the piece that ends there.
ProfilePoint before(const ProfileCurve& curve, std::size_t k) {
  const auto& p = curve.knots().parameter;
  return curve.at(p[k] - 1e-9 * (p[k] - p[k - 1]));
}

/// Place of the extreme height that the knot is nearest to.
ProfilePoint extreme(const ProfileCurve& curve, std::size_t knot) {
  const auto& p = curve.knots().parameter;
  const double low = p[knot > 0 ? knot - 1 : 0];
  const double high = p[std::min(knot + 1, p.size() - 1)];
  const bool rising = curve.at(low).tangent_z > 0.0;
  if (rising == (curve.at(high).tangent_z > 0.0)) return curve.at(p[knot]);
  return curve.at(contact::bracketed_root([&](double at) { return curve.at(at).tangent_z; }, low,
                                          high, last_digits, "extreme height of the profile"));
}

/// y where z passes a height, going from the place `from` to smaller parameters.
std::optional<double> face(const ProfileCurve& curve, std::size_t from, double height) {
  const ProfileKnots& knots = curve.knots();
  for (std::size_t k = from; k > 0; --k) {
    if ((knots.z[k] - height) * (knots.z[k - 1] - height) > 0.0) continue;
    const auto above = [&](double at) { return curve.at(at).z - height; };
    return curve
        .at(contact::bracketed_root(above, knots.parameter[k - 1], knots.parameter[k], last_digits,
                                    "face of the profile"))
        .y;
  }
  return {};
}

}  // namespace

ProfileFeatures profile_features(const ProfileCurve& curve, bool wheel) {
  const ProfileKnots& knots = curve.knots();
  const std::size_t n = knots.y.size();
  ProfileFeatures result;
  result.start = curve.at(curve.first());
  result.end = curve.at(curve.last());
  std::size_t top = 0, bottom = 0, level = 0;
  const auto sharper = [&](const ProfilePoint& place) {
    // The first place of an arc, whose curvature is the same to rounding all along.
    constexpr double clearly = 1.0 + 1e-4;
    if (place.curvature > clearly * result.sharpest_up.curvature) result.sharpest_up = place;
    if (place.curvature < clearly * result.sharpest_down.curvature) result.sharpest_down = place;
  };
  for (std::size_t k = 0; k < n; ++k) {
    if (k + 1 < n) result.length += length_of(knots, k);
    if (knots.z[k] < knots.z[top]) top = k;
    if (knots.z[k] > knots.z[bottom]) bottom = k;
    if (std::abs(knots.y[k]) < std::abs(knots.y[level])) level = k;
    const ProfilePoint right = curve.at(knots.parameter[k]);
    sharper(right);
    if (k == 0 || k + 1 == n) continue;
    const ProfilePoint left = before(curve, k);
    sharper(left);
    // Cubics of one formula meet within 1e-4 of their curvature; a joint is well beyond that.
    const double larger = std::max(std::abs(left.curvature), std::abs(right.curvature));
    if (std::abs(right.curvature - left.curvature) > 1e-4 + 0.05 * larger)
      result.joints.push_back({knots.parameter[k], right, left.curvature});
  }
  result.top = extreme(curve, top);
  result.bottom = extreme(curve, bottom);
  result.gauge_face = wheel ? face(curve, level, 10.0) : face(curve, top, result.top.z + 14.0);
  return result;
}

}  // namespace rollfem::profiles

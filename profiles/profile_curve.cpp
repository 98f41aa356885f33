// SPDX-License-Identifier: LGPL-2.1-or-later
#include "profiles/profile_curve.hpp"

#include "base/count.hpp"
#include "base/errors.hpp"
#include "base/knots.hpp"
#include "base/pi.hpp"
#include "base/root.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace rollfem::profiles {

namespace {

bool usable(const ProfilePoint& point) {
  return point.tangent_y > 0.0 && std::abs(point.tangent_z) <= steepest * point.tangent_y;
}

/// Point between `good` (usable) and `bad` (not) at which the curve becomes too steep, on the
/// usable side. By bisection, because a property changes there and no value vanishes.
double steep_place(const ProfileCurve& curve, double good, double bad) {
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (good + bad);
    (usable(curve.at(middle)) ? good : bad) = middle;
  }
  return good;
}

/// Steps in y that keep the cubic of z over y as accurate as the curve's own: z'' of a circle
/// changes by its own size over 1 / (3 s sqrt(1 + s^2) k), with the slope s and the curvature k.
int subdivisions(const ProfilePoint& a, const ProfilePoint& b) {
  double rate = 0.0;
  for (const ProfilePoint* point : {&a, &b}) {
    const double slope = std::abs(point->tangent_z / point->tangent_y);
    rate = std::max(rate, 3.0 * slope * std::hypot(1.0, slope) * std::abs(point->curvature));
  }
  constexpr double fraction = 0.03;
  return static_cast<int>(std::clamp(std::ceil((b.y - a.y) * rate / fraction), 1.0, 64.0));
}

}  // namespace

ProfileCurve::ProfileCurve(ProfileKnots knots) : knots_(std::move(knots)) {
  const std::size_t n = knots_.parameter.size();
  if (n < 2 || knots_.y.size() != n || knots_.z.size() != n || knots_.dy.size() != n ||
      knots_.dz.size() != n)
    throw std::invalid_argument("a profile curve needs at least two knots, each with a tangent");
  for (std::size_t k = 1; k < n; ++k)
    if (!(knots_.parameter[k] > knots_.parameter[k - 1]))
      throw std::invalid_argument("the parameters of a profile curve must increase");
  highest_y_.resize(n);
  lowest_y_.resize(n);
  highest_y_[0] = lowest_y_[0] = knots_.y[0];
  for (std::size_t k = 1; k < n; ++k) {
    highest_y_[k] = std::max(highest_y_[k - 1], knots_.y[k]);
    lowest_y_[k] = std::min(lowest_y_[k - 1], knots_.y[k]);
  }
}

ProfilePoint ProfileCurve::at(double parameter) const {
  const contact::KnotPiece piece = contact::piece_of(knots_.parameter, parameter);
  const auto coordinate = [&](const std::vector<double>& value, const std::vector<double>& slope) {
    const std::size_t a = piece.first, b = a + 1;
    return contact::hermite(piece.length, piece.part, value[a], value[b], slope[a], slope[b]);
  };
  const contact::CurveValue y = coordinate(knots_.y, knots_.dy),
                            z = coordinate(knots_.z, knots_.dz);
  const double speed = std::hypot(y.slope, z.slope);
  return {y.value, z.value, y.slope / speed, z.slope / speed,
          (y.slope * z.second - z.slope * y.second) / (speed * speed * speed)};
}

double ProfileCurve::parameter_at(double y) const {
  const double start = knots_.y.front();
  const bool up = y >= start;
  const auto& reached = up ? highest_y_ : lowest_y_;
  if (up ? y > reached.back() : y < reached.back())
    return std::abs(y - start) < std::abs(y - knots_.y.back()) ? first() : last();
  const auto found =
      up ? std::lower_bound(reached.begin(), reached.end(), y)
         : std::lower_bound(reached.begin(), reached.end(), y, std::greater<double>());
  const auto knot = static_cast<std::size_t>(found - reached.begin());
  if (knot == 0) return first();
  double below = knots_.parameter[knot - 1];
  double above = knots_.parameter[knot];
  for (int step = 0; step < 60 && above - below > 1e-14 * std::abs(above); ++step) {
    const double middle = 0.5 * (below + above);
    ((at(middle).y < y) == up ? below : above) = middle;
  }
  return 0.5 * (below + above);
}

ProfileCurve ProfileCurve::moved(double angle, double y, double z) const {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  ProfileKnots result = knots_;
  for (std::size_t k = 0; k < result.y.size(); ++k) {
    result.y[k] = c * knots_.y[k] - s * knots_.z[k] + y;
    result.z[k] = s * knots_.y[k] + c * knots_.z[k] + z;
    result.dy[k] = c * knots_.dy[k] - s * knots_.dz[k];
    result.dz[k] = s * knots_.dy[k] + c * knots_.dz[k];
  }
  return ProfileCurve(std::move(result));
}

ProfileCurve ProfileCurve::part(double from, double to) const {
  const std::vector<double>& all = knots_.parameter;
  auto begin = std::upper_bound(all.begin(), all.end() - 1, from);
  auto end = std::lower_bound(begin, all.end(), to);
  if (begin != all.begin()) --begin;
  if (end != all.end()) ++end;
  if (end - begin < 2) begin = end - 2;
  const auto cut = [&](const std::vector<double>& list) {
    return std::vector<double>(list.begin() + (begin - all.begin()),
                               list.begin() + (end - all.begin()));
  };
  return ProfileCurve({cut(knots_.parameter), cut(knots_.y), cut(knots_.z), cut(knots_.dy),
                       cut(knots_.dz), knots_.rounding});
}

ProfileCurve ProfileCurve::mirrored() const {
  ProfileKnots result = knots_;
  for (auto* list : {&result.parameter, &result.y, &result.z, &result.dy, &result.dz})
    std::reverse(list->begin(), list->end());
  for (auto* list : {&result.parameter, &result.y, &result.dz})
    for (double& value : *list) value = -value;
  return ProfileCurve(std::move(result));
}

Valley deepest_valley(const std::vector<double>& z) {
  std::vector<std::size_t> right(z.size());  // the highest place from each one on
  for (std::size_t k = z.size(); k-- > 0;)
    right[k] = k + 1 < z.size() && z[right[k + 1]] < z[k] ? right[k + 1] : k;
  Valley deepest;
  std::size_t left = 0;
  for (std::size_t k = 0; k < z.size(); ++k) {
    if (z[k] < z[left]) left = k;
    const double depth = z[k] - std::max(z[left], z[right[k]]);
    if (depth > deepest.depth) deepest = {k, left, right[k], depth};
  }
  return deepest;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double parameter_near(const ProfileCurve& curve, double y, double z) {
  const ProfileKnots& knots = curve.knots();
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < knots.y.size(); ++k) {
    const double square = (knots.y[k] - y) * (knots.y[k] - y) + (knots.z[k] - z) * (knots.z[k] - z);
    if (square < least) least = square, nearest = k;
  }
  return knots.parameter[nearest];
}

std::vector<double> dense_parameters(const ProfileCurve& curve, double step, double least) {
  std::vector<double> result;
  const std::vector<double>& knots = curve.knots().parameter;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    if (!result.empty() && knots[k] - result.back() < least) continue;
    const double length = knots[k + 1] - knots[k];
    const int parts =
        std::max(1, contact::count_of(std::ceil(length / step), "points along a profile"));
    for (int i = 0; i < parts; ++i) result.push_back(knots[k] + length * i / parts);
  }
  if (knots.back() - result.back() < least && result.size() > 1) result.pop_back();
  result.push_back(knots.back());
  return result;
}

contact::HeightCurve height_over_y(const ProfileCurve& curve, double parameter) {
  const double middle = std::clamp(parameter, curve.first(), curve.last());
  if (const ProfilePoint here = curve.at(middle); !usable(here))
    throw contact::SolveError(fmt::format(
        "the profile is steeper than 85 degrees at y = {:.4g} mm, where the bodies would "
        "touch; allowed: contact on parts that are heights over y; do: correct the "
        "profile, its rotation or mirror, or move the wheel",
        here.y));
  const auto& knots = curve.knots().parameter;
  // Knots of the usable part, searched outwards from the requested parameter.
  std::vector<double> places{middle};
  places.reserve(knots.size() + 3);
  const auto add_place = [&](double next) {
    const bool gentle = usable(curve.at(next));
    places.push_back(gentle ? next : steep_place(curve, places.back(), next));
    return gentle;
  };
  for (auto k = std::upper_bound(knots.begin(), knots.end(), middle); k != knots.end(); ++k)
    if (!add_place(*k)) break;
  std::reverse(places.begin(), places.end());
  for (auto k = std::lower_bound(knots.begin(), knots.end(), middle); k != knots.begin();)
    if (!add_place(*--k)) break;
  std::reverse(places.begin(), places.end());

  std::vector<double> y, z, slope;
  for (auto* list : {&y, &z, &slope}) list->reserve(2 * places.size());
  const auto add = [&](const ProfilePoint& point) {
    // Two points may coincide to rounding where the profile becomes too steep exactly at a knot.
    if (!y.empty() && !(point.y > y.back() + 1e-12 * (1.0 + std::abs(point.y)))) return;
    y.push_back(point.y);
    z.push_back(point.z);
    slope.push_back(point.tangent_z / point.tangent_y);
  };
  ProfilePoint before;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const ProfilePoint here = curve.at(places[k]);
    if (k > 0) {
      const int parts = subdivisions(before, here);
      for (int part = 1; part < parts; ++part)
        add(curve.at(places[k - 1] + (places[k] - places[k - 1]) * part / parts));
    }
    add(here);
    before = here;
  }
  return {std::move(y), std::move(z), std::move(slope)};
}

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

/// Parameter of the extreme height nearest to the knot.
ProfilePoint extreme(const ProfileCurve& curve, std::size_t knot) {
  const auto& p = curve.knots().parameter;
  const double low = p[knot > 0 ? knot - 1 : 0];
  const double high = p[std::min(knot + 1, p.size() - 1)];
  const bool rising = curve.at(low).tangent_z > 0.0;
  if (rising == (curve.at(high).tangent_z > 0.0)) return curve.at(p[knot]);
  return curve.at(contact::bracketed_root([&](double at) { return curve.at(at).tangent_z; }, low,
                                          high, last_digits, "extreme height of the profile"));
}

/// y at which z crosses a height, searching from parameter `from` towards smaller ones.
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
  std::size_t top = 0, bottom = 0;
  const auto sharper = [&](const ProfilePoint& place) {
    // Takes the first point of an arc, whose curvature is constant to rounding.
    constexpr double clearly = 1.0 + 1e-4;
    if (place.curvature > clearly * result.sharpest_up.curvature) result.sharpest_up = place;
    if (place.curvature < clearly * result.sharpest_down.curvature) result.sharpest_down = place;
  };
  for (std::size_t k = 0; k < n; ++k) {
    if (k + 1 < n) result.length += length_of(knots, k);
    if (knots.z[k] < knots.z[top]) top = k;
    if (knots.z[k] > knots.z[bottom]) bottom = k;
    const ProfilePoint right = curve.at(knots.parameter[k]);
    sharper(right);
    if (k == 0 || k + 1 == n) continue;
    const ProfilePoint left = before(curve, k);
    sharper(left);
    // Cubics of one formula agree within 1e-4 of their curvature; a joint differs much more.
    const double larger = std::max(std::abs(left.curvature), std::abs(right.curvature));
    if (std::abs(right.curvature - left.curvature) > 1e-4 + 0.05 * larger)
      result.joints.push_back({knots.parameter[k], right, left.curvature});
  }
  result.top = extreme(curve, top);
  result.bottom = extreme(curve, bottom);
  result.gauge_face = wheel ? face(curve, n - 1, 10.0) : face(curve, top, result.top.z + 14.0);
  return result;
}

double angle_of(const ProfilePoint& place) {
  constexpr double degrees = 180.0 / contact::pi;
  return std::atan2(place.tangent_z, place.tangent_y) * degrees;
}

std::vector<ProfileRow> profile_rows(const ProfileCurve& curve, bool wheel) {
  std::vector<ProfileRow> rows;
  const auto row = [&](double parameter, const ProfilePoint& place, double curvature) {
    rows.push_back({parameter, place.y, place.z, angle_of(place), curvature});
  };
  const auto joints = profile_features(curve, wheel).joints;
  const double length = curve.last() - curve.first();
  const int steps = contact::count_of(std::ceil(length / 0.1), "points along a profile");
  auto joint = joints.begin();
  for (int k = 0; k <= steps; ++k) {
    const double parameter = k == steps ? curve.last() : curve.first() + length * k / steps;
    for (; joint != joints.end() && joint->parameter <= parameter; ++joint) {
      row(joint->parameter, joint->place, joint->curvature_before);
      row(joint->parameter, joint->place, joint->place.curvature);
    }
    const ProfilePoint place = curve.at(parameter);
    row(parameter, place, place.curvature);
  }
  return rows;
}

}  // namespace rollfem::profiles

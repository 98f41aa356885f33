#include "profiles/formula_profiles.hpp"

#include "contact/base/errors.hpp"
#include "profiles/profile_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace rollfem::profiles {

namespace {

using contact::InputError;
using contact::ProfileSource;

/// A place with the sine of the tangent's angle, which is linear in y along an arc.
struct Station {
  double y = 0.0, z = 0.0, sine = 0.0;
};

double cosine(double sine) {
  return std::sqrt(std::max(0.0, 1.0 - sine * sine));
}

/// Along an arc of this signed curvature (1/mm, > 0 turns towards +z) to another y.
Station along(const Station& from, double curvature, double y) {
  const double sine = from.sine + curvature * (y - from.y);
  // z changes by (cos a - cos b) / k, written so that k = 0 is no exception.
  const double z = from.z + (y - from.y) * (from.sine + sine) / (cosine(from.sine) + cosine(sine));
  return {y, z, sine};
}

struct Arcs {
  std::vector<double> radii, ends;
};

/// Symmetric lists written out from small to large y.
Arcs whole(const ProfileSource& source) {
  if (!source.symmetric) return {source.radii, source.ends};
  Arcs result;
  result.radii.assign(source.radii.rbegin(), source.radii.rend());
  result.radii.insert(result.radii.end(), source.radii.begin() + 1, source.radii.end());
  for (auto end = source.ends.rbegin(); end != source.ends.rend(); ++end)
    result.ends.push_back(-*end);
  result.ends.insert(result.ends.end(), source.ends.begin(), source.ends.end());
  return result;
}

bool rising(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
}

void check_arcs(const ProfileSource& source, const std::string& name) {
  const std::size_t expected = source.radii.size() + (source.symmetric ? 0 : 1);
  if (source.radii.empty() || source.ends.size() != expected)
    throw InputError(fmt::format(
        "{}: profile by arcs with {} radii and {} ends; allowed: {}; do: complete the lists", name,
        source.radii.size(), source.ends.size(),
        source.symmetric ? "as many ends as radii, from the middle outwards"
                         : "one more end than radii, from small to large y"));
  const bool around = source.symmetric ? source.ends.front() > 0.0
                                       : source.ends.front() < 0.0 && source.ends.back() > 0.0;
  if (!rising(source.ends) || !around)
    throw InputError(fmt::format("{}: the ends of the arcs must increase{}; do: order them", name,
                                 source.symmetric ? " from above 0" : " from below 0 to above 0"));
  if (source.symmetric && source.slope != 0.0)
    throw InputError(fmt::format(
        "{}: slope = {} at y = 0 contradicts symmetric = true; do: remove one of the two", name,
        source.slope));
}

Station checked(const Station& station, double radius, const std::string& name) {
  if (std::abs(station.sine) <= 1.0 + 1e-9) return station;
  throw InputError(fmt::format(
      "{}: the arc of radius {} ends at y = {}, beyond its vertical tangent; allowed: ends that it "
      "can reach from the arcs before it; do: move the end towards the middle",
      name, radius, station.y));
}

void append(ProfileKnots& knots, const Station& from, const Station& to, double curvature) {
  if (curvature == 0.0) {
    append_line(knots, from.y, from.z, to.y, to.z);
    return;
  }
  const auto angle = [](double sine) { return std::asin(std::clamp(sine, -1.0, 1.0)); };
  const double cos_from = cosine(from.sine);
  append_piece(
      knots,
      [=](double a) {
        return PiecePoint{from.y + (std::sin(a) - from.sine) / curvature,
                          from.z + (cos_from - std::cos(a)) / curvature, std::cos(a) / curvature,
                          std::sin(a) / curvature};
      },
      angle(from.sine), angle(to.sine));
}

double horner(const double* coefficients, std::size_t count, double y, double& slope) {
  double value = 0.0;
  slope = 0.0;
  for (std::size_t k = count; k-- > 0;) {
    slope = slope * y + value;
    value = value * y + coefficients[k];
  }
  return value;
}

void check_joint(const double* left, std::size_t count, double y, const std::string& name) {
  constexpr double largest_step = 1e-6;  // mm
  constexpr double largest_kink = 1e-5;  // of the slope
  double slope_left = 0.0, slope_right = 0.0;
  const double step =
      horner(left + count, count, y, slope_right) - horner(left, count, y, slope_left);
  const double kink = slope_right - slope_left;
  if (std::abs(step) <= largest_step && std::abs(kink) <= largest_kink) return;
  throw InputError(fmt::format(
      "{}: the polynomials do not meet at y = {}: step of {:.3g} mm, slopes differ by {:.3g}; "
      "allowed: {} mm and {}; do: give the coefficients with more digits",
      name, y, step, kink, largest_step, largest_kink));
}

}  // namespace

ProfileCurve arc_profile_curve(const ProfileSource& source, bool wheel, const std::string& name) {
  check_arcs(source, name);
  const Arcs arcs = whole(source);
  // Convex is towards +z for the rail, whose inside is below, and towards -z for the wheel.
  std::vector<double> curvature;
  for (const double radius : arcs.radii) curvature.push_back((wheel ? -1.0 : 1.0) / radius);
  const auto above = std::upper_bound(arcs.ends.begin(), arcs.ends.end(), 0.0);
  const auto middle = static_cast<std::size_t>(above - arcs.ends.begin()) - 1;
  Station station{0.0, 0.0, source.slope / std::hypot(1.0, source.slope)};
  std::vector<Station> stations(arcs.ends.size());
  for (std::size_t k = middle; k + 1 > 0; --k) {
    station = checked(along(station, curvature[k], arcs.ends[k]), arcs.radii[k], name);
    stations[k] = station;
  }
  station = {0.0, 0.0, source.slope / std::hypot(1.0, source.slope)};
  for (std::size_t k = middle + 1; k < stations.size(); ++k) {
    station = checked(along(station, curvature[k - 1], arcs.ends[k]), arcs.radii[k - 1], name);
    stations[k] = station;
  }
  ProfileKnots knots;
  for (std::size_t k = 0; k < curvature.size(); ++k)
    append(knots, stations[k], stations[k + 1], curvature[k]);
  return ProfileCurve(std::move(knots));
}

ProfileCurve polynomial_profile_curve(const ProfileSource& source, const std::string& name) {
  const std::size_t pieces = source.limits.empty() ? 0 : source.limits.size() - 1;
  if (pieces == 0 || source.coefficients.empty() || source.coefficients.size() % pieces != 0)
    throw InputError(
        fmt::format("{}: profile by polynomials with {} coefficients and {} limits; allowed: one "
                    "more limit than pieces, and the same number of coefficients for each piece (0 "
                    "where there is none); do: complete the lists",
                    name, source.coefficients.size(), source.limits.size()));
  if (!rising(source.limits))
    throw InputError(
        fmt::format("{}: the limits of the polynomials must increase; do: order them", name));
  const std::size_t count = source.coefficients.size() / pieces;
  ProfileKnots knots;
  for (std::size_t k = 0; k < pieces; ++k) {
    const double* coefficients = source.coefficients.data() + k * count;
    if (k + 1 < pieces) check_joint(coefficients, count, source.limits[k + 1], name);
    append_piece(
        knots,
        [=](double y) {
          PiecePoint point{y, 0.0, 1.0, 0.0};
          point.z = horner(coefficients, count, y, point.dz);
          return point;
        },
        source.limits[k], source.limits[k + 1]);
  }
  return ProfileCurve(std::move(knots));
}

}  // namespace rollfem::profiles

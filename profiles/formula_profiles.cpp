// SPDX-License-Identifier: LGPL-2.1-or-later
#include "profiles/formula_profiles.hpp"

#include "base/count.hpp"
#include "base/errors.hpp"
#include "scene/height_curve.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

namespace rollfem::profiles {

namespace {

using contact::InputError;
using contact::ProfileSource;
using Knots = std::vector<ProfileKnot>;

/// Point of a piece (arc, polynomial) at its local parameter, with derivatives by that parameter.
struct PiecePoint {
  double y = 0.0, z = 0.0;
  double dy = 0.0, dz = 0.0;
};

/// Spacing of knots along the profile, mm, dense enough for the cubics between them: a circle of
/// 10 mm is represented within 1e-11 mm and its curvature within 2e-6.
constexpr double knot_distance = 0.05;

double arc_length(const std::function<PiecePoint(double)>& piece, double from, double to) {
  const auto speed = [&](double t) {
    const PiecePoint point = piece(t);
    return std::hypot(point.dy, point.dz);
  };
  return std::abs(boost::math::quadrature::gauss<double, 5>::integrate(speed, from, to));
}

ProfileKnot knot_at(double parameter, const PiecePoint& point, double direction) {
  const double speed = direction * std::hypot(point.dy, point.dz);
  return {parameter, point.y, point.z, point.dy / speed, point.dz / speed};
}

/// Value and slope at y of a polynomial, lowest power first.
std::array<double, 2> polynomial(const double* coefficients, std::size_t count, double y) {
  double value = 0.0, slope = 0.0;
  for (std::size_t k = count; k-- > 0;) {
    slope = slope * y + value;
    value = value * y + coefficients[k];
  }
  return {value, slope};
}

/// Adds a piece between two of its parameters, starting at the end of the previous piece.
void append_piece(Knots& knots, const std::function<PiecePoint(double)>& piece, double from,
                  double to, double distance = knot_distance) {
  const double direction = to > from ? 1.0 : -1.0;
  if (knots.empty()) knots.push_back(knot_at(0.0, piece(from), direction));
  double length = 0.0;
  constexpr int parts = 16;
  for (int k = 0; k < parts; ++k)
    length +=
        arc_length(piece, from + (to - from) * k / parts, from + (to - from) * (k + 1) / parts);
  const int steps =
      std::max(2, contact::count_of(std::ceil(length / distance),
                                    "points along a profile (ends, limits, coefficients)"));
  double before = from;
  for (int k = 1; k <= steps; ++k) {
    const double here = k == steps ? to : from + (to - from) * k / steps;
    knots.push_back(
        knot_at(knots.back().parameter + arc_length(piece, before, here), piece(here), direction));
    before = here;
  }
}

/// A point with the sine of the tangent's angle, which is linear in y along an arc.
struct Station {
  double y = 0.0, z = 0.0, sine = 0.0;
};

double cosine(double sine) {
  return std::sqrt(std::max(0.0, 1.0 - sine * sine));
}

/// Along an arc of this signed curvature (1/mm, > 0 turns towards +z) to another y.
Station along(const Station& from, double curvature, double y) {
  const double sine = from.sine + curvature * (y - from.y);
  // z changes by (cos a - cos b) / k, written so that k = 0 needs no special case.
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
  throw InputError(
      fmt::format("{}: the arc of radius {} ends at y = {}, beyond its vertical tangent; allowed: "
                  "an end before the vertical tangent; do: move the end towards the middle",
                  name, radius, station.y));
}

void append_arc(Knots& knots, const Station& from, const Station& to, double curvature) {
  if (curvature == 0.0) {
    const double dy = to.y - from.y, dz = to.z - from.z;
    append_piece(
        knots,
        [=](double t) {
          return PiecePoint{from.y + t * dy, from.z + t * dz, dy, dz};
        },
        0.0, 1.0);
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

void check_joint(const double* left, std::size_t count, double y, const std::string& name) {
  constexpr double largest_step = 1e-6;  // mm
  constexpr double largest_kink = 1e-5;  // of the slope
  const auto before = polynomial(left, count, y), after = polynomial(left + count, count, y);
  const double step = after[0] - before[0], kink = after[1] - before[1];
  if (std::abs(step) <= largest_step && std::abs(kink) <= largest_kink) return;
  throw InputError(fmt::format(
      "{}: the polynomials do not meet at y = {}: step of {:.3g} mm, slopes differ by {:.3g}; "
      "allowed: {} mm and {}; do: give the coefficients with more digits",
      name, y, step, kink, largest_step, largest_kink));
}

/// Sine of the angle of the side of a rail head, 1:20 off the vertical.
const double side_sine = std::sin(std::atan(20.0));

/// Symmetric head of tangent arcs: radii from the middle outwards, and the widths at which all but
/// the last end, as drawings give them; then the side down to `deepest` below the crown (mm).
struct RailHead {
  std::vector<double> radii, widths;
  double deepest;
};

ProfileCurve curve_of(const RailHead& rail) {
  ProfileSource head;
  head.symmetric = true;
  head.radii = rail.radii;
  Station at;
  for (std::size_t k = 0; k < rail.radii.size(); ++k) {
    const double end = k < rail.widths.size() ? 0.5 * rail.widths[k]
                                              : at.y + rail.radii[k] * (side_sine - at.sine);
    at = along(at, 1.0 / rail.radii[k], end);
    head.ends.push_back(end);
  }
  head.radii.push_back(HUGE_VAL);
  head.ends.push_back(at.y + (rail.deepest - at.z) / 20.0);
  return arc_profile_curve(head, false, "rail");
}

// EN 13674-1:2017, annex A; docs/profiles.md says how these numbers were checked. The sides end
// where they meet the underside of the head.
ProfileCurve rail_54e1() {
  return curve_of({{300.0, 80.0, 13.0}, {20.024, 49.727}, 36.2});
}
ProfileCurve rail_56e1() {
  return curve_of({{305.0, 80.0, 12.7}, {11.787, 51.235}, 36.1});
}
ProfileCurve rail_60e1() {
  return curve_of({{300.0, 80.0, 13.0}, {20.456, 52.053}, 37.5});
}
ProfileCurve rail_60e2() {
  return curve_of({{200.0, 70.0, 16.0, 8.0}, {23.778, 48.913, 70.774}, 37.5});
}

/// A 21 mm band at the top and a head 72 mm wide where the side begins fit the benchmark's list of
/// points within 4.4e-5 mm.
ProfileCurve rail_uic60_manchester() {
  const double top = 0.5 * 21.0, side = 0.5 * 72.0, sine = top / 300.0;
  // Both joints at the sides of the middle arc are tangent.
  const double joint = (side - top + 80.0 * sine - 13.0 * side_sine) / (80.0 - 13.0);
  return curve_of({{300.0, 80.0, 13.0}, {2.0 * top, 2.0 * (top + 80.0 * (joint - sine))}, 37.5});
}

// Wheel S1002. Its zones H to A are printed with ten digits. In zone C the large coefficients leave
// an uncertainty of up to 2e-4 mm, so that its ends differ from the neighbouring zones by 1.2e-4 mm
// (y = -35) and 3.7e-5 mm (y = -26); all other ends agree within 6e-7 mm. A step would be a kink
// for the contact, so a cubic is added to the formula of every zone to make value and slope
// continuous at its ends; its curvature is negligible (5e-6 /mm in zone C).

struct Zone {
  double from = 0.0, to = 0.0;  ///< mm, of y
  /// Circles: centre, radius, and whether z = centre + root (+1) or centre - root (-1). Radius 0: a
  /// polynomial.
  double centre_y = 0.0, centre_z = 0.0, radius = 0.0, sign = 0.0;
  std::array<double, 9> coefficients{};
};

// Zone limits and coefficients: EN 13715 / UIC 510-2 as coded by H. Netter (DLR); docs/profiles.md.
constexpr std::array<Zone, 8> zones{{
    {-70.0, -62.764705882, -49.5, 9.519259302, 20.5, 1.0, {}},
    {-62.764705882, -49.662510381, -55.0, 16.0, 12.0, 1.0, {}},
    {-49.662510381, -39.764473993, -58.558326413, 8.834924130, 20.0, 1.0, {}},
    {-39.764473993, -38.426669071, 0, 0, 0, 0, {-93.576667419, -2.747477419}},
    {-38.426669071, -35.0, -26.210665, 16.446, 13.0, -1.0, {}},
    {-35.0,
     -26.0,
     0,
     0,
     0,
     0,
     {-4.320221063e3, -1.038384026e3, -1.065501873e2, -6.051367875, -2.054332446e-1,
      -4.169739389e-3, -4.687195829e-5, -2.252755540e-7}},
    {-26.0,
     32.15796,
     0,
     0,
     0,
     0,
     {0.0, -3.358537058e-2, 1.565681624e-3, -2.810427944e-5, 5.844240864e-8, -1.562379023e-8,
      5.309217349e-15, -5.957839843e-12, 2.646656573e-13}},
    {32.15796, 60.0, 0, 0, 0, 0, {1.364323640, -0.066666667}},
}};
constexpr std::size_t zone_c = 5;

/// A point on the formula of a zone. The parameter of a polynomial is y, that of a circle the
/// angle: the back of the flange is vertical at its end.
PiecePoint point_of(const Zone& zone, double parameter) {
  if (zone.radius > 0.0) {
    const double dy = zone.radius * std::cos(parameter), dz = zone.radius * std::sin(parameter);
    return {zone.centre_y + dz, zone.centre_z + zone.sign * dy, dy, -zone.sign * dz};
  }
  const auto [z, slope] = polynomial(zone.coefficients.data(), zone.coefficients.size(), parameter);
  return {parameter, z, 1.0, slope};
}

double parameter_at(const Zone& zone, double y) {
  if (zone.radius == 0.0) return y;
  return std::asin(std::clamp((y - zone.centre_y) / zone.radius, -1.0, 1.0));
}

/// Height and slope by the formula of a zone.
contact::CurveValue formula(const Zone& zone, double y) {
  const PiecePoint point = point_of(zone, parameter_at(zone, y));
  return {point.z, point.dz / point.dy, 0.0};
}

/// Mismatch of the zone at one of its ends. Only zone C is moved at its ends; other neighbours meet
/// halfway.
contact::CurveValue to_neighbour(std::size_t zone, bool right, bool move_c) {
  const std::size_t other = right ? zone + 1 : zone - 1;
  const double y = right ? zones[zone].to : zones[zone].from;
  double share = 0.5;
  if (zone == zone_c) share = move_c ? 1.0 : 0.0;
  if (other == zone_c) share = 0.0;
  const contact::CurveValue mine = formula(zones[zone], y), its = formula(zones[other], y);
  return {share * (its.value - mine.value), share * (its.slope - mine.slope), 0.0};
}

/// The cubic that is added to the formula of a zone.
contact::HeightCurve correction(std::size_t zone, bool move_c) {
  contact::CurveValue left, right;
  if (zone > 0) left = to_neighbour(zone, false, move_c);
  if (zone + 1 < zones.size()) right = to_neighbour(zone, true, move_c);
  return contact::HeightCurve(
      {{zones[zone].from, left.value, left.slope}, {zones[zone].to, right.value, right.slope}});
}

/// Between two points of the Manchester list, the step at an end of zone C is blended from the left
/// formula to the right one with continuous curvature.
struct Blend {
  double from = 0.0, to = 0.0;
  std::size_t left = 0;
};
constexpr std::array<Blend, 2> blends{{{-35.169, -34.944, zone_c - 1}, {-26.211, -25.897, zone_c}}};

PiecePoint blended(const Blend& blend, double y) {
  const double h = blend.to - blend.from;
  const double t = (y - blend.from) / h;
  const double step = t * t * t * (10.0 + t * (-15.0 + 6.0 * t));
  const double rate = 30.0 * t * t * (1.0 - t) * (1.0 - t) / h;
  const contact::CurveValue left = formula(zones[blend.left], y),
                            right = formula(zones[blend.left + 1], y);
  const double higher = right.value - left.value;
  return {y, left.value + step * higher, 1.0,
          left.slope + step * (right.slope - left.slope) + rate * higher};
}

/// Part of a zone.
void append_zone(Knots& knots, std::size_t index, double from, double to, bool move_c) {
  const Zone& zone = zones[index];
  const contact::HeightCurve more = correction(index, move_c);
  append_piece(
      knots,
      [&](double parameter) {
        PiecePoint point = point_of(zone, parameter);
        const contact::CurveValue change = more.at(point.y);
        point.z += change.value;
        point.dz += change.slope * point.dy;
        return point;
      },
      parameter_at(zone, from), parameter_at(zone, to));
}

/// Wheel S1002. `smooth`: zone C is moved to its neighbours as a whole, by up to 1.2e-4 mm (within
/// the uncertainty of its printed digits), and the curvature follows the formulas. Otherwise the
/// formulas hold everywhere except within 0.23 mm about y = -35 and 0.31 mm about y = -26, where
/// their steps are blended.
ProfileCurve s1002(bool smooth) {
  Knots knots;
  for (std::size_t k = 0; k < zones.size(); ++k) {
    double from = zones[k].from;
    double to = zones[k].to;
    if (!smooth)
      for (const Blend& blend : blends) {
        if (blend.left == k) to = blend.from;
        if (blend.left + 1 == k) from = blend.to;
      }
    append_zone(knots, k, from, to, smooth);
    if (smooth) continue;
    for (const Blend& blend : blends)
      if (blend.left == k)
        append_piece(
            knots, [&blend](double y) { return blended(blend, y); }, blend.from, blend.to,
            0.2 * knot_distance);
  }
  return ProfileCurve(std::move(knots));
}

}  // namespace

ProfileCurve arc_profile_curve(const ProfileSource& source, bool wheel, const std::string& name) {
  check_arcs(source, name);
  const Arcs arcs = whole(source);
  // Convex means curved towards +z for the rail, whose material is below, and towards -z for the
  // wheel.
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
  Knots knots;
  for (std::size_t k = 0; k < curvature.size(); ++k)
    append_arc(knots, stations[k], stations[k + 1], curvature[k]);
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
  Knots knots;
  for (std::size_t k = 0; k < pieces; ++k) {
    const double* coefficients = source.coefficients.data() + k * count;
    if (k + 1 < pieces) check_joint(coefficients, count, source.limits[k + 1], name);
    append_piece(
        knots,
        [=](double y) {
          const auto [z, slope] = polynomial(coefficients, count, y);
          return PiecePoint{y, z, 1.0, slope};
        },
        source.limits[k], source.limits[k + 1]);
  }
  return ProfileCurve(std::move(knots));
}

const std::vector<BuiltInProfile>& built_in_profiles() {
  static const std::vector<BuiltInProfile> profiles{
      {"S1002", true, "wheel of EN 13715 and UIC 510-2, h 28, e 32.5", [] { return s1002(false); }},
      {"S1002-smooth", true, "S1002 with zone C moved by up to 1.2e-4 mm to meet its neighbours",
       [] { return s1002(true); }},
      {"60E1", false, "rail head of EN 13674-1, not inclined", &rail_60e1},
      {"UIC60", false, "the same as 60E1", &rail_60e1},
      {"UIC60-manchester", false, "rail head of the Manchester contact benchmark, not inclined",
       &rail_uic60_manchester},
      {"60E2", false, "rail head of EN 13674-1, not inclined", &rail_60e2},
      {"54E1", false, "rail head of EN 13674-1, not inclined", &rail_54e1},
      {"UIC54", false, "the same as 54E1", &rail_54e1},
      {"56E1", false, "rail head of EN 13674-1, not inclined", &rail_56e1},
      {"BS113A", false, "the same as 56E1 (BS 113 lb, BR variant)", &rail_56e1},
  };
  return profiles;
}

const BuiltInProfile* find_built_in_profile(const std::string& name) {
  for (const BuiltInProfile& profile : built_in_profiles())
    if (profile.name == name) return &profile;
  return nullptr;
}

double s1002_height(double y) {
  for (const Zone& zone : zones)
    if (y >= zone.from && y <= zone.to) return formula(zone, y).value;
  throw std::out_of_range("S1002 reaches from y = -70 to 60 mm");
}

}  // namespace rollfem::profiles

// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheel S1002. Its zones H to A are printed with ten digits. In zone C the large coefficients leave
// an uncertainty of up to 2e-4 mm, so that its ends differ from the neighbouring zones by 1.2e-4 mm
// (y = -35) and 3.7e-5 mm (y = -26); all other ends agree within 6e-7 mm. A step would be a kink
// for the contact, so a cubic is added to the formula of every zone to make value and slope
// continuous at its ends; its curvature is negligible (5e-6 /mm in zone C).
#include "contact/scene/height_curve.hpp"
#include "profiles/formula_profiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace rollfem::profiles {

namespace {

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
  return {{zones[zone].from, zones[zone].to}, {left.value, right.value}, {left.slope, right.slope}};
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
void append_zone(ProfileKnots& knots, std::size_t index, double from, double to, bool move_c) {
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

}  // namespace

double s1002_height(double y) {
  for (const Zone& zone : zones)
    if (y >= zone.from && y <= zone.to) return formula(zone, y).value;
  throw std::out_of_range("S1002 reaches from y = -70 to 60 mm");
}

ProfileCurve s1002(bool smooth) {
  ProfileKnots knots;
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

}  // namespace rollfem::profiles

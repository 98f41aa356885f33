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

/// Height and slope of a formula.
struct Height {
  double z = 0.0;
  double slope = 0.0;
};

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

Height formula(const Zone& zone, double y) {
  if (zone.radius > 0.0) {
    const double d = y - zone.centre_y;
    const double root = std::sqrt(std::max(0.0, zone.radius * zone.radius - d * d));
    return {zone.centre_z + zone.sign * root, -zone.sign * d / root};
  }
  const auto [z, slope] = polynomial(zone.coefficients.data(), zone.coefficients.size(), y);
  return {z, slope};
}

/// Mismatch of the zone at one of its ends. Only zone C is moved at its ends; other neighbours meet
/// halfway.
Height to_neighbour(std::size_t zone, bool right, bool move_c) {
  const std::size_t other = right ? zone + 1 : zone - 1;
  const double y = right ? zones[zone].to : zones[zone].from;
  double share = 0.5;
  if (zone == zone_c) share = move_c ? 1.0 : 0.0;
  if (other == zone_c) share = 0.0;
  const Height mine = formula(zones[zone], y);
  const Height its = formula(zones[other], y);
  return {share * (its.z - mine.z), share * (its.slope - mine.slope)};
}

/// The cubic that is added to the formula of a zone.
contact::HeightCurve correction(std::size_t zone, bool move_c) {
  Height left, right;
  if (zone > 0) left = to_neighbour(zone, false, move_c);
  if (zone + 1 < zones.size()) right = to_neighbour(zone, true, move_c);
  return {{zones[zone].from, zones[zone].to}, {left.z, right.z}, {left.slope, right.slope}};
}

/// Between two points of the Manchester list, the step at an end of zone C is blended from the left
/// formula to the right one with continuous curvature.
struct Blend {
  double from = 0.0, to = 0.0;
  std::size_t left = 0;
};
constexpr std::array<Blend, 2> blends{{{-35.169, -34.944, zone_c - 1}, {-26.211, -25.897, zone_c}}};

Height blended(const Blend& blend, double y) {
  const double h = blend.to - blend.from;
  const double t = (y - blend.from) / h;
  const double step = t * t * t * (10.0 + t * (-15.0 + 6.0 * t));
  const double rate = 30.0 * t * t * (1.0 - t) * (1.0 - t) / h;
  const Height left = formula(zones[blend.left], y);
  const Height right = formula(zones[blend.left + 1], y);
  return {left.z + step * (right.z - left.z),
          left.slope + step * (right.slope - left.slope) + rate * (right.z - left.z)};
}

/// Part of a zone; circles are parametrised by angle (the back of the flange is vertical at its
/// end).
void append_zone(ProfileKnots& knots, std::size_t index, double from, double to, bool move_c) {
  const Zone& zone = zones[index];
  const contact::HeightCurve more = correction(index, move_c);
  if (zone.radius == 0.0) {
    append_piece(
        knots,
        [&](double y) {
          const Height height = formula(zone, y);
          const contact::CurveValue change = more.at(y);
          return PiecePoint{y, height.z + change.value, 1.0, height.slope + change.slope};
        },
        from, to);
    return;
  }
  const auto angle = [&zone](double y) {
    return std::asin(std::clamp((y - zone.centre_y) / zone.radius, -1.0, 1.0));
  };
  append_piece(
      knots,
      [&](double a) {
        const double y = zone.centre_y + zone.radius * std::sin(a);
        const contact::CurveValue change = more.at(y);
        const double dy = zone.radius * std::cos(a);
        return PiecePoint{y, zone.centre_z + zone.sign * zone.radius * std::cos(a) + change.value,
                          dy, -zone.sign * zone.radius * std::sin(a) + change.slope * dy};
      },
      angle(from), angle(to));
}

}  // namespace

double s1002_height(double y) {
  for (const Zone& zone : zones)
    if (y >= zone.from && y <= zone.to) return formula(zone, y).z;
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
            knots,
            [&blend](double y) {
              const Height height = blended(blend, y);
              return PiecePoint{y, height.z, 1.0, height.slope};
            },
            blend.from, blend.to, 0.2 * knot_distance);
  }
  return ProfileCurve(std::move(knots));
}

}  // namespace rollfem::profiles

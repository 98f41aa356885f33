// SPDX-License-Identifier: LGPL-2.1-or-later
// Patches of known bodies in the patch frame: spheres and tori whose contact the radii give too,
// and S1002 on the Manchester benchmark's UIC60 from their published arcs and polynomial.
#pragma once

#include "case/case.hpp"
#include "scene/patch_geometry.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

/// Height, slope of a curve.
struct HeightAndSlope {
  double value;
  double slope;
};
using CurveFunction = std::function<HeightAndSlope(double)>;

inline contact::HeightCurve sampled_curve(double first, double last, double step,
                                          const CurveFunction& function) {
  std::vector<contact::HeightKnot> knots;
  const int pieces = static_cast<int>(std::ceil((last - first) / step));
  for (int k = 0; k <= pieces; ++k) {
    const double at = first + (last - first) * k / pieces;
    const auto [value, rise] = function(at);
    knots.push_back({at, value, rise});
  }
  return contact::HeightCurve(knots);
}

/// z = R - sqrt(R^2 - (y - y0)^2): a circle through (y0, 0) that opens upwards; R < 0 downwards.
inline HeightAndSlope circle(double radius, double y) {
  if (!std::isfinite(radius)) return {0.0, 0.0};
  const double root = std::sqrt(radius * radius - y * y);
  const double sign = radius > 0.0 ? 1.0 : -1.0;
  return {sign * y * y / (std::abs(radius) + root), sign * y / root};
}

/// Wheel of a rolling radius with a circular profile on a rail with one, both level at the contact:
/// convex radii > 0 as in the case file. Profiles known to `reach` on both sides.
inline contact::PatchGeometry circle_pair(double rolling_radius, double wheel_radius,
                                          double rail_radius, double reach = 20.0) {
  const auto rail =
      sampled_curve(-reach, reach, 0.05, [&](double y) { return circle(-rail_radius, y); });
  const auto wheel = sampled_curve(-reach, reach, 0.05, [&](double w) {
    const auto [value, slope] = circle(-wheel_radius, w);
    return HeightAndSlope{rolling_radius + value, slope};
  });
  return {rail, wheel, {{0.0, 0.0, rolling_radius}, {0.0, 1.0, 0.0}}, -reach, reach};
}

inline std::shared_ptr<const contact::PatchGeometry> circles(double rolling_radius,
                                                             double wheel_radius,
                                                             double rail_radius,
                                                             double reach = 25.0) {
  return std::make_shared<contact::PatchGeometry>(
      circle_pair(rolling_radius, wheel_radius, rail_radius, reach));
}

/// A sphere of that radius about a point of the axle: whatever the axle's direction, one surface.
inline contact::PatchGeometry sphere_on_circle(double radius, double rail_radius,
                                               const contact::Vector3& axle, double reach = 20.0) {
  const auto rail =
      sampled_curve(-reach, reach, 0.05, [&](double y) { return circle(-rail_radius, y); });
  const double width = std::min(0.99 * radius, radius * std::abs(axle[2]) + 3.0 * reach);
  const auto wheel = sampled_curve(-width, width, 0.1, [&](double w) {
    const double height = std::sqrt(radius * radius - w * w);
    return HeightAndSlope{height, -w / height};
  });
  return {rail, wheel, {{0.0, 0.0, radius}, axle}, -reach, reach};
}

/// Zone B of S1002 (y from -26 to 32.16) and A (to 60): z outward over y, mm.
inline HeightAndSlope s1002_tread(double y) {
  if (y > 32.15796) return {1.364323640 - 0.066666667 * y, -0.066666667};
  constexpr double c[] = {0.0,
                          -3.358537058e-2,
                          1.565681624e-3,
                          -2.810427944e-5,
                          5.844240864e-8,
                          -1.562379023e-8,
                          5.309217349e-15,
                          -5.957839843e-12,
                          2.646656573e-13};
  double value = 0.0, slope = 0.0;
  for (int k = 8; k >= 0; --k) {
    slope = slope * y + value;
    value = value * y + c[k];
  }
  return {value, slope};
}

/// Head of the rail as in the Manchester benchmark, upright: z down over y, R300 to 10.5 mm, R80 to
/// 25.99 mm.
inline HeightAndSlope manchester_head(double y) {
  const double distance = std::abs(y);
  const double sign = y < 0.0 ? -1.0 : 1.0;
  if (distance <= 10.5) {
    const auto [value, slope] = circle(300.0, y);
    return {value, slope};
  }
  const auto [value, slope] = circle(80.0, distance - 7.7);
  return {80.134791 - 80.0 + value, sign * slope};
}

/// A rail's curve z down over y touches a wheel's z outward over y (radius R0 at y = 0), at these
/// places: slopes are made to agree by turning the axle.
inline std::shared_ptr<const contact::PatchGeometry> touching(
    const CurveFunction& rail, double rail_first, double rail_last, double rail_place,
    const CurveFunction& wheel, double wheel_first, double wheel_last, double wheel_place,
    double rolling_radius) {
  const auto [rail_z, rail_slope] = rail(rail_place);
  const double c = 1.0 / std::sqrt(1.0 + rail_slope * rail_slope);
  const double s = rail_slope * c;
  std::vector<contact::HeightKnot> knots;
  for (double at = rail_first; at <= rail_last; at += 0.02) {
    const auto [value, rise] = rail(at);
    const double across = at - rail_place;
    const double up = rail_z - value;
    knots.push_back({c * across - s * up, s * across + c * up, (s - c * rise) / (c + s * rise)});
  }
  const auto radius = sampled_curve(wheel_first, wheel_last, 0.02, [&](double w) {
    const auto [value, rise] = wheel(w);
    return HeightAndSlope{rolling_radius + value, rise};
  });
  const auto [wheel_z, wheel_slope] = wheel(wheel_place);
  const double cosine = 1.0 / std::sqrt(1.0 + wheel_slope * wheel_slope);
  const double sine = wheel_slope * cosine;
  const double r = rolling_radius + wheel_z;
  const contact::Axle axle{
      {0.0, -wheel_place * cosine - r * sine, -wheel_place * sine + r * cosine},
      {0.0, cosine, sine}};
  return std::make_shared<contact::PatchGeometry>(contact::HeightCurve(knots), radius, axle, -40.0,
                                                  40.0);
}

/// Head of the rail inclined 1:40 towards negative y as in the list of the Manchester benchmark.
/// `place`: profile coordinate of the contact in the inclined frame, less than 3 mm: on R300.
inline double upright_place(double place) {
  // Slope of R300 at the point: 1/40 more than inclined.
  return 300.0 * std::sin(std::asin((place - 0.0060) / 300.0) + std::atan(1.0 / 40.0));
}

/// Left wheel S1002, R0 = 450 mm, on UIC60 inclined 1:40: contact at these profile coordinates.
inline std::shared_ptr<const contact::PatchGeometry> s1002_on_uic60(double rail_place,
                                                                    double wheel_place) {
  return touching(manchester_head, -25.9, 25.9, upright_place(rail_place), s1002_tread, -26.0, 60.0,
                  wheel_place, 450.0);
}

}  // namespace rollfem::testing

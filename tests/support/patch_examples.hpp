// Patch geometries in closed form for tests: circles and spheres given as profile curves.
#pragma once

#include "contact/scene/patch_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rollfem::testing {

/// Knots of a function value(y) with slope(y), `step` apart.
template <class Value, class Slope>
contact::HeightCurve sampled_curve(double from, double to, double step, const Value& value,
                                   const Slope& slope) {
  std::vector<double> y, z, dz;
  const int count = static_cast<int>(std::lround((to - from) / step));
  for (int k = 0; k <= count; ++k) {
    const double at = from + (to - from) * k / count;
    y.push_back(at);
    z.push_back(value(at));
    dz.push_back(slope(at));
  }
  return {y, z, dz};
}

/// Depth below the top of a circle of signed radius (> 0 convex) and its slope.
inline double circle_drop(double radius, double y) {
  const double r = std::abs(radius);
  return std::copysign(y * y / (r + std::sqrt(r * r - y * y)), radius);
}
inline double circle_slope(double radius, double y) {
  const double r = std::abs(radius);
  return std::copysign(1.0, radius) * y / std::sqrt(r * r - y * y);
}

/// Wheel and rail of a case with radii, as curves; the axle is parallel to the rail's surface.
inline contact::PatchGeometry circle_pair(double rolling_radius, double wheel_radius,
                                          double rail_radius, double half_width = 20.0) {
  const auto rail = sampled_curve(
      -half_width, half_width, 0.1, [&](double y) { return -circle_drop(rail_radius, y); },
      [&](double y) { return -circle_slope(rail_radius, y); });
  const auto wheel = sampled_curve(
      -half_width, half_width, 0.1,
      [&](double w) { return rolling_radius - circle_drop(wheel_radius, w); },
      [&](double w) { return -circle_slope(wheel_radius, w); });
  return {rail, wheel, {{0.0, 0.0, rolling_radius}, {0.0, 1.0, 0.0}}, -half_width, half_width};
}

/// A sphere of that radius about a point of the axle: whatever the axle's direction, one surface.
inline contact::PatchGeometry sphere_on_circle(double radius, double rail_radius,
                                               const contact::Vector3& axle,
                                               double half_width = 20.0) {
  const auto rail = sampled_curve(
      -half_width, half_width, 0.1, [&](double y) { return -circle_drop(rail_radius, y); },
      [&](double y) { return -circle_slope(rail_radius, y); });
  const double reach = std::min(0.99 * radius, radius * std::abs(axle[2]) + 3.0 * half_width);
  const auto wheel = sampled_curve(
      -reach, reach, 0.1, [&](double w) { return std::sqrt(radius * radius - w * w); },
      [&](double w) { return -w / std::sqrt(radius * radius - w * w); });
  return {rail, wheel, {{0.0, 0.0, radius}, axle}, -half_width, half_width};
}

}  // namespace rollfem::testing

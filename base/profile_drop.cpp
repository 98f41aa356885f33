// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/profile_drop.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

ProfileDrop profile_drop(double transverse_radius, double y, double round_to) {
  if (!std::isfinite(transverse_radius)) return {};
  const double radius = std::abs(transverse_radius);
  const double sign = transverse_radius > 0 ? 1.0 : -1.0;
  const double distance = std::min(std::abs(y), round_to * radius);
  const double root = std::sqrt(1.0 - (distance / radius) * (distance / radius));
  const double slope = distance / (radius * root);
  // y^2 / (R + sqrt(R^2 - y^2)) rather than R - sqrt(R^2 - y^2): no cancellation.
  const double drop =
      distance * distance / (radius * (1.0 + root)) + slope * (std::abs(y) - distance);
  return {sign * drop, sign * (y < 0 ? -slope : slope)};
}

double circle_drop(double radius, double x) {
  return std::isfinite(radius)
             ? x * x / (radius + std::copysign(std::sqrt(radius * radius - x * x), radius))
             : 0.0;
}

}  // namespace rollfem::contact

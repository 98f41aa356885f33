// SPDX-License-Identifier: LGPL-2.1-or-later
// A cylindrical wheel over two humps of a rail: two patches of Hertz, or a patch and a near miss.
#pragma once

#include "support/patch_case.hpp"
#include "support/profile_patches.hpp"
#include "support/test.hpp"
#include "support/thesis_cases.hpp"

namespace rollfem::testing {

constexpr double hump_radius = 80.0, wheel_over_humps = 460.0;  // mm

/// Humps at +-half_distance (mm); that at larger y is lower by `lower` (mm).
inline PatchCase two_humps(double lower, double force, double half_distance = 15.0) {
  const double crest = half_distance * half_distance / (2.0 * hump_radius);
  const double reach = 2.0 * half_distance;
  const auto rail = sampled_curve(-reach, reach, 0.05, [&](double y) {
    const double across = std::abs(y) - half_distance;
    const double drop = across * across / (2.0 * hump_radius);
    // Half of the drop on each side, so that the rail passes through the origin in the valley.
    const double step = y > 0.0 ? -lower * (1.0 - std::exp(-y * y / 4.0)) : 0.0;
    const double step_slope = y > 0.0 ? -lower * 0.5 * y * std::exp(-y * y / 4.0) : 0.0;
    return HeightAndSlope{crest - drop + step,
                          -(y > 0.0 ? 1.0 : -1.0) * across / hump_radius + step_slope};
  });
  const auto radius = sampled_curve(-reach, reach, 1.0, [](double) {
    return HeightAndSlope{wheel_over_humps, 0.0};
  });
  PatchCase input = thesis_case('b');
  input.load = {};
  input.load.normal_force = force;
  input.rolling.problem = contact::Problem::frictionless;
  input.patch = std::make_shared<contact::PatchGeometry>(
      rail, radius, contact::Axle{{0.0, 0.0, wheel_over_humps + crest}, {0.0, 1.0, 0.0}}, -reach,
      reach);
  return input;
}

}  // namespace rollfem::testing

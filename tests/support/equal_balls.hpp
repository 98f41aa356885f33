// SPDX-License-Identifier: LGPL-2.1-or-later
// A ball of steel that rolls over one like it.
#pragma once

#include "base/pi.hpp"

#include "support/committed_cases.hpp"
#include <cmath>

namespace rollfem::testing {

/// Both of `radius` (mm), pressed together to Hertz's p0 = `pressure` (MPa).
inline contact::Case equal_balls(double radius, double pressure, double creepage) {
  contact::Case input = committed_case('b', {creepage});
  input.wheel.rolling_radius = input.wheel.transverse_radius = radius;
  input.rail.rolling_radius = input.rail.transverse_radius = radius;
  // p0^3 = 6 F E*^2 / (pi^3 (R/2)^2), E* of two steel bodies.
  const double modulus = input.wheel.material.young_modulus / (2.0 * (1.0 - 0.3 * 0.3));
  input.load.normal_force = std::pow(contact::pi, 3) * 0.25 * radius * radius *
                            std::pow(pressure, 3) / (6.0 * modulus * modulus);
  return input;
}

}  // namespace rollfem::testing

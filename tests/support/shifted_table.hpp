// SPDX-License-Identifier: LGPL-2.1-or-later
// A table over lateral shifts made of a formula: contact jumps between 1 and 2 mm.
#pragma once

#include "tables/files/creep_table.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

/// Not odd: a wheel's surface slips by itself. Steeper beyond the jump.
inline tables::Scaled law_of_shift(double shift, const tables::Scaled& s) {
  const double x = s[0] - 0.1, steep = shift < 1.5 ? 1.0 + 0.1 * shift : 2.0 + 0.2 * shift;
  const double size = 1.5 * std::sqrt(1.0 + x * x + s[1] * s[1] + 0.3 * s[2] * s[2]) / steep;
  return {-x / size, -(s[1] + 0.4 * s[2]) / size, (0.4 * s[1] - 0.5 * s[2]) / size};
}

inline tables::CreepTable table_of_shifts(int count) {
  tables::CreepTable table;
  table.title = "shifts";
  table.program = "test";
  table.case_text = "[load]\n";
  table.poisson_ratio = 0.28;
  table.shear_modulus = 80e3;
  table.friction_coefficient = 0.3;
  table.lateral_shift = {-1.0, 0.0, 1.0, 2.0, 3.0};
  table.creepage = {tables::spins_to(3.0, 2 * count - 1), tables::spins_to(2.0, 2 * count - 1),
                    tables::spins_to(4.0, 2 * count - 1)};
  for (const double shift : table.lateral_shift) {
    tables::TableWheel wheel;
    wheel.semi_axis_x = 6.0 + shift;
    wheel.semi_axis_y = 5.0;
    wheel.normal_force = 50e3;
    wheel.contact_angle = 0.1 + 0.05 * shift;
    wheel.rolling_radius = 450.0 - shift;
    wheel.contacts = shift < 1.5 ? 1.0 : 2.0;
    wheel.jump_after = shift == 1.0 ? 1.0 : 0.0;
    table.wheels.push_back(wheel);
    table.scale.push_back({2.0 + 0.1 * shift, 1.8, 1.5});
    for (const double x : table.creepage[0])
      for (const double y : table.creepage[1])
        for (const double z : table.creepage[2]) {
          const tables::Scaled force = law_of_shift(shift, {x, y, z});
          table.forces.push_back(force);
          table.along_normal.push_back(0.1 * force[1]);
          table.bars.push_back({0.002, 0.004});
          table.elements_across.push_back(20);
        }
  }
  table.interpolation.force_95 = 0.01;
  table.interpolation.moment_95 = 0.02;
  return table;
}

}  // namespace rollfem::testing

// SPDX-License-Identifier: LGPL-2.1-or-later
// Half of a flat rail, or of a wheel, under Hertz's pressure on a circle or ellipse.
#pragma once

#include "support/fem_rolled_body.hpp"

namespace rollfem::testing {

/// Lengths in semi-axes along rolling, 1 mm.
struct PatchOptions {
  int per_semi_axis = 4;  ///< cells
  double half_width = 1.0;
  double reach = 1.5;  ///< of the material points ahead, behind and down
  double extent = 10.0;
  double wheel_radius = 0.0;  ///< mm; 0: a rail
  double first_row = 0.0;     ///< height of the cells at the surface; 0: equal rows
  int at_once = 8;            ///< rows that the largest cells cover
};

/// Pressure sqrt(1 - x^2 - (y / half_width)^2) MPa.
inline std::unique_ptr<RolledBody> rolled_patch(const PatchOptions& options = {}) {
  const int per = options.per_semi_axis;
  const double h = 1.0 / per;
  const auto cells = [&](double length) { return static_cast<int>(std::lround(length * per)); };
  const double wide = options.half_width + 0.34;
  fem::BodyOptions body;
  body.cell_size = h;
  body.half = true;
  body.fine_half_length = options.reach;
  body.fine_half_width = wide;
  if (options.first_row > 0.0) body.rows = fem::GradedDepth(options.first_row, h, options.at_once);
  body.fine_depth = std::ceil(body.rows.even(options.reach) * per - 1e-6);
  body.extent = options.extent;
  const auto grid = contact::ContactGrid::centred(2 * cells(1.25), 2 * cells(wide), h, h, 0.0, 0.0);
  const contact::Field pressure = grid.sample([&](double x, double y) {
    constexpr int parts = 20;
    double sum = 0.0;
    for (int i = 0; i < parts; ++i)
      for (int j = 0; j < parts; ++j) {
        const double u = x + h * ((i + 0.5) / parts - 0.5);
        const double v = (y + h * ((j + 0.5) / parts - 0.5)) / options.half_width;
        sum += std::sqrt(std::max(0.0, 1.0 - u * u - v * v));
      }
    return sum / (parts * parts);
  });
  fem::StreamLattice lattice;
  lattice.cell = h;
  lattice.along = {-cells(options.reach), cells(options.reach)};
  lattice.across = {0, cells(wide)};
  lattice.down = static_cast<int>(body.fine_depth);
  lattice.rows = body.rows;
  const auto shape = options.wheel_radius > 0.0
                         ? wheel_shape(options.wheel_radius, contact::infinity)
                         : rail_shape(contact::infinity);
  return std::make_unique<RolledBody>(
      std::make_unique<fem::Body>(shape, contact::Material{210e3, 0.3}, body, MPI_COMM_WORLD), grid,
      pressure, lattice);
}

}  // namespace rollfem::testing

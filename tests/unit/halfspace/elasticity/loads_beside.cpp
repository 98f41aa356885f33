// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement under a contact by loads beside it. References: the point loads of Boussinesq and
// Cerruti on two like bodies, and differences of them.
#include "halfspace/closed_forms/point_loads.hpp"
#include "halfspace/elasticity/influence.hpp"

#include <gtest/gtest.h>

using namespace rollfem;

namespace {

const contact::Material steel{210e3, 0.3};
const contact::NeighbourLoad load{3.0, 25.0, 4e3, -2e3, 30e3};

/// Of wheel and rail together at (x, y): they move apart by twice what one of them moves.
halfspace::Displacement of_both(double x, double y) {
  const halfspace::ElasticHalfspace body{contact::shear_modulus(steel), steel.poisson_ratio};
  const double dx = x - load.x, dy = y - load.y;
  const auto pressed = halfspace::boussinesq_displacement(body, load.normal, {dx, dy, 0.0});
  const auto along = halfspace::cerruti_displacement(body, load.longitudinal, {dx, dy, 0.0});
  const auto across = halfspace::cerruti_displacement(body, load.lateral, {dy, dx, 0.0});
  return {2.0 * (along[0] + across[1]), 2.0 * (along[1] + across[0]), 2.0 * pressed[2]};
}

}  // namespace

TEST(LoadsBeside, DisplaceAsPointLoadsDo) {
  const contact::CombinedMaterial both = contact::combine(steel, steel);
  const contact::ContactGrid grid{3, 4, 2.0, 1.5, -2.0, -3.0};
  const contact::Field distance = halfspace::neighbour_displacement({load}, both, grid);
  const contact::TangentialField slip = halfspace::neighbour_slip({load}, both, grid);
  constexpr double step = 1e-3;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const double x = grid.x(i), y = grid.y(j);
      const int k = grid.index(i, j);
      EXPECT_NEAR(distance[k], of_both(x, y)[2], 1e-12);
      const auto before = of_both(x - step, y), after = of_both(x + step, y);
      EXPECT_NEAR(slip.x[k], -(after[0] - before[0]) / (2.0 * step), 1e-11);
      EXPECT_NEAR(slip.y[k], -(after[1] - before[1]) / (2.0 * step), 1e-11);
    }
}

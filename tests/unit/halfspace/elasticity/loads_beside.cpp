// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement under a contact by loads beside it. References: the point loads of Boussinesq and
// Cerruti on two like bodies, and differences of them.
#include "base/pi.hpp"
#include "halfspace/closed_forms/point_loads.hpp"
#include "halfspace/elasticity/neighbours.hpp"

#include "support/test.hpp"

namespace {

const contact::Material steel{210e3, 0.3};
const contact::NeighbourLoad load{3.0, 25.0, 4e3, -2e3, 30e3, 0.0};

/// Of wheel and rail together at (x, y): they move apart by twice what one of them moves.
halfspace::Displacement of_both(double x, double y) {
  const halfspace::ElasticHalfspace body{contact::shear_modulus(steel), steel.poisson_ratio};
  const double dx = x - load.x, dy = y - load.y;
  const auto pressed = halfspace::boussinesq_displacement(body, load.normal, {dx, dy, 0.0});
  const auto along = halfspace::cerruti_displacement(body, load.longitudinal, {dx, dy, 0.0});
  const auto across = halfspace::cerruti_displacement(body, load.lateral, {dy, dx, 0.0});
  return {2.0 * (along[0] + across[1]), 2.0 * (along[1] + across[0]), 2.0 * pressed[2]};
}

/// One element there.
contact::ContactGrid at(double x, double y) {
  return {1, 1, 1.0, 1.0, x, y};
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

// Wheel and rail of steel, one of them rigid: 10 kN on one face of a right angle, 10 mm from the
// edge; displacement of the other face in um at 5, 10, 15, 20 mm. Finite elements of a block,
// clamped some 120 mm from the edge: an endless wedge moves up to 0.23 um further out.
TEST(LoadsBeside, OnOneFaceOfARightAnglePushOutTheOther) {
  struct Corner {
    contact::CombinedMaterial material;
    std::array<double, 4> moved;
  };
  const contact::Material rigid = contact::rigid_material();
  for (const Corner& corner :
       {Corner{contact::combine(rigid, steel), {-1.58, -1.34, -0.96, -0.68}},
        Corner{contact::combine(steel, rigid), {-0.04, -0.03, -0.02, -0.02}}})
    for (std::size_t k = 0; k < 4; ++k) {
      const double from_edge = 5.0 * static_cast<double>(k + 1);
      const contact::NeighbourLoad on_other{0.0, 0.0, 0.0, 0.0, 10e3, 0.5 * contact::pi};
      const double moved = halfspace::neighbour_displacement({on_other}, corner.material,
                                                             at(0.0, 10.0 + from_edge))[0];
      EXPECT_NEAR(1e3 * moved, corner.moved[k], 0.3);  // the half-space: +0.92 to +0.46
    }
}

TEST(LoadsBeside, AroundASmallTurnDisplaceAsOnAPlane) {
  const contact::CombinedMaterial both = contact::combine(steel, steel);
  contact::NeighbourLoad pressed{0.0, 20.0, 0.0, 0.0, 30e3, 0.0};
  const double flat = halfspace::neighbour_displacement({pressed}, both, at(0.0, 0.0))[0];
  pressed.turn = contact::pi / 9.0;
  EXPECT_NEAR(halfspace::neighbour_displacement({pressed}, both, at(0.0, 0.0))[0], flat,
              0.08 * flat);
}

// Betti: what a pressure moves along a tangent elsewhere, a tangential load there moves along the
// normal.
TEST(LoadsBeside, AroundACornerAreReciprocal) {
  const contact::CombinedMaterial unlike = contact::combine(steel, {70e3, 0.3});
  const double force = 30e3, turn = 1.1, step = 1e-3;
  const contact::NeighbourLoad pressed{0.0, 0.0, 0.0, 0.0, force, turn};
  const contact::NeighbourLoad none{0.0, 0.0, 0.0, 0.0, force, 0.0};
  for (const auto& [x, y] : {std::pair{4.0, 18.0}, {-7.0, -25.0}, {2.0, -9.0}}) {
    const contact::TangentialField slip = halfspace::neighbour_slip({pressed}, unlike, at(x, y));
    EXPECT_EQ(halfspace::neighbour_slip({none}, unlike, at(x, y)).x[0], 0.0);
    const auto moved = [&, y = y](double from, double longitudinal, double lateral) {
      return halfspace::neighbour_displacement({{from, y, longitudinal, lateral, 0.0, turn}},
                                               unlike, at(0.0, 0.0))[0];
    };
    EXPECT_NEAR(slip.x[0],
                -(moved(x + step, force, 0.0) - moved(x - step, force, 0.0)) / (2 * step), 1e-9);
    EXPECT_NEAR(slip.y[0],
                -(moved(x + step, 0.0, force) - moved(x - step, 0.0, force)) / (2 * step), 1e-9);
  }
}

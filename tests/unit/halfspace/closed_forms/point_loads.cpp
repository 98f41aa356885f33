// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement by point loads on the half-space: that of the potentials whose stress is tested in
// stress/cell_stress.cpp, and known values on the surface.
#include "halfspace/closed_forms/point_loads.hpp"

#include "base/pi.hpp"

#include "support/cell_state.hpp"

namespace rollfem::halfspace {
namespace {

const ElasticHalfspace steel{80769.0, 0.3};
constexpr double load = 1000.0;

TEST(PointLoads, AreThoseOfThePotentials) {
  for (const ElasticHalfspace& body : {steel, ElasticHalfspace{500.0, 0.0}})
    for (const Position& at : {Position{1.0, 0.5, 0.7}, Position{-2.0, 0.3, 1.5},
                               Position{0.01, -0.02, 2.0}, Position{0.8, -1.1, 0.02}}) {
      const auto state = [&](const LocalLoad& force) {
        return point_state(at.x, at.y, at.z, force, body.shear_modulus, body.poisson_ratio);
      };
      const Displacement normal = boussinesq_displacement(body, load, at);
      const Displacement along = cerruti_displacement(body, load, at);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(normal[i], state({0.0, 0.0, load})[i], 1e-13 * normal[2]);
        EXPECT_NEAR(along[i], state({load, 0.0, 0.0})[i], 1e-13 * along[0]);
      }
    }
}

TEST(PointLoads, SurfaceHasTheKnownDisplacement) {
  const double nu = steel.poisson_ratio;
  const Position at{3.0, -4.0, 0.0};
  const double r = 5.0;
  const double unit = load / (2.0 * pi * steel.shear_modulus * r);
  const Displacement normal = boussinesq_displacement(steel, load, at);
  EXPECT_NEAR(normal[2] / unit, 1.0 - nu, 1e-13);
  EXPECT_NEAR(normal[0] / unit, -(1.0 - 2.0 * nu) / 2.0 * at.x / r, 1e-13);
  const Displacement along = cerruti_displacement(steel, load, at);
  EXPECT_NEAR(along[0] / unit, 1.0 - nu + nu * at.x * at.x / (r * r), 1e-13);
  EXPECT_NEAR(along[1] / unit, nu * at.x * at.y / (r * r), 1e-13);
  EXPECT_NEAR(along[2] / unit, (1.0 - 2.0 * nu) * at.x / (2.0 * r), 1e-13);
}

TEST(PointLoads, NormalDisplacementUnderAShearLoadIsReciprocal) {
  // Betti: u_x of a normal load at one point is u_z of a tangential load, seen the other way round.
  const Position there{1.2, 0.7, 0.0};
  const Position back{-1.2, -0.7, 0.0};
  EXPECT_NEAR(boussinesq_displacement(steel, load, there)[0],
              cerruti_displacement(steel, load, back)[2], 1e-15);
}

}  // namespace
}  // namespace rollfem::halfspace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement by point loads on the half-space: that of the potentials, which
// stress/cell_stress.cpp compares with the textbook.
#include "halfspace/closed_forms/point_loads.hpp"

#include "support/cell_state.hpp"

namespace rollfem::halfspace {
namespace {

const ElasticHalfspace steel{80769.0, 0.3};
constexpr double load = 1000.0;

TEST(PointLoads, AreThoseOfThePotentials) {
  for (const ElasticHalfspace& body : {steel, ElasticHalfspace{500.0, 0.0}})
    for (const Position& at :
         {Position{1.0, 0.5, 0.7}, Position{-2.0, 0.3, 1.5}, Position{0.01, -0.02, 2.0},
          Position{0.8, -1.1, 0.02}, Position{3.0, -4.0, 0.0}}) {
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

}  // namespace
}  // namespace rollfem::halfspace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Slip of a loaded wheel on a rail at xi = 0, which half-spaces do not have: finite elements
// against a first-order perturbation of the half-space by the curvature of the bodies.
#include "fem/elasticity/run_level.hpp"

#include "support/committed_cases.hpp"
#include "support/mpi_environment.hpp"

TEST(FemStrain, OfPressureAloneSlipsAsAPerturbedHalfSpace) {
  // The perturbation has tractions -d_b (h sigma_ab) - p h_,a left on the curved surface, of height
  // h, and slip -h u_z,xx; with it a coefficient of 0.0030, 0.0039 and 0.0046.
  struct {
    char name;
    double cell, slip;
  } const rows[] = {{'a', 0.94, 1.45e-5}, {'b', 1.5, 2.45e-5}, {'c', 0.94, 3.58e-5}};
  for (const auto& row : rows) {
    SCOPED_TRACE(row.name);
    contact::Case input = committed_case(row.name, {0.0});
    // Next to no friction: the slip is that of pressure.
    input.friction_coefficient = 1e-5;
    const contact::ModelResult result = fem::run_level(input, {row.cell, "", false}, {});
    const contact::ContactFields& f = result.points.front().fields;
    const double mean = f.slip.x.dot(f.traction.n) / f.traction.n.sum();
    // On cells of a quarter of the smaller semi-axis, 2 to 7 % below.
    EXPECT_NEAR(mean / row.slip, 1.0, 0.1);
  }
}

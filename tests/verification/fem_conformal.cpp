// SPDX-License-Identifier: LGPL-2.1-or-later
// The hybrid where patches embrace: a wheel in a groove, whose normals turn by 33 degrees.
#include "halfspace/model/halfspace_model.hpp"
#include "hybrid/correction/smooth_parts.hpp"
#include "hybrid/hybrid_model.hpp"

#include "support/committed_cases.hpp"
#include "support/mpi_environment.hpp"

TEST(HybridInAGroove, HasThePressureOfDirectionsTurned) {
  // benchmarks/book/turned_half_space.py: the half-space with displacements taken along the normals
  // of where they are has 529.46 MPa and an approach of 0.02243 mm, rolled out flat 533.11 MPa;
  // both on elements of 0.2 by 0.25 mm.
  contact::Case input = committed_case("conformal_groove");
  const auto flat = halfspace::run_halfspace(input, {}).points.front();
  const auto bodies =
      hybrid::run_hybrid(input, {}, nullptr, hybrid::find_smooth_parts).points.front();
  EXPECT_NEAR(flat.max_pressure, 533.11, 1e-3 * 533.11);
  EXPECT_NEAR(bodies.max_pressure, 529.46, 3e-3 * 529.46);
  EXPECT_NEAR(bodies.approach, 0.02243, 0.015 * 0.02243);
  EXPECT_GT(bodies.semi_axis_y, 1.01 * flat.semi_axis_y);
  EXPECT_NEAR(bodies.normal_force, 10e3, 1e-5 * 10e3);
}

TEST(HybridInAGroove, IsRoundAsFarAsTheCaseSays) {
  // A groove of 10.02 mm: half the patch is 47 degrees, beyond where circles end by default. The
  // half-space of directions turned has 295.91 MPa, rolled out flat 301.11 MPa, finite elements of
  // 0.24 mm 294.98 MPa.
  contact::Case input = committed_case("conformal_groove");
  input.rail.transverse_radius = -10.02;
  input.wheel.round_to = input.rail.round_to = 0.85;
  input.contact_grid.elements_across = 30;
  const auto bodies =
      hybrid::run_hybrid(input, {}, nullptr, hybrid::find_smooth_parts).points.front();
  EXPECT_NEAR(bodies.max_pressure, 294.98, 3e-3 * 294.98);
  EXPECT_NEAR(bodies.max_pressure, 295.91, 5e-3 * 295.91);
  EXPECT_GT(bodies.semi_axis_y, 10.02 * std::asin(0.7));
}

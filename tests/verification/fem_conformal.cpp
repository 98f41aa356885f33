// The hybrid where patches embrace: a wheel in a groove, whose normals turn by 33 degrees.
#include "contact/case/case_reader.hpp"
#include "fem/correction/smooth_parts.hpp"
#include "halfspace/model/model.hpp"
#include "hybrid/model.hpp"

#include <gtest/gtest.h>

#include "support/mpi_environment.hpp"
#include <string>

using namespace rollfem;

TEST(HybridInAGroove, HasThePressureOfDirectionsTurned) {
  // benchmarks/book/turned_half_space.py: the half-space with displacements taken along the normals
  // of where they are has 529.46 MPa and an approach of 0.02243 mm, rolled out flat 533.11 MPa;
  // both on elements of 0.2 by 0.25 mm.
  contact::Case input =
      contact::read_case(std::string(ROLLFEM_SOURCE_DIR) + "/cases/conformal_groove.toml");
  const auto flat = halfspace::run_halfspace(input, {}).points.front();
  const auto bodies = hybrid::run_hybrid(input, {}, nullptr, fem::find_smooth_parts).points.front();
  EXPECT_NEAR(flat.max_pressure, 533.11, 1e-3 * 533.11);
  EXPECT_NEAR(bodies.max_pressure, 529.46, 3e-3 * 529.46);
  EXPECT_NEAR(bodies.approach, 0.02243, 0.015 * 0.02243);
  EXPECT_GT(bodies.semi_axis_y, 1.01 * flat.semi_axis_y);
  EXPECT_NEAR(bodies.normal_force, 10e3, 1e-5 * 10e3);
}

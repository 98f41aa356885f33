// The accuracy that a case asks for, by finite elements on case a without friction: reached with an
// estimate of the right size, or said not to be reached.
#include "contact/case/case_reader.hpp"
#include "contact/result/refinement.hpp"
#include "fem/model/model.hpp"

#include <gtest/gtest.h>

#include "support/mpi_environment.hpp"
#include <cmath>
#include <cstdlib>
#include <string>

namespace {

using namespace rollfem;

contact::Case frictionless_case_a() {
  contact::Case input =
      contact::read_case(std::string(ROLLFEM_SOURCE_DIR) + "/cases/thesis_a.toml");
  input.rolling.problem = contact::Problem::frictionless;
  input.rolling.creepages = {contact::Creepage{}};
  input.output.fields = false;
  input.fem.cell_size.reset();
  return input;
}

/// Of these segments, +-0.02 MPa, from cells of 0.474, 0.237 and 0.1185 mm by the order that they
/// show (docs/accuracy.md); half-spaces have 578.967 MPa.
constexpr double p0_of_the_segments = 579.28;

double effectivity(const contact::PointResult& point) {
  const double error = std::abs(point.max_pressure - p0_of_the_segments);
  return point.error_estimate.at("max_pressure") / error;
}

TEST(FemAccuracy, IsReachedWithAnEstimateOfTheRightSize) {
  contact::Case input = frictionless_case_a();
  input.accuracy_of = {"max_pressure"};
  input.accuracy = 0.002;
  const contact::ModelResult result = fem::run_fem(input, {});
  const contact::PointResult& point = result.points.front();
  EXPECT_EQ(result.shortfall, "");
  EXPECT_LE(point.error_estimate.at("max_pressure"), 0.002 * point.max_pressure);
  EXPECT_NEAR(point.max_pressure / p0_of_the_segments, 1.0, 0.002);
  EXPECT_GE(effectivity(point), 0.5) << result.grid.dx;
  EXPECT_LE(effectivity(point), 3.0) << result.grid.dx;
  EXPECT_EQ(point.max_traction, 0.0);
}

TEST(FemAccuracy, ThatMemoryDoesNotAllowIsSaidAndTheFinestResultIsThere) {
  contact::Case input = frictionless_case_a();
  input.accuracy = 1e-5;
  input.fem.cell_size = 0.95;  // two levels fit, the next does not
  setenv("ROLLFEM_MEMORY_GB", "0.4", 1);
  const contact::ModelResult result = fem::run_fem(input, {});
  unsetenv("ROLLFEM_MEMORY_GB");
  ASSERT_EQ(result.points.size(), 1u);
  for (const char* part : {"accuracy = 1e-05", "not reached", "0.4 GB are available"})
    EXPECT_NE(result.shortfall.find(part), std::string::npos) << result.shortfall;
}

}  // namespace

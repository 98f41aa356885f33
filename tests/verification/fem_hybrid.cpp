// The hybrid: nothing where bodies are half-spaces, the strain of a loaded wheel where it is one,
// and the finite elements' pressure and forces where the surfaces are steep.
#include "contact/case/case_reader.hpp"
#include "fem/correction/smooth_parts.hpp"
#include "halfspace/model/model.hpp"
#include "hybrid/model.hpp"

#include <gtest/gtest.h>

#include "support/mpi_environment.hpp"
#include <cmath>
#include <string>

namespace {

using namespace rollfem;

contact::Case study_case(const std::string& name, std::vector<double> creepages) {
  contact::Case input =
      contact::read_case(std::string(ROLLFEM_SOURCE_DIR) + "/cases/thesis_" + name + ".toml");
  input.contact_grid.elements_across = 40;
  input.rolling.creepages.clear();
  for (const double xi : creepages) input.rolling.creepages.push_back({xi, 0.0, 0.0});
  return input;
}

contact::ModelResult hybrid_of(const contact::Case& input) {
  return hybrid::run_hybrid(input, {}, nullptr, fem::find_smooth_parts);
}

}  // namespace

TEST(Hybrid, AddsNothingToBodiesThatAreHalfSpaces) {
  // Radii of 4 m under 0.05 N: patch over radius is 1e-5, and with it what curvature adds.
  contact::Case input = study_case("a", {0.001});
  input.wheel.rolling_radius = 4000.0;
  input.rail.transverse_radius = 4000.0;
  input.load.normal_force = 0.05;
  input.rolling.creepages[0].longitudinal = 1e-7;
  const auto one = hybrid_of(input).points.front();
  const auto other = halfspace::run_halfspace(input, {}).points.front();
  EXPECT_NEAR(one.max_pressure / other.max_pressure, 1.0, 1e-4);
  EXPECT_NEAR(one.approach / other.approach, 1.0, 1e-3);
  EXPECT_NEAR(one.traction_coefficient, other.traction_coefficient, 1e-4 * 0.55);
}

TEST(Hybrid, HasTheStrainOfALoadedWheel) {
  // Case a: by a perturbation of the half-space 0.0030 at rest and 0.0023 above it at 0.1 %, where
  // finite elements on the same cells are 0.0035 above.
  const contact::Case input = study_case("a", {0.0, 0.001});
  const auto result = hybrid_of(input);
  const auto half = halfspace::run_halfspace(input, {});
  EXPECT_NEAR(result.points[0].traction_coefficient, 0.0030, 0.0002);
  EXPECT_NEAR(result.points[1].traction_coefficient - half.points[1].traction_coefficient, 0.0023,
              0.0003);
  EXPECT_NEAR(result.points[0].max_pressure / half.points[0].max_pressure, 1.0, 1e-3);
  // Truth and sum: what the correction changes is in the bars by a tenth.
  EXPECT_GT(result.points[0].error_estimate.at("traction_coefficient"), 0.0003);
}

TEST(Hybrid, MeetsTheLimitOfFiniteElements) {
  // Case f: limits by benchmarks/hybrid_limits.py, good to 0.08 MPa and 0.0004 (0.0007 at 0.3 %).
  // Asked are 0.05 % of p0 and 0.1 % of mu. On forty elements across p0 is 0.055 % below its limit,
  // as the half-space's on the common surface is: 582.997 of 583.319 MPa.
  const auto result = hybrid_of(study_case("f", {0.0, 0.001, 0.003}));
  const double on_this_grid = 582.997 / 583.319;
  EXPECT_NEAR(result.points[0].max_pressure / (581.27 * on_this_grid), 1.0, 5e-4);
  EXPECT_NEAR(result.points[2].max_pressure / (580.28 * on_this_grid), 1.0, 5e-4);
  EXPECT_NEAR(result.points[0].traction_coefficient, -0.12874, 1e-3 * 0.55);
  EXPECT_NEAR(result.points[1].traction_coefficient, 0.07434, 1e-3 * 0.55);
  EXPECT_NEAR(result.points[2].traction_coefficient, 0.41279, 1e-3 * 0.55);
}

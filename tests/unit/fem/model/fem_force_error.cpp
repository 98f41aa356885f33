// Error estimates of the forces of a finite-element result from its levels, against numbers worked
// out by hand.
#include "fem/model/force_error.hpp"

#include <gtest/gtest.h>

#include "support/mpi_environment.hpp"
#include <cmath>

namespace {

using namespace rollfem;

constexpr double friction = 0.5;

/// One load point on a patch of 4 by 8 mm, 16 elements across when `cell` is 0.25 mm.
contact::ModelResult level(double cell, double coefficient, double largest = 30.0) {
  contact::ModelResult result;
  result.grid = contact::ContactGrid::centred(40, 40, cell, cell);
  contact::PointResult point;
  point.normal_force = 1000.0;
  point.max_pressure = 100.0;
  point.semi_axis_x = 2.0;
  point.semi_axis_y = 4.0;
  point.adhesion_area = 5.0;
  point.traction_coefficient = coefficient;
  point.longitudinal_force = -1000.0 * coefficient;
  point.max_traction_x = largest;
  result.points.push_back(point);
  return result;
}

double estimate(std::vector<contact::ModelResult> levels, const char* name) {
  contact::Case input;
  input.friction_coefficient = friction;
  fem::estimate_force_errors(input, levels, 0, 1.5);
  const auto& estimates = levels.back().points[0].error_estimate;
  return estimates.count(name) == 1 ? estimates.at(name) : -1.0;
}

const double least = 0.15 / 16.0;

TEST(FemForceError, LevelsThatAgreeByChanceKeepWhatTheContactGridLeavesUncertain) {
  const std::vector<contact::ModelResult> equal{level(0.5, 0.2), level(0.25, 0.2)};
  EXPECT_NEAR(estimate(equal, "traction_coefficient"), 0.2 * least, 1e-12);
  EXPECT_NEAR(estimate(equal, "longitudinal_force"), 200.0 * least, 1e-9);
  EXPECT_NEAR(estimate(equal, "max_traction_x"), 30.0 * 3.0 * least, 1e-9);
  // 8 across: with the square of their number.
  EXPECT_NEAR(estimate({level(1.0, 0.2), level(0.5, 0.2)}, "traction_coefficient"),
              0.2 * 4.0 * least, 1e-12);
}

TEST(FemForceError, AChangeOfTheLevelsIsTheEstimateWhereItIsMore) {
  const std::vector<contact::ModelResult> levels{level(0.5, 0.22, 36.0), level(0.25, 0.2)};
  EXPECT_NEAR(estimate(levels, "traction_coefficient"), 0.02 / (std::exp2(1.5) - 1.0), 1e-12);
  EXPECT_NEAR(estimate(levels, "max_traction_x"), 1.5 * (36.0 - 30.0), 1e-9);
}

TEST(FemForceError, AForceThatVanishesIsMeasuredByFullSliding) {
  EXPECT_NEAR(estimate({level(0.5, 1e-4), level(0.25, 0.0)}, "traction_coefficient"),
              1e-4 / (std::exp2(1.5) - 1.0), 1e-12);
  // Levels that agree: what the grid leaves uncertain in a hundredth of mu.
  EXPECT_NEAR(estimate({level(0.5, 1e-9), level(0.25, 1e-9)}, "traction_coefficient"),
              least * 0.01 * friction, 1e-12);
  // Nothing lateral on any level: no estimate.
  EXPECT_EQ(estimate({level(0.5, 0.2), level(0.25, 0.2)}, "lateral_force"), -1.0);
}

TEST(FemForceError, FullSlipHasNoLeadingEdgeToBeUncertainAbout) {
  std::vector<contact::ModelResult> levels{level(0.5, 0.5), level(0.25, 0.5)};
  for (contact::ModelResult& one : levels) one.points[0].adhesion_area = 0.0;
  EXPECT_EQ(estimate(levels, "traction_coefficient"), 0.0);
}

}  // namespace

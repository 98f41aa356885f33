// SPDX-License-Identifier: LGPL-2.1-or-later
// The error bar of finite elements from half-spaces on the same contact grids, against values
// computed by hand.
#include "fem/elasticity/fem_error_bars.hpp"

#include "support/mpi_environment.hpp"

namespace {

/// What half-spaces leave when their bar is 0.2 and they are off by `known`.
double of_the_grid(double known) {
  return std::hypot(known, 0.2);
}

TEST(FemErrorBars, FiniteElementsThatMoveAsHalfSpacesHaveTheErrorsOfTheirGrid) {
  // Both levels are 0.5 beyond half-spaces: the cells change nothing.
  EXPECT_NEAR(fem::bar_beside_half_spaces({{3.5, 2.5}, {3.0, 2.0}, 0.2, 1.8}), of_the_grid(0.2),
              1e-12);
}

TEST(FemErrorBars, LevelsThatAgreeByChanceAreNotBelieved) {
  // The cells make up for what the grid changes: half-spaces change by 0.4.
  const double of_cells = 0.4 / (std::exp2(1.5) - 1.0);
  EXPECT_NEAR(fem::bar_beside_half_spaces({{3.0, 3.0}, {2.4, 2.0}, 0.2, 1.9}),
              std::hypot(of_the_grid(0.1), of_cells), 1e-12);
  // Neither grid nor cells seem to change anything: the half-space's bar remains.
  EXPECT_NEAR(fem::bar_beside_half_spaces({{3.0, 3.0}, {2.0, 2.0}, 0.2, 2.0}), of_the_grid(0.0),
              1e-12);
}

TEST(FemErrorBars, ThreeLevelsShowTheOrderOfTheCells) {
  // Apart by 1, 1/4, 1/16: order 2, and 1/16 is left.
  EXPECT_NEAR(fem::bar_beside_half_spaces({{3.0, 2.25, 2.0625}, {2.0, 2.0, 2.0}, 0.2, 2.0}),
              std::hypot(of_the_grid(0.0), 0.0625), 1e-12);
}

}  // namespace

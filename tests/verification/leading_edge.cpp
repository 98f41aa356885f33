// SPDX-License-Identifier: LGPL-2.1-or-later
// The leading edge below the element: its place, from the bound (order of the forces, smooth
// tractions across rolling: the book).
#include "contact/iteration/leading_edge.hpp"

#include "support/test.hpp"

namespace {

TEST(LeadingEdge, WeightFallsAsTheEdgeMovesAheadAndIsUsualWhereTheUsualDifferenceHasIt) {
  EXPECT_NEAR(contact::leading_weight(-0.184), 0.5, 2e-3);  // where the usual difference puts it
  for (double e = -0.75; e < 0.7; e += 0.05)
    EXPECT_GT(contact::leading_weight(e), contact::leading_weight(e + 0.05));
}

TEST(LeadingEdge, FlatPunchKeepsStandardDifference) {
  const ContactGrid grid = ContactGrid::centred(16, 3, 0.1, 0.1);
  const Field bound = grid.sample(
      [](double x, double) { return std::abs(x) < 0.5 ? 1.0 / std::sqrt(0.3 - x * x) : 0.0; });
  EXPECT_EQ((contact::upwind_weights(grid, bound).array() - 0.5).cwiseAbs().maxCoeff(), 0.0);
}

TEST(LeadingEdge, IsFoundFromTheBoundOnly) {
  // sqrt(d) with the edge at 4.2 elements beyond the middle: 4 whole elements and 0.2 beyond.
  const ContactGrid grid = ContactGrid::centred(16, 1, 1.0, 1.0);
  const double edge = 4.2;
  const Field bound = grid.sample(
      [&](double x, double) { return x < edge && x > -6.0 ? std::sqrt(edge - x) : 0.0; });
  const Field weights = contact::upwind_weights(grid, bound);
  int leading = 0;
  for (int i = 0; i < grid.nx; ++i)
    if (bound[i] > 0.0) leading = i;
  const double border = grid.x(leading) + 0.5 * grid.dx;
  EXPECT_NEAR(weights[leading], contact::leading_weight(edge - border), 1e-9);
  EXPECT_EQ(weights[leading - 1], 0.5);
  EXPECT_NEAR((contact::upwind_weights(grid, 1e-6 * bound) - weights).norm(), 0.0, 1e-12);
}

}  // namespace

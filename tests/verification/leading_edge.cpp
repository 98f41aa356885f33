// SPDX-License-Identifier: LGPL-2.1-or-later
// The leading edge below the element: smooth tractions across rolling (order of the forces: the
// book).
#include "contact/iteration/leading_edge.hpp"

#include "contact/iteration/normal.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"

#include "support/test.hpp"
#include "support/thesis_cases.hpp"

namespace {

using halfspace::HalfspaceCompliance;

enum class Edge { usual, fitted };

TangentialSolution solve(const HalfspaceCompliance& compliance, const TangentialProblem& problem,
                         Edge edge) {
  const contact::TangentialOperator& second = compliance.rolling(UpwindOrder::second);
  if (edge == Edge::usual) return contact::solve_tangential(second, problem);
  const EdgeFittedRolling fitted(compliance.rolling(UpwindOrder::first), second,
                                 contact::upwind_weights(compliance.grid(), problem.pressure));
  return contact::solve_tangential(fitted, problem);
}

/// Part of a field that alternates from row to row at x = 0, relative to its largest: rms of the
/// fourth difference across rows over 16, which passes the alternating part whole and a smooth one
/// hardly at all.
double zigzag(const ContactGrid& grid, const Field& values, double half_width) {
  const int i = grid.nx / 2;
  double sum = 0.0;
  double largest = 0.0;
  int count = 0;
  for (int j = 2; j + 2 < grid.ny; ++j) {
    const auto at = [&](int row) { return values[grid.index(i, row)]; };
    largest = std::max(largest, std::abs(at(j)));
    if (std::abs(grid.y(j)) > 0.8 * half_width) continue;
    const double alternating =
        (at(j - 2) - 4.0 * at(j - 1) + 6.0 * at(j) - 4.0 * at(j + 1) + at(j + 2)) / 16.0;
    sum += alternating * alternating;
    ++count;
  }
  return std::sqrt(sum / count) / largest;
}

/// Zigzag of p_x across rolling at x = 0 for a thesis case at pure longitudinal creepage.
double zigzag_of_case(char name, double creepage, int across, Edge edge) {
  const contact::Case input = thesis_case(name);
  const halfspace::HertzContact hertz = halfspace::hertz_of_scene(input);
  const contact::Curvatures curvatures = contact::relative_curvatures(input);
  const ContactGrid grid = ContactGrid::centred(
      across + 6, across + 6, 2 * hertz.semi_axis_x / across, 2 * hertz.semi_axis_y / across);
  const HalfspaceCompliance compliance(grid, rollfem::testing::steel());
  contact::NormalProblem normal;
  normal.undeformed_distance = grid.sample(
      [&](double x, double y) { return contact::undeformed_distance(curvatures, x, y); });
  normal.normal_force = input.load.normal_force;
  const Field pressure = contact::solve_normal(compliance.normal(), normal).pressure;
  const TangentialProblem problem{
      pressure,
      {{Field::Constant(grid.size(), creepage), Field::Zero(grid.size())}},
      contact::coulomb(input.friction_coefficient)};
  return zigzag(grid, solve(compliance, problem, edge).traction.x, hertz.semi_axis_y);
}

TEST(LeadingEdge, TractionsAcrossRollingDoNotZigzag) {
  // Elements of dy/dx = 2.9 (a) and 0.33 (c), where the usual difference gives 1.3 % and 3.8 %.
  EXPECT_LT(zigzag_of_case('a', 5e-4, 40, Edge::fitted), 0.005);
  EXPECT_LT(zigzag_of_case('c', 1e-3, 40, Edge::fitted), 0.015);
  EXPECT_LT(3.0 * zigzag_of_case('a', 5e-4, 40, Edge::fitted),
            zigzag_of_case('a', 5e-4, 40, Edge::usual));
  EXPECT_LT(2.5 * zigzag_of_case('c', 1e-3, 40, Edge::fitted),
            zigzag_of_case('c', 1e-3, 40, Edge::usual));
}

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

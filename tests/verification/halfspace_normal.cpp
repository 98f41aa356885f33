// SPDX-License-Identifier: LGPL-2.1-or-later
// The normal solver on the half-space against Hertz, a punch, CONTACT and invariants.
#include "contact/iteration/normal.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "result/patch_size.hpp"

#include "support/test.hpp"
#include "support/thesis_cases.hpp"

namespace {

using halfspace::HalfspaceCompliance;
using halfspace::HertzContact;

struct Solved {
  ContactGrid grid;
  NormalProblem problem;
  NormalSolution solution;
};

/// The case's quadratic surfaces with n elements across both axes of Hertz's ellipse.
Solved solve_case(const contact::Case& input, int n, const contact::NormalOptions& options = {}) {
  const HertzContact hertz = halfspace::hertz_of_scene(input);
  const contact::Curvatures curvatures = contact::relative_curvatures(input);
  Solved run;
  run.grid =
      ContactGrid::centred(n + 6, n + 6, 2.0 * hertz.semi_axis_x / n, 2.0 * hertz.semi_axis_y / n);
  run.problem.undeformed_distance = run.grid.sample(
      [&](double x, double y) { return contact::undeformed_distance(curvatures, x, y); });
  run.problem.normal_force = input.load.normal_force;
  const HalfspaceCompliance compliance(run.grid,
                                       contact::combine(input.wheel.material, input.rail.material));
  run.solution = contact::solve_normal(compliance.normal(), run.problem, options);
  return run;
}

TEST(HalfspaceNormal, SemiAxesOfSlenderEllipsesAreFoundAnywhereOnTheGrid) {
  contact::Case input = thesis_case('a');
  for (const double radius : {300.0, 30.0, 5.0}) {  // axis ratios of 1.3, 6 and 20
    input.rail.transverse_radius = radius;
    input.load.normal_force = 2.0 * radius * radius;
    const HertzContact hertz = halfspace::hertz_of_scene(input);
    const contact::Curvatures curvatures = contact::relative_curvatures(input);
    const HalfspaceCompliance compliance(
        ContactGrid::centred(48, 48, hertz.semi_axis_x / 19.0, hertz.semi_axis_y / 19.0),
        contact::combine(input.wheel.material, input.rail.material));
    for (int k = 0; k < 6; ++k) {
      // The ends of the patch lie anywhere within an element.
      const double stretch = 1.0 + 0.009 * k, shift = 0.13 * k;
      const double dx = hertz.semi_axis_x / 19.0, dy = hertz.semi_axis_y / 19.0;
      NormalProblem problem;
      problem.undeformed_distance = compliance.grid().sample([&](double x, double y) {
        return contact::undeformed_distance(curvatures, x + shift * dx, y + shift * dy);
      });
      // Larger forces stretch both axes alike.
      problem.normal_force = *input.load.normal_force * std::pow(stretch, 3);
      const auto solved = contact::solve_normal(compliance.normal(), problem, {});
      const contact::PatchSize size = contact::patch_size(compliance.grid(), solved.pressure);
      const auto error = [&](double whole, double axis, double cell) {
        return (0.5 * whole - stretch * axis) / cell;
      };
      EXPECT_NEAR(error(size.length, hertz.semi_axis_x, dx), 0.0, 0.02) << radius << " " << k;
      EXPECT_NEAR(error(size.width, hertz.semi_axis_y, dy), 0.0, 0.02) << radius << " " << k;
    }
  }
}

TEST(HalfspaceNormal, IterationsStayFewOnFineGrids) {
  const contact::Case input = thesis_case('a');
  contact::NormalOptions engineering;
  engineering.tolerance = 1e-5;
  EXPECT_LE(solve_case(input, 20, engineering).solution.iterations, 9);
  EXPECT_LE(solve_case(input, 160, engineering).solution.iterations, 12);
  EXPECT_LE(solve_case(input, 160).solution.iterations, 20);
}

TEST(HalfspaceNormal, ScalesWithUnitsAndHasTheSymmetryOfThePatch) {
  const contact::Case input = thesis_case('a');
  const Solved run = solve_case(input, 21);
  contact::Case scaled = input;  // lengths times 1000, moduli times 1e-6: metres from kilometres
  scaled.wheel.rolling_radius *= 1e3;
  scaled.rail.transverse_radius *= 1e3;
  scaled.wheel.material.young_modulus *= 1e-6;
  scaled.rail.material.young_modulus *= 1e-6;
  const Solved other = solve_case(scaled, 21);
  const double peak = run.solution.pressure.maxCoeff();
  EXPECT_LT((other.solution.pressure * 1e6 - run.solution.pressure).cwiseAbs().maxCoeff(),
            1e-7 * peak);
  EXPECT_NEAR(other.solution.approach / run.solution.approach, 1e3, 1e-4);
  for (int j = 0; j < run.grid.ny; ++j)
    for (int i = 0; i < run.grid.nx; ++i) {
      const double p = run.solution.pressure[run.grid.index(i, j)];
      EXPECT_NEAR(p, run.solution.pressure[run.grid.index(run.grid.nx - 1 - i, j)], 1e-6 * peak);
      EXPECT_NEAR(p, run.solution.pressure[run.grid.index(i, run.grid.ny - 1 - j)], 1e-6 * peak);
    }
}

/// Flat circular punch: p = P/(2 pi a sqrt(a^2 - r^2)), approach = P/(2 a E*).
TEST(HalfspaceNormal, FlatCircularPunchIsBoussinesqs) {
  const double a = 1.0;
  const double modulus =
      rollfem::testing::steel().shear_modulus / (1.0 - rollfem::testing::steel().poisson_ratio);
  for (const int n : {20, 40, 80}) {
    const ContactGrid grid = ContactGrid::centred(n + 4, n + 4, 2.0 * a / n, 2.0 * a / n);
    const HalfspaceCompliance compliance(grid, rollfem::testing::steel());
    NormalProblem problem;
    problem.undeformed_distance =
        grid.sample([&](double x, double y) { return std::hypot(x, y) <= a ? 0.0 : 1.0; });
    problem.approach = 1e-3;
    const NormalSolution s = contact::solve_normal(compliance.normal(), problem);
    const double error = s.normal_force / (2.0 * a * modulus * 1e-3) - 1.0;
    // First order, and not evenly: the rim is a staircase and the pressure singular there.
    EXPECT_LT(std::abs(error), 0.8 / n) << n;
    if (n == 80) {
      EXPECT_LT(std::abs(error), 0.01);
      const double middle = s.pressure[grid.index(grid.nx / 2, grid.ny / 2)];
      EXPECT_NEAR(middle / (s.normal_force / (2.0 * M_PI * a * a)), 1.0, 0.01);
    }
  }
}

}  // namespace

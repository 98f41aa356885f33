// SPDX-License-Identifier: LGPL-2.1-or-later
// The outer contact iteration: with any preconditioner its fixed point is the solution for the
// given compliance, and it reports failure to converge.
#include "contact/solve/defect_correction.hpp"

#include "base/errors.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"

#include "support/test.hpp"
#include "support/thesis_cases.hpp"

namespace {

using rollfem::halfspace::HalfspaceCompliance;

/// Rolling ball of 6 mm patch radius under 82 kN, braked and sliding sideways with spin.
struct Ball {
  ContactGrid grid = ContactGrid::centred(28, 26, 0.6, 0.6);
  ContactConditions conditions;
  PointProblem problem{conditions, {82e3, {}}, {slip_of(grid, {1e-3, 5e-4, 1e-4})}};

  Ball() {
    conditions.undeformed_distance =
        grid.sample([](double x, double y) { return (x * x + y * y) / 800.0; });
    conditions.friction = coulomb(0.3);
  }
};

Preconditioner preconditioner(const HalfspaceCompliance& half) {
  return {half, half.normal(), half.rolling(UpwindOrder::second), UpwindOrder::second};
}

double relative_difference(const Field& a, const Field& b) {
  return (a - b).norm() / b.norm();
}

/// A compliance that is wanted, and the half-space of other bodies.
struct Pair : Ball {
  HalfspaceCompliance wanted{grid, alike(70e3, 0.33)};
  HalfspaceCompliance other{grid, alike(82e3, 0.28)};
};

}  // namespace

TEST(DefectCorrection, ReachesTheSolutionOfTheComplianceNotOfThePreconditioner) {
  const Pair scene;
  OuterOptions options;
  options.tolerance = 1e-8;
  std::vector<double> residuals;
  const ContactState corrected =
      solve_coupled(scene.wanted, preconditioner(scene.other), scene.problem, options, {},
                    [&](const ContactState& state) { residuals.push_back(state.residual); });
  const ContactState direct =
      solve_coupled(scene.wanted, preconditioner(scene.wanted), scene.problem, options);

  EXPECT_EQ(direct.iterations, 1);
  EXPECT_LE(corrected.iterations, 15);
  EXPECT_LT(residuals.back(), 1e-6 * residuals.front());
  EXPECT_LT(relative_difference(corrected.normal.pressure, direct.normal.pressure), 1e-6);
  EXPECT_LT(relative_difference(corrected.tangential.traction.x, direct.tangential.traction.x),
            1e-5);
  EXPECT_LT(relative_difference(corrected.tangential.traction.y, direct.tangential.traction.y),
            1e-5);
  EXPECT_NEAR(corrected.normal.approach / direct.normal.approach, 1.0, 1e-7);
}

TEST(DefectCorrection, AStartFromTheDefectIsAtTheSolution) {
  const Pair scene;
  const ContactState cold = solve_coupled(scene.wanted, preconditioner(scene.other), scene.problem);
  const ContactState warm =
      solve_coupled(scene.wanted, preconditioner(scene.other), scene.problem, {}, cold.defect);
  EXPECT_GT(cold.iterations, 2);
  EXPECT_LE(warm.iterations, 2);
}

TEST(DefectCorrection, SaysSoWhenItDoesNotConverge) {
  const Pair scene;
  OuterOptions options;
  options.max_iterations = 2;
  EXPECT_THROW(solve_coupled(scene.wanted, preconditioner(scene.other), scene.problem, options),
               SolveError);
}

TEST(DefectCorrection, FrictionlessContactHasNoTangentialTractions) {
  Ball scene;
  scene.problem.motion.rigid_slip = {};
  const HalfspaceCompliance half(scene.grid, alike(82e3, 0.28));
  const ContactState solution = solve_coupled(half, preconditioner(half), scene.problem);
  EXPECT_EQ(solution.tangential.traction.x.size(), 0);
  EXPECT_NEAR(solution.normal.pressure.sum() * scene.grid.element_area(), 82e3, 1e-3);
}

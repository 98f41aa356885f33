// The outer contact iteration: whatever preconditions it, its fixed point is the solution with the
// compliance it was given, and it says so when it does not get there.
#include "contact/solve/defect_correction.hpp"

#include "contact/base/errors.hpp"
#include "halfspace/elasticity/compliance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using namespace rollfem::contact;
using rollfem::halfspace::HalfspaceCompliance;

CombinedMaterial material(double shear_modulus, double poisson_ratio) {
  CombinedMaterial result;
  result.shear_modulus = shear_modulus;
  result.poisson_ratio = poisson_ratio;
  result.contact_modulus = shear_modulus / (1.0 - poisson_ratio);
  return result;
}

/// Rolling ball of 6 mm patch radius under 82 kN, braked and sliding sideways with spin.
struct Ball {
  ContactGrid grid = ContactGrid::centred(28, 26, 0.6, 0.6);
  CoupledProblem problem;

  Ball() {
    problem.undeformed_distance =
        grid.sample([](double x, double y) { return (x * x + y * y) / 800.0; });
    problem.load.force = 82e3;
    problem.friction = coulomb(0.3);
    problem.rigid_slip.x = grid.sample([](double, double y) { return 1e-3 - 1e-4 * y; });
    problem.rigid_slip.y = grid.sample([](double x, double) { return 5e-4 + 1e-4 * x; });
  }
};

Preconditioner preconditioner(const HalfspaceCompliance& half) {
  return {half, half.normal(), half.rolling(UpwindOrder::second), UpwindOrder::second};
}

double relative_difference(const Field& a, const Field& b) {
  return (a - b).norm() / b.norm();
}

}  // namespace

TEST(DefectCorrection, ReachesTheSolutionOfTheComplianceNotOfThePreconditioner) {
  const Ball scene;
  const HalfspaceCompliance wanted(scene.grid, material(70e3, 0.33));
  const HalfspaceCompliance other(scene.grid, material(82e3, 0.28));
  OuterOptions options;
  options.tolerance = 1e-8;
  std::vector<double> residuals;
  const CoupledSolution corrected =
      solve_coupled(wanted, preconditioner(other), scene.problem, options, {},
                    [&](const CoupledSolution& state) { residuals.push_back(state.residual); });
  const CoupledSolution direct =
      solve_coupled(wanted, preconditioner(wanted), scene.problem, options);

  EXPECT_EQ(direct.outer_iterations, 1);
  EXPECT_LE(corrected.outer_iterations, 15);
  EXPECT_LT(residuals.back(), 1e-6 * residuals.front());
  EXPECT_LT(relative_difference(corrected.normal.pressure, direct.normal.pressure), 1e-6);
  EXPECT_LT(relative_difference(corrected.tangential.traction.x, direct.tangential.traction.x),
            1e-5);
  EXPECT_LT(relative_difference(corrected.tangential.traction.y, direct.tangential.traction.y),
            1e-5);
  EXPECT_NEAR(corrected.normal.approach / direct.normal.approach, 1.0, 1e-7);
}

TEST(DefectCorrection, AStartFromTheDefectIsAtTheSolution) {
  const Ball scene;
  const HalfspaceCompliance wanted(scene.grid, material(70e3, 0.33));
  const HalfspaceCompliance other(scene.grid, material(82e3, 0.28));
  const CoupledSolution cold = solve_coupled(wanted, preconditioner(other), scene.problem);
  const CoupledSolution warm =
      solve_coupled(wanted, preconditioner(other), scene.problem, {}, cold.defect);
  EXPECT_GT(cold.outer_iterations, 2);
  EXPECT_LE(warm.outer_iterations, 2);
}

TEST(DefectCorrection, SaysSoWhenItDoesNotConverge) {
  const Ball scene;
  const HalfspaceCompliance wanted(scene.grid, material(70e3, 0.33));
  const HalfspaceCompliance other(scene.grid, material(82e3, 0.28));
  OuterOptions options;
  options.max_iterations = 2;
  EXPECT_THROW(solve_coupled(wanted, preconditioner(other), scene.problem, options), SolveError);
}

TEST(DefectCorrection, FrictionlessContactHasNoTangentialTractions) {
  Ball scene;
  scene.problem.rigid_slip = {};
  const HalfspaceCompliance half(scene.grid, material(82e3, 0.28));
  const CoupledSolution solution = solve_coupled(half, preconditioner(half), scene.problem);
  EXPECT_EQ(solution.tangential.traction.x.size(), 0);
  EXPECT_NEAR(solution.normal.pressure.sum() * scene.grid.element_area(), 82e3, 1e-3);
}

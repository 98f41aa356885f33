// SPDX-License-Identifier: LGPL-2.1-or-later
// Steady rolling on the half-space: cost, Coulomb's law, and invariants (CONTACT, converged values
// and error bars: the book).
#include "contact/iteration/tangential.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/model/halfspace_model.hpp"

#include "support/test.hpp"
#include "support/thesis_cases.hpp"

namespace {

using halfspace::HalfspaceCompliance;

TangentialSolution solve_benchmark_9(int across, UpwindOrder order,
                                     const contact::Creepage& creepage = Benchmark9().creepage) {
  Benchmark9 benchmark;
  benchmark.creepage = creepage;
  const ContactGrid grid = benchmark.grid(across);
  const HalfspaceCompliance compliance(grid, Benchmark9::material());
  return contact::solve_tangential(compliance.rolling(order), benchmark.problem(grid));
}

/// Root mean square of p - Proj(p - r w), with w of these tractions and the projection worked out
/// here, over that of the bound; r is worth the largest bound at the rigid slip.
double left_of_coulomb(int across, const TangentialSolution& s) {
  const Benchmark9 benchmark;
  const ContactGrid grid = benchmark.grid(across);
  const TangentialProblem problem = benchmark.problem(grid);
  const HalfspaceCompliance compliance(grid, Benchmark9::material());
  const contact::TangentialField moved = compliance.rolling(UpwindOrder::second).apply(s.traction);
  const Field g = benchmark.friction * problem.pressure;
  const double r = g.maxCoeff() / std::hypot(1e-3, 5e-4);
  double left = 0.0;
  for (int k = 0; k < grid.size(); ++k) {
    const double qx = s.traction.x[k] - r * (problem.motion.rigid_slip.x[k] + moved.x[k]);
    const double qy = s.traction.y[k] - r * (problem.motion.rigid_slip.y[k] + moved.y[k]);
    const double size = std::hypot(qx, qy);
    const double factor = size > g[k] ? g[k] / size : 1.0;
    left += std::pow(s.traction.x[k] - factor * qx, 2) + std::pow(s.traction.y[k] - factor * qy, 2);
  }
  return std::sqrt(left) / g.norm();
}

TEST(SteadyRolling, NewtonTakesFewStepsAndEndsFast) {
  for (const int across : {10, 20, 40, 80}) {
    const TangentialSolution s = solve_benchmark_9(across, UpwindOrder::second);
    EXPECT_LE(s.newton_steps, 9) << across;
    EXPECT_LE(s.krylov_iterations, 60) << across;
    EXPECT_LE(left_of_coulomb(across, s), 2e-6) << across;
  }
  // One step more than needed for 1e-6 must gain at least three digits: superlinear.
  const Benchmark9 benchmark;
  const ContactGrid grid = benchmark.grid(40);
  const HalfspaceCompliance compliance(grid, Benchmark9::material());
  contact::TangentialOptions tight;
  tight.tolerance = 1e-6;
  const TangentialSolution s = contact::solve_tangential(compliance.rolling(UpwindOrder::second),
                                                         benchmark.problem(grid), tight);
  tight.tolerance = 1e-11;
  const TangentialSolution sharp = contact::solve_tangential(
      compliance.rolling(UpwindOrder::second), benchmark.problem(grid), tight);
  EXPECT_LE(sharp.newton_steps, s.newton_steps + 2);
}

TEST(SteadyRolling, ReversedCreepageReversesTractions) {
  const TangentialSolution s = solve_benchmark_9(20, UpwindOrder::second, {-1e-3, 5e-4, 1e-4});
  const TangentialSolution r = solve_benchmark_9(20, UpwindOrder::second, {1e-3, -5e-4, -1e-4});
  const double scale = s.traction.x.cwiseAbs().maxCoeff();
  EXPECT_LT((s.traction.x + r.traction.x).cwiseAbs().maxCoeff(), 1e-4 * scale);
  EXPECT_LT((s.traction.y + r.traction.y).cwiseAbs().maxCoeff(), 1e-4 * scale);
}

TEST(SteadyRolling, MirroredSceneGivesMirroredTractions) {
  // y -> -y: xi stays, eta and phi change sign; p_x(x, -y), -p_y(x, -y).
  const TangentialSolution s = solve_benchmark_9(20, UpwindOrder::second, {-1e-3, 5e-4, 1e-4});
  const TangentialSolution m = solve_benchmark_9(20, UpwindOrder::second, {-1e-3, -5e-4, -1e-4});
  const ContactGrid grid = Benchmark9().grid(20);
  const double scale = s.traction.x.cwiseAbs().maxCoeff();
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int k = grid.index(i, j);
      const int l = grid.index(i, grid.ny - 1 - j);
      EXPECT_NEAR(s.traction.x[k], m.traction.x[l], 1e-4 * scale);
      EXPECT_NEAR(s.traction.y[k], -m.traction.y[l], 1e-4 * scale);
    }
}

TEST(CreepCurve, FrictionlessOrZeroCreepageGivesNoTractionAtOnce) {
  Case input = thesis_case('b', 12, {{0.0, 0.0, 0.0}, {1e-3, 0.0, 0.0}});
  const ModelResult still = halfspace::run_halfspace(input, {});
  EXPECT_EQ(still.points[0].max_traction, 0.0);
  EXPECT_EQ(still.points[0].iterations, 0);
  EXPECT_GT(still.points[1].max_traction, 0.0);
  EXPECT_NEAR(still.points[0].adhesion_area, still.points[0].contact_area, 1e-12);
  input.friction_coefficient = 0.0;
  const ModelResult frictionless = halfspace::run_halfspace(input, {});
  EXPECT_EQ(frictionless.points[1].max_traction, 0.0);
  EXPECT_EQ(frictionless.points[1].adhesion_area, 0.0);
}

}  // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Steady rolling on the half-space against CONTACT, converged values and invariants.
#include "contact/iteration/tangential.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/model/halfspace_model.hpp"

#include "support/contact_of_case_a.hpp"
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

Forces forces_of_benchmark_9(int across, UpwindOrder order,
                             const contact::Creepage& creepage = Benchmark9().creepage) {
  return rollfem::testing::forces(Benchmark9().grid(across),
                                  solve_benchmark_9(across, order, creepage).traction);
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

TEST(SteadyRolling, SecondOrderReachesTheConvergedForcesAt20Across) {
  // Converged values of benchmark 9, reference/benchmarks.md: 10 240 +- 5 N, 1150 +- 10 N mm.
  const Forces f = forces_of_benchmark_9(20, UpwindOrder::second);
  EXPECT_NEAR(f.x, 10240.0, 0.005 * 10240.0);  // negative creepage drives: F_x on the wheel > 0
  EXPECT_NEAR(f.y, -7057.0, 0.01 * 7057.0);
  EXPECT_NEAR(f.moment, -1150.0, 0.06 * 1150.0);
}

TEST(SteadyRolling, BothOrdersConvergeToTheSameForces) {
  const Forces first_40 = forces_of_benchmark_9(40, UpwindOrder::first);
  const Forces first_80 = forces_of_benchmark_9(80, UpwindOrder::first);
  const Forces second = forces_of_benchmark_9(80, UpwindOrder::second);
  // First order by Richardson with order 1.
  EXPECT_NEAR((2.0 * first_80.x - first_40.x) / second.x, 1.0, 0.003);
  EXPECT_LT(std::abs(first_80.x - second.x), 0.6 * std::abs(first_40.x - second.x));
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

/// Creep curve of a thesis case by the model; {xi, Fx/Fz}.
ModelResult creep_curve(char name, int across, const std::vector<double>& xi,
                        UpwindOrder order = UpwindOrder::second) {
  Case input = thesis_case(name, across, along(xi));
  input.rolling.upwind_order = order;
  return halfspace::run_halfspace(input, {});
}

TEST(CreepCurve, ErrorEstimatesCoverTheErrors) {
  const std::vector<double> xi(case_a::creepages.begin(), case_a::creepages.end() - 1);
  const std::vector<double>& exact = case_a::coefficients;
  for (const int across : {20, 40}) {
    const ModelResult result = creep_curve('a', across, xi);
    for (std::size_t k = 0; k < xi.size(); ++k) {
      const contact::PointResult& point = result.points[k];
      const auto covers = [&](const char* name, double value, double truth, double slack) {
        const double estimate = point.error_estimate.at(name);
        EXPECT_LE(std::abs(value - truth), estimate + slack)
            << name << " at " << xi[k] << ", " << across;
        EXPECT_LT(estimate, 0.05 * truth) << name;
      };
      covers("max_pressure", point.max_pressure, 578.9674, 0.0);
      covers("approach", point.approach, 0.04731083, 0.0);
      covers("semi_axis_x", point.semi_axis_x, 3.792363, 0.0);
      covers("semi_axis_y", point.semi_axis_y, 10.872949, 0.0);
      covers("traction_coefficient", point.traction_coefficient, exact[k], 5e-4);
    }
  }
}

TEST(CreepCurve, ErrorEstimatesCoverTheErrorsWithSpin) {
  // Cases b and c with all three creepages, against the first-order difference of CONTACT, which
  // does not fit the leading edge: extrapolated from 40 and 80 across with its order.
  struct Row {
    char name;
    contact::Creepage creepage;
  };
  for (const Row& row : {Row{'b', {2e-3, 1e-3, 2e-4}}, Row{'c', {1e-3, 1e-3, 3e-4}}}) {
    Case input = thesis_case(row.name, 40, {row.creepage});
    const auto solved = [&](int across, UpwindOrder order) {
      input.contact_grid.elements_across = across;
      input.rolling.upwind_order = order;
      return halfspace::run_halfspace(input, {}).points[0];
    };
    const contact::PointResult middle = solved(40, UpwindOrder::first);
    const contact::PointResult fine = solved(80, UpwindOrder::first);
    for (const int across : {20, 40}) {
      const contact::PointResult point = solved(across, UpwindOrder::second);
      // `slack`: of the extrapolation itself.
      const auto covers = [&](const char* name, double contact::PointResult::*of, double slack) {
        const double limit = 2.0 * (fine.*of) - middle.*of;
        EXPECT_NEAR(point.*of, limit, point.error_estimate.at(name) + slack)
            << name << ", case " << row.name << ", " << across;
      };
      covers("longitudinal_force", &contact::PointResult::longitudinal_force, 30.0);
      covers("lateral_force", &contact::PointResult::lateral_force, 30.0);
      covers("spin_moment", &contact::PointResult::spin_moment, 100.0);
    }
  }
}

/// contact_tangential.csv, case c: CONTACT's Fx/Fz at 40 and 80 elements across.
struct ContactRow {
  double xi, at_40, at_80;
};
constexpr ContactRow case_c[] = {{0.001, 0.13514831, 0.13354435},
                                 {0.002, 0.24755009, 0.24488792},
                                 {0.004, 0.41046727, 0.40748153}};

TEST(CreepCurve, OfCaseCWithFirstOrderIsContactsOnTheSameGrid) {
  for (const int across : {40, 80}) {
    const ModelResult result = creep_curve('c', across, {0.001, 0.002, 0.004}, UpwindOrder::first);
    for (std::size_t k = 0; k < std::size(case_c); ++k)
      EXPECT_NEAR(result.points[k].traction_coefficient,
                  across == 40 ? case_c[k].at_40 : case_c[k].at_80, 2e-4)
          << case_c[k].xi << ", " << across;
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

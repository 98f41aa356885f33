// SPDX-License-Identifier: LGPL-2.1-or-later
// The normal solver on problems where half-space codes tend to fail, each with a known answer.
#include "base/errors.hpp"
#include "contact/iteration/normal.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"

#include "support/temporary_folder.hpp"
#include "support/thesis_cases.hpp"

namespace {

using halfspace::HalfspaceCompliance;
using halfspace::HertzContact;

NormalSolution solve_hertz(double A, double B, const contact::CombinedMaterial& material,
                           double force, int nx, int ny) {
  const HertzContact hertz = halfspace::hertz_from_force(A, B, material.contact_modulus, force);
  const ContactGrid grid = ContactGrid::centred(nx + 6, ny + 6, 2.0 * hertz.semi_axis_x / nx,
                                                2.0 * hertz.semi_axis_y / ny);
  const HalfspaceCompliance compliance(grid, material);
  NormalProblem problem;
  problem.undeformed_distance =
      grid.sample([&](double x, double y) { return A * x * x + B * y * y; });
  problem.normal_force = force;
  return contact::solve_normal(compliance.normal(), problem);
}

TEST(HardNormal, ExtremeAspectRatiosGiveHertz) {
  for (const auto& [A, B] : {std::pair{1e-2, 1e-5}, {1e-5, 1e-2}}) {
    const contact::CombinedMaterial material = steel();
    const HertzContact hertz = halfspace::hertz_from_force(A, B, material.contact_modulus, 1e4);
    const double aspect = hertz.semi_axis_x / hertz.semi_axis_y;
    EXPECT_TRUE(aspect < 0.02 || aspect > 50.0) << aspect;
    const NormalSolution s = solve_hertz(A, B, material, 1e4, 40, 40);
    EXPECT_NEAR(s.pressure.maxCoeff() / hertz.max_pressure, 1.0, 0.001);
    EXPECT_NEAR(s.approach / hertz.approach, 1.0, 0.001);
  }
}

TEST(HardNormal, OneNewtonToTenMeganewtonIsTheSameContact) {
  const contact::Curvatures c = contact::relative_curvatures(thesis_case('a'));
  const NormalSolution reference = solve_hertz(c.A, c.B, steel(), 1.0, 20, 20);
  for (const double force : {1e-6, 50e3, 1e7, 1e12}) {
    const NormalSolution s = solve_hertz(c.A, c.B, steel(), force, 20, 20);
    EXPECT_NEAR(s.pressure.maxCoeff() / std::cbrt(force) / reference.pressure.maxCoeff(), 1.0,
                1e-6);
    EXPECT_EQ(s.contact_elements, reference.contact_elements);
    EXPECT_LE(s.iterations, reference.iterations + 4);
  }
}

TEST(HardNormal, PoissonRatiosAtBothEnds) {
  for (const double nu : {0.0, 0.4999}) {
    const contact::CombinedMaterial material = contact::combine({210e3, nu}, {210e3, nu});
    const HertzContact hertz =
        halfspace::hertz_from_force(1e-3, 2e-3, material.contact_modulus, 1e4);
    EXPECT_NEAR(
        solve_hertz(1e-3, 2e-3, material, 1e4, 30, 30).pressure.maxCoeff() / hertz.max_pressure,
        1.0, 0.0015);
  }
}

TEST(HardNormal, CellsOfEightToOneAndFewElements) {
  const double p0 =
      halfspace::hertz_from_force(1e-3, 1e-3, steel().contact_modulus, 1e4).max_pressure;
  EXPECT_NEAR(solve_hertz(1e-3, 1e-3, steel(), 1e4, 10, 80).pressure.maxCoeff() / p0, 1.0, 0.01);
  EXPECT_NEAR(solve_hertz(1e-3, 1e-3, steel(), 1e4, 80, 10).pressure.maxCoeff() / p0, 1.0, 0.01);
  EXPECT_NEAR(solve_hertz(1e-3, 1e-3, steel(), 1e4, 4, 4).pressure.maxCoeff() / p0, 1.0, 0.07);
  // One element carries everything.
  const ContactGrid grid = ContactGrid::centred(5, 5, 1.0, 1.0);
  const HalfspaceCompliance compliance(grid, steel());
  NormalProblem problem;
  problem.undeformed_distance = grid.sample([](double x, double y) { return x * x + y * y; });
  problem.normal_force = 1.0;
  const NormalSolution s = contact::solve_normal(compliance.normal(), problem);
  EXPECT_EQ(s.contact_elements, 1);
  EXPECT_NEAR(s.pressure.maxCoeff(), 1.0, 1e-12);
}

TEST(HardNormal, TwoPatchesShareTheForce) {
  const double radius_term = 1e-3;
  const double force = 1e4;
  const double modulus = steel().contact_modulus;
  const HertzContact half =
      halfspace::hertz_from_force(radius_term, radius_term, modulus, 0.5 * force);
  const double a = half.semi_axis_x;
  const double distance = 12.0 * a;
  const ContactGrid grid = ContactGrid::centred(180, 32, a / 12, a / 12);
  const HalfspaceCompliance compliance(grid, steel());
  NormalProblem problem;
  problem.undeformed_distance = grid.sample([&](double x, double y) {
    const double from_nearer = std::abs(x) - 0.5 * distance;
    return radius_term * (from_nearer * from_nearer + y * y);
  });
  problem.normal_force = force;
  const NormalSolution s = contact::solve_normal(compliance.normal(), problem);
  EXPECT_NEAR(s.pressure.maxCoeff() / half.max_pressure, 1.0, 0.003);
  // The other patch presses as a point load: it deepens the approach by F/2 / (pi E* d).
  EXPECT_NEAR(s.approach, half.approach + 0.5 * force / (M_PI * modulus * distance),
              0.003 * half.approach);
  const Field& p = s.pressure;
  for (int j = 0; j < grid.ny; ++j) {
    EXPECT_EQ(p[grid.index(89, j)], 0.0);
    EXPECT_EQ(p[grid.index(90, j)], 0.0);
  }
  double left = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < 90; ++i) left += p[grid.index(i, j)];
  EXPECT_NEAR(left / p.sum(), 0.5, 1e-6);
}

TEST(HardNormal, AnyStartGivesTheSamePressure) {
  const ContactGrid grid = ContactGrid::centred(30, 30, 0.5, 0.5);
  const HalfspaceCompliance compliance(grid, steel());
  NormalProblem problem;
  problem.undeformed_distance =
      grid.sample([](double x, double y) { return 1e-3 * x * x + 2e-3 * y * y; });
  problem.approach = 0.05;
  const NormalSolution s = contact::solve_normal(compliance.normal(), problem);
  Field corner = Field::Zero(grid.size());
  corner[0] = 1e6;
  for (const Field& start :
       {corner, Field(Field::Constant(grid.size(), 1e5)), Field(Field::Zero(grid.size())),
        Field(Field::Constant(grid.size(), -1.0))}) {
    const NormalSolution other = contact::solve_normal(compliance.normal(), problem, {}, start);
    EXPECT_LT((other.pressure - s.pressure).cwiseAbs().maxCoeff(), 1e-5 * s.pressure.maxCoeff());
    NormalProblem with_force = problem;
    with_force.approach.reset();
    with_force.normal_force = s.normal_force;
    const NormalSolution third = contact::solve_normal(compliance.normal(), with_force, {}, start);
    EXPECT_NEAR(third.approach, 0.05, 1e-8);
  }
}

TEST(HardNormal, OffsetOfTheDistanceOnlyShiftsTheApproach) {
  const ContactGrid grid = ContactGrid::centred(30, 30, 0.5, 0.5);
  const HalfspaceCompliance compliance(grid, steel());
  NormalProblem problem;
  problem.undeformed_distance =
      grid.sample([](double x, double y) { return 1e-3 * (x * x + y * y); });
  problem.normal_force = 5e3;
  const NormalSolution s = contact::solve_normal(compliance.normal(), problem);
  for (const double offset : {-7.0, 1000.0}) {
    NormalProblem shifted = problem;
    shifted.undeformed_distance.array() += offset;
    const NormalSolution other = contact::solve_normal(compliance.normal(), shifted);
    EXPECT_NEAR(other.approach - offset, s.approach, 1e-9);
    EXPECT_EQ(other.contact_elements, s.contact_elements);
  }
}

TEST(HardNormal, NoContactIsAClearError) {
  const ContactGrid grid = ContactGrid::centred(8, 8, 0.5, 0.5);
  const HalfspaceCompliance compliance(grid, steel());
  NormalProblem problem;
  problem.undeformed_distance = grid.sample([](double x, double y) { return 0.1 + x * x + y * y; });
  const auto error = [&](const HalfspaceCompliance& of,
                         const contact::NormalOptions& options = {}) {
    return refusal<contact::SolveError>(
        [&] { contact::solve_normal(of.normal(), problem, options); });
  };
  for (const double approach : {0.05, -1.0, std::nan("")}) {
    problem.approach = approach;
    EXPECT_TRUE(says(error(compliance), "no contact")) << approach;
  }
  problem.approach.reset();
  for (const double force : {-5.0, std::nan("")}) {
    problem.normal_force = force;
    EXPECT_TRUE(says(error(compliance), "no contact")) << force;
  }
  problem.normal_force = 0.0;  // they just touch
  const contact::NormalSolution touching = contact::solve_normal(compliance.normal(), problem, {});
  EXPECT_EQ(touching.approach, problem.undeformed_distance.minCoeff());
  EXPECT_EQ(touching.gap.minCoeff(), 0.0);
  EXPECT_EQ(touching.pressure.maxCoeff(), 0.0);
  problem.normal_force = 1.0;
  problem.approach = 1.0;
  EXPECT_TRUE(says(error(compliance), "exactly one"));
  problem.approach.reset();
  const ContactGrid fine = ContactGrid::centred(30, 30, 0.2, 0.3);
  contact::NormalOptions options;
  options.max_iterations = 2;
  problem.undeformed_distance =
      fine.sample([](double x, double y) { return 1e-3 * x * x + 3e-3 * y * y; });
  problem.normal_force = 1e3;
  EXPECT_TRUE(says(error(HalfspaceCompliance(fine, steel()), options), "did not converge"));
}

}  // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Coulomb's law, and another law that needs only a class: friction falling with slip, defined here,
// in the tangential problem.
#include "contact/scene/friction_law.hpp"

#include "contact/iteration/tangential.hpp"
#include "halfspace/elasticity/compliance.hpp"

#include <gtest/gtest.h>

#include "support/thesis_cases.hpp"
#include <algorithm>
#include <cmath>

namespace rollfem::contact {
namespace {

/// mu = mu_s / (1 + |w| / w0).
class FallingFriction : public FrictionLaw {
 public:
  FallingFriction(double at_rest, double scale) : at_rest_(at_rest), scale_(scale) {}
  Bound bound(double pressure, double slip) const override {
    const double mu = at_rest_ / (1.0 + slip / scale_);
    return {mu * pressure, mu, -mu * pressure / (scale_ + slip)};
  }
  bool feels_slip() const override { return true; }
  double coefficient() const override { return at_rest_; }

 private:
  double at_rest_;
  double scale_;
};

/// T = c I: every element on its own.
class Springs : public TangentialOperator {
 public:
  Springs(const ContactGrid& grid, double c) : grid_(grid), c_(c) {}
  const ContactGrid& grid() const override { return grid_; }
  TangentialField apply(const TangentialField& p) const override { return {c_ * p.x, c_ * p.y}; }
  double diagonal() const override { return c_; }
  TangentialField precondition(const TangentialField& residual, double r,
                               double shift) const override {
    const double inverse = 1.0 / (r * c_ + shift);
    return {inverse * residual.x, inverse * residual.y};
  }

 private:
  ContactGrid grid_;
  double c_;
};

void expect_derivatives(const FrictionLaw& law, double pressure, double slip) {
  const FrictionLaw::Bound at = law.bound(pressure, slip);
  const double dp = 1e-5 * pressure;
  const double dw = 1e-5 * slip;
  EXPECT_NEAR(
      (law.bound(pressure + dp, slip).value - law.bound(pressure - dp, slip).value) / (2.0 * dp),
      at.by_pressure, 1e-8);
  EXPECT_NEAR(
      (law.bound(pressure, slip + dw).value - law.bound(pressure, slip - dw).value) / (2.0 * dw),
      at.by_slip, 1e-7 * std::max(1.0, std::abs(at.by_slip)));
}

TEST(FrictionLaws, DerivativesAreThoseOfTheBound) {
  for (const double pressure : {1.0, 800.0})
    for (const double slip : {1e-5, 1e-3, 0.1}) {
      expect_derivatives(CoulombFriction(0.3), pressure, slip);
      expect_derivatives(FallingFriction(0.3, 2e-3), pressure, slip);
    }
}

TEST(FrictionLaws, CoulombsBoundIsThePressureTimesMuAtAnySlip) {
  const Field pressure = Field::LinSpaced(5, 0.0, 1000.0);
  const TangentialField slip{Field::Ones(5), Field::Ones(5)};
  EXPECT_EQ((traction_bound(coulomb(0.3), pressure, slip) - 0.3 * pressure).norm(), 0.0);
  EXPECT_EQ(traction_bound(nullptr, pressure).norm(), 0.0);
  EXPECT_EQ(coulomb(0.0), nullptr);
  EXPECT_EQ(coefficient_of(nullptr), 0.0);
  EXPECT_EQ(coefficient_of(coulomb(0.3)), 0.3);
}

TEST(SecondFrictionLaw, OfSpringsIsTheRootOfAQuadratic) {
  // |w| + c g(|w|) = s where it slips: w^2 + (w0 - s) w + (c mu p - s) w0 = 0, once s > c mu p.
  const ContactGrid grid = ContactGrid::centred(3, 1, 1.0, 1.0);
  const double c = 1e-5;
  const double w0 = 5e-3;
  const double s = 2e-3;
  const double factor = 0.5;  // slip of the law over that of the problem
  TangentialProblem problem;
  problem.friction = std::make_shared<FallingFriction>(0.3, factor * w0);
  problem.slip_factor = factor;
  problem.pressure = Field::Zero(3);
  problem.pressure << 100.0, 500.0, 1000.0;
  problem.rigid_slip = {Field::Constant(3, 0.6 * s), Field::Constant(3, 0.8 * s)};
  TangentialOptions options;
  options.tolerance = 1e-10;
  const TangentialSolution solution = solve_tangential(Springs(grid, c), problem, options);
  for (int k = 0; k < 3; ++k) {
    const double rest = c * 0.3 * problem.pressure[k];
    const double half = 0.5 * (w0 - s);
    const double w = rest < s ? -half + std::sqrt(half * half + (s - rest) * w0) : 0.0;
    EXPECT_EQ(solution.state[static_cast<std::size_t>(k)],
              rest < s ? ElementState::slip : ElementState::adhesion);
    EXPECT_NEAR(std::hypot(solution.slip.x[k], solution.slip.y[k]), w, 1e-9 * s);
    EXPECT_NEAR(solution.traction.x[k], -0.6 * (s - w) / c, 1e-6);
    EXPECT_NEAR(solution.traction.y[k], -0.8 * (s - w) / c, 1e-6);
  }
}

TEST(SecondFrictionLaw, OfARollingBallHoldsTheLawAtEveryElement) {
  const rollfem::testing::Benchmark9 ball;
  const ContactGrid grid = ball.grid(24);
  const halfspace::HalfspaceCompliance compliance(grid, ball.material());
  TangentialProblem problem = ball.problem(grid);
  const TangentialOperator& rolling = compliance.rolling(UpwindOrder::second);
  const double coulomb_force =
      rollfem::testing::forces(grid, solve_tangential(rolling, problem).traction).x;
  const FallingFriction law(ball.friction, 1.5e-2);
  problem.friction = std::make_shared<FallingFriction>(law);
  const TangentialSolution s = solve_tangential(rolling, problem);
  EXPECT_LE(s.newton_steps, 8);
  int slipping = 0;
  for (int k = 0; k < grid.size(); ++k) {
    const double p = std::hypot(s.traction.x[k], s.traction.y[k]);
    const double w = std::hypot(s.slip.x[k], s.slip.y[k]);
    const double g = law.bound(problem.pressure[k], w).value;
    EXPECT_LE(p, g * (1.0 + 1e-5) + 1e-12);
    if (s.state[static_cast<std::size_t>(k)] != ElementState::slip) continue;
    ++slipping;
    EXPECT_NEAR(p / g, 1.0, 2e-5);
    EXPECT_NEAR(s.traction.x[k] * s.slip.x[k] + s.traction.y[k] * s.slip.y[k], -g * w,
                1e-4 * g * w);
  }
  EXPECT_GT(slipping, 100);
  const double force = rollfem::testing::forces(grid, s.traction).x;
  EXPECT_LT(std::abs(force), 0.99 * std::abs(coulomb_force));  // less friction where it slips
  // A scale of slip beyond all slips is Coulomb's law.
  problem.friction = std::make_shared<FallingFriction>(ball.friction, 1e6);
  EXPECT_NEAR(rollfem::testing::forces(grid, solve_tangential(rolling, problem).traction).x,
              coulomb_force, 1e-5 * std::abs(coulomb_force));
}

}  // namespace
}  // namespace rollfem::contact

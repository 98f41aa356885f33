// SPDX-License-Identifier: LGPL-2.1-or-later
// Coulomb's law and friction that falls with slip: formulas, and in the tangential problem.
#include "scene/friction_law.hpp"

#include "halfspace/elasticity/halfspace_compliance.hpp"

#include "support/springs.hpp"
#include "support/thesis_cases.hpp"

namespace rollfem::contact {
namespace {

/// mu = mu_s / (1 + |w| / w0).
FallingFriction hyperbola(double at_rest, double scale) {
  return {FallShape::rational, 0.0, {{{at_rest, scale}, {}}}};
}

TEST(FrictionLaws, DerivativesAreThoseOfTheCoefficient) {
  const std::array<FallingFriction::Part, 2> parts{{{0.1, 2e-3}, {0.07, 3e-2}}};
  for (const FallShape& shape : {FallShape::linear, FallShape::rational, FallShape::exponential})
    for (const double slip : {1e-5, 1e-3, 3e-2, 0.2}) {
      const FallingFriction law(shape, 0.14, parts);
      const double dw = 1e-4 * slip;
      EXPECT_NEAR((law.at(slip + dw).value - law.at(slip - dw).value) / (2.0 * dw),
                  law.at(slip).by_slip, 1e-6 * std::max(1.0, std::abs(law.at(slip).by_slip)));
    }
}

TEST(FrictionLaws, AreHalvedAtTheirVelocities) {
  // mu_kin + mu_1/2 + mu_2 f(s_h1/s_h2) at s_h1, by the formulas of the laws.
  const std::array<FallingFriction::Part, 2> parts{{{0.12, 2e-3}, {0.06, 8e-3}}};
  const std::vector<std::pair<FallShape, double>> left{{FallShape::linear, 1.0 - 1.0 / 8.0},
                                                       {FallShape::rational, 16.0 / 17.0},
                                                       {FallShape::exponential, std::exp2(-0.25)}};
  for (const auto& [shape, second] : left) {
    const FallingFriction law(shape, 0.14, parts);
    EXPECT_NEAR(law.coefficient(), 0.32, 1e-15);
    EXPECT_NEAR(law.at(2e-3).value, 0.14 + 0.06 + 0.06 * second, 1e-15);
    EXPECT_NEAR(law.at(1e6).value, 0.14, 1e-8);
  }
}

TEST(FrictionLaws, OfACaseTakeSpeedAndPolachsSpelling) {
  Case input;
  input.friction_coefficient = 0.33;
  EXPECT_FALSE(friction_of(input)->feels_slip());
  input.rolling.speed = 10e3;
  input.friction_fall.shape = FallShape::exponential;
  input.friction_fall.polach_a = 0.4;
  input.friction_fall.polach_b = 0.6;
  // mu ((1 - A) exp(-B s) + A) at 2 % of 10 m/s (Polach, Wear 258 (2005)).
  EXPECT_NEAR(friction_of(input)->at(0.02).value, 0.33 * (0.6 * std::exp(-0.6 * 0.2) + 0.4), 1e-14);
  input.friction_fall.memory_distance = 3e-3;
  input.friction_fall.memory_velocity = 5.0;
  EXPECT_EQ(friction_of(input)->memory()->distance, 3e-3);
  EXPECT_EQ(friction_of(input)->memory()->least_slip, 5e-4);
  input.friction_fall = {};
  input.friction_fall.shape = FallShape::linear;
  input.friction_fall.kinetic_coefficient = 0.2;
  input.friction_fall.half_velocity = 100.0;
  EXPECT_NEAR(friction_of(input)->at(0.01).value, 0.2 + 0.13 * 0.5, 1e-15);
  input.rolling.problem = Problem::shift;  // mm of one second
  EXPECT_NEAR(friction_of(input)->at(100.0).value, 0.2 + 0.13 * 0.5, 1e-15);
}

TEST(FrictionLaws, HaveConstantsOfTheirOwn) {
  const FallShape power{"power",
                        [](std::size_t, double s, const FallShape::Constants& own) {
                          return FallShape::Left{std::exp2(-std::pow(s, own[1])), 0.0};
                        },
                        false,
                        {{{}, {"power_of_slip", "n", 1.0, 10.0, 1.0, ""}}}};
  Case input;
  input.friction_coefficient = 0.4;
  input.rolling.speed = 10e3;
  FrictionFall& fall = input.friction_fall;
  fall.shape = power;
  fall.kinetic_coefficient = 0.2;
  fall.half_velocity = 500.0;
  EXPECT_NEAR(friction_of(input)->at(0.1).value, 0.2 + 0.2 / 4.0, 1e-15);  // at twice s_h
  fall.constants[1] = 2.0;
  EXPECT_NEAR(friction_of(input)->at(0.1).value, 0.2 + 0.2 / 16.0, 1e-15);
  input.friction_variation.lateral_position = {0.0, 1.0};
  input.friction_variation.points = {{0.4, fall}, {0.4, fall}};
  input.friction_variation.points[0].fall.constants[1] = 1.0;
  EXPECT_NEAR(friction_of(input)->of_row(0.5)->at(0.1).value, 0.2 + 0.2 / std::exp2(std::exp2(1.5)),
              1e-15);
}

TEST(FrictionLaws, CoulombsBoundIsThePressureTimesMu) {
  const ContactGrid grid{5, 1, 0.1, 0.1, 0.0, 0.0};
  const Field pressure = Field::LinSpaced(5, 0.0, 1000.0);
  EXPECT_EQ((traction_bound(coulomb(0.3), grid, pressure) - 0.3 * pressure).norm(), 0.0);
  EXPECT_EQ(traction_bound(nullptr, grid, pressure).norm(), 0.0);
  EXPECT_EQ(coulomb(0.3)->at(1e3).value, 0.3);
  EXPECT_EQ(coulomb(0.0), nullptr);
  EXPECT_EQ(coefficient_of(nullptr), 0.0);
  EXPECT_EQ(coefficient_of(coulomb(0.3)), 0.3);
}

TEST(FallingFriction, OfSpringsIsTheRootOfAQuadratic) {
  // |w| + c g(|w|) = s where it slips: w^2 + (w0 - s) w + (c mu p - s) w0 = 0, once s > c mu p.
  const ContactGrid grid = ContactGrid::centred(3, 1, 1.0, 1.0);
  const double c = 1e-5;
  const double w0 = 5e-3;
  const double s = 2e-3;
  const double factor = 0.5;  // slip of the law over that of the problem
  TangentialProblem problem;
  problem.friction = std::make_shared<FallingFriction>(hyperbola(0.3, factor * w0));
  problem.motion.slip_factor = factor;
  problem.pressure = Field::Zero(3);
  problem.pressure << 100.0, 500.0, 1000.0;
  problem.motion.rigid_slip = {Field::Constant(3, 0.6 * s), Field::Constant(3, 0.8 * s)};
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

TEST(FallingFriction, OfSeveralStatesTheOneWithTheMostFrictionIsGiven) {
  // w^2 + (w0 - s) w + (c mu p - s) w0 = 0 has two roots besides adhesion for s from
  // 2 sqrt(c mu p w0) - w0 = 2.46e-3 to c mu p = 3e-3, and one root beyond.
  const ContactGrid grid = ContactGrid::centred(2, 1, 1.0, 1.0);
  const double c = 1e-5;
  TangentialProblem problem;
  problem.friction = std::make_shared<FallingFriction>(hyperbola(0.3, 1e-3));
  problem.pressure = Field::Constant(2, 1000.0);
  problem.motion.rigid_slip = {Field::Zero(2), Field::Zero(2)};
  problem.motion.rigid_slip.x << 2.8e-3, 3.2e-3;
  // From where both slide.
  const TangentialField sliding{Field::Constant(2, -112.0), Field::Zero(2)};
  const TangentialSolution solution = solve_tangential(Springs(grid, c), problem, {}, sliding);
  EXPECT_GT(solution.steepness, 1.0);
  EXPECT_EQ(solution.state[0], ElementState::adhesion);
  EXPECT_NEAR(solution.traction.x[0], -280.0, 1e-3);
  const double w = 1.1e-3 + std::sqrt(1.1e-3 * 1.1e-3 + 0.2e-6);
  EXPECT_EQ(solution.state[1], ElementState::slip);
  EXPECT_NEAR(solution.slip.x[1], w, 1e-7);
  EXPECT_NEAR(solution.traction.x[1], -(3.2e-3 - w) / c, 1e-2);
}

TEST(FallingFriction, OfARollingBallHoldsTheLawAtEveryElement) {
  const Benchmark9 ball;
  const ContactGrid grid = ball.grid(24);
  const halfspace::HalfspaceCompliance compliance(grid, ball.material());
  TangentialProblem problem = ball.problem(grid);
  const TangentialOperator& rolling = compliance.rolling(UpwindOrder::second);
  const double coulomb_force = forces(grid, solve_tangential(rolling, problem).traction).x;
  const FallingFriction law = hyperbola(ball.friction, 1.5e-2);
  problem.friction = std::make_shared<FallingFriction>(law);
  const TangentialSolution s = solve_tangential(rolling, problem);
  EXPECT_LE(s.newton_steps, 8);
  int slipping = 0;
  for (int k = 0; k < grid.size(); ++k) {
    const double p = std::hypot(s.traction.x[k], s.traction.y[k]);
    const double w = std::hypot(s.slip.x[k], s.slip.y[k]);
    const double g = law.at(w).value * problem.pressure[k];
    EXPECT_NEAR(s.bound[k], g, 1e-12 + 1e-9 * g);
    EXPECT_LE(p, g * (1.0 + 1e-5) + 1e-12);
    if (s.state[static_cast<std::size_t>(k)] != ElementState::slip) continue;
    ++slipping;
    EXPECT_NEAR(p / g, 1.0, 2e-5);
    EXPECT_NEAR(s.traction.x[k] * s.slip.x[k] + s.traction.y[k] * s.slip.y[k], -g * w,
                1e-4 * g * w);
  }
  EXPECT_GT(slipping, 100);
  const double force = forces(grid, s.traction).x;
  EXPECT_LT(std::abs(force), 0.99 * std::abs(coulomb_force));  // less friction where it slips
  // A scale of slip beyond all slips is Coulomb's law.
  problem.friction = std::make_shared<FallingFriction>(hyperbola(ball.friction, 1e6));
  EXPECT_NEAR(forces(grid, solve_tangential(rolling, problem).traction).x, coulomb_force,
              1e-5 * std::abs(coulomb_force));
}

}  // namespace
}  // namespace rollfem::contact

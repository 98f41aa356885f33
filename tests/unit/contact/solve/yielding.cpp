// SPDX-License-Identifier: LGPL-2.1-or-later
// A layer that yields: the plastic displacement along a row against closed forms, where yielding
// begins, friction that takes over, steps of a history, and the derivative.

#include "support/friction_row.hpp"

namespace rollfem::contact {
namespace {

using Eigen::VectorXd;

constexpr double mu = 0.5;

CoulombFriction yielding_at(double stress, double hardening) {
  CoulombFriction law(mu);
  law.plasticity = Plasticity{stress, hardening};
  return law;
}

constexpr double highest = 1000.0;

double growing_slip(double x) {
  return 0.02 * (1.0 - x) + 0.01 * (1.0 - x) * (1.0 - x);
}

/// Bounds where mu p_0 sqrt(1 - x) = 200 MPa begins to exceed the yield stress, at 1 - x = 0.16.
double worst_of_bounds(int elements, double hardening) {
  const FrictionRow row(elements, highest);
  const CoulombFriction law = yielding_at(200.0, hardening);
  const TangentialProblem problem{row.pressure, row.still, shared(law)};
  FrictionState state;
  state.begin(row.grid, problem, row.places);
  const VectorXd bound = row.bound(state, row.slip(growing_slip));
  const auto slipped = [](double d) { return 0.01 * d * d + 0.01 / 3.0 * d * d * d; };
  double worst = 0.0;
  for (Eigen::Index e = 0; e < row.count(); ++e) {
    const double d = 1.0 - row.x(e);
    const double plastic = d > 0.16 ? slipped(d) - slipped(0.16) : 0.0;
    const double expected = std::min(mu * highest * std::sqrt(d), 200.0 + hardening * plastic);
    worst = std::max(worst, std::abs(bound[e] - expected));
    EXPECT_EQ(state.yields(e), d > 0.16) << d;
  }
  return worst;
}

TEST(Yielding, PlasticDisplacementIsOfSecondOrderAlongTheRow) {
  for (const double hardening : {4000.0, -4000.0}) {
    const double coarse = worst_of_bounds(10, hardening), middle = worst_of_bounds(20, hardening),
                 fine = worst_of_bounds(40, hardening);
    EXPECT_GT(std::log2(coarse / middle), 1.8);
    EXPECT_GT(std::log2(middle / fine), 1.8);
    EXPECT_LT(fine, 0.05);
  }
}

TEST(Yielding, ConstantSlipGathersFromWhereFrictionReachesTheYieldStress) {
  const FrictionRow row(25, highest);
  const CoulombFriction law = yielding_at(100.0, 2000.0);  // reached at 1 - x = 0.04
  const TangentialMotion motion = row.motion(2.0);         // law's slip is twice
  const TangentialProblem problem{row.pressure, motion, shared(law)};
  FrictionState state;
  state.begin(row.grid, problem, row.places);
  const VectorXd bound = row.bound(state, row.slip([](double) { return 0.01; }));
  for (Eigen::Index e = 0; e < row.count() - 1; ++e) {
    EXPECT_TRUE(state.yields(e));
    EXPECT_NEAR(bound[e], 100.0 + 2000.0 * 0.02 * (1.0 - row.x(e) - 0.04), 1e-9);
  }
  EXPECT_FALSE(state.yields(row.count() - 1));
}

TEST(Yielding, FrictionTakesOverFromALayerThatHardens) {
  FrictionRow row(25, highest);
  row.pressure = (row.pressure.array() > 0.0).select(400.0, row.pressure).eval();
  const CoulombFriction law = yielding_at(100.0, 2000.0);
  const TangentialProblem problem{row.pressure, row.still, shared(law)};
  FrictionState state;
  state.begin(row.grid, problem, row.places);
  const VectorXd bound = row.bound(state, row.slip([](double) { return 0.1; }));
  for (Eigen::Index e = 0; e < row.count(); ++e) {
    const double stress = 100.0 + 2000.0 * 0.1 * (1.0 - row.x(e));
    // Constant pressure has no known edge: yielding begins within the first element.
    EXPECT_NEAR(bound[e], std::min(200.0, stress), 0.5 * 2000.0 * 0.1 * row.grid.dx + 1e-9);
    EXPECT_LE(state.plastic(e), 0.05 + 1e-12);
  }
  EXPECT_FALSE(state.yields(0));
  EXPECT_NEAR(state.plastic(0), 0.05, 1e-12);  // its stress has reached friction
  EXPECT_EQ(bound[0], 200.0);
}

TEST(Yielding, AStepOfAHistoryAddsToWhatTheParticleHas) {
  const FrictionRow row(25, highest);
  const CoulombFriction law = yielding_at(50.0, -300.0);
  const FrictionPast past{Field(), 0.2, Field::LinSpaced(row.grid.nx, 0.0, 0.1)};
  const TangentialMotion motion = row.motion(1.0, past);
  const TangentialProblem problem{row.pressure, motion, shared(law)};
  FrictionState state;
  state.begin(row.grid, problem, row.places);
  VectorXd rest(row.count());
  state.set_rest(rest);
  const VectorXd bound = row.bound(state, row.slip([](double) { return 0.3; }));
  for (Eigen::Index e = 0; e < row.count(); ++e) {
    const double before = past.plastic[row.place(e)];
    const double friction = mu * row.pressure[row.place(e)];
    EXPECT_NEAR(rest[e], std::min(friction, 50.0 - 300.0 * before), 1e-12);
    if (friction < 50.0) continue;
    EXPECT_NEAR(bound[e], 50.0 - 300.0 * (before + 0.2 * 0.3), 1e-12);
    EXPECT_NEAR(state.plastic(e), before + 0.06, 1e-12);
  }
}

TEST(Yielding, PerfectPlasticityBoundsWithoutSlip) {
  const FrictionRow row(25, highest);
  const CoulombFriction law = yielding_at(100.0, 0.0);
  const TangentialProblem problem{row.pressure, row.still, shared(law)};
  FrictionState state;
  state.begin(row.grid, problem, row.places);
  EXPECT_FALSE(state.feels_slip());
  VectorXd bound(row.count());
  state.set_rest(bound);
  for (Eigen::Index e = 0; e < row.count(); ++e) {
    const double friction = mu * row.pressure[row.place(e)];
    EXPECT_EQ(bound[e], std::min(friction, 100.0));
    EXPECT_EQ(state.yields(e), friction > 100.0);
  }
}

TEST(Yielding, OwnSlipFromTheTrialTractionIsThatOfASolution) {
  // In a solution |q| = g + r |w|.
  const FrictionRow row(25, highest);
  constexpr double r = 4e3;
  for (const double hardening : {100.0, 1e4, 1e7}) {
    const CoulombFriction law = yielding_at(150.0, hardening);
    const TangentialMotion motion = row.motion(0.5);
    const TangentialProblem problem{row.pressure, motion, shared(law)};
    FrictionState by_slip, by_trial;
    by_slip.begin(row.grid, problem, row.places);
    by_trial.begin(row.grid, problem, row.places, r);
    const VectorXd slip = row.slip(growing_slip);
    VectorXd expected(row.count()), bound(row.count()), trial = -slip;
    by_slip.set_bound(slip, slip, expected);
    for (Eigen::Index e = 0; e < row.count(); ++e) {
      const double size = growing_slip(row.x(e));
      trial[e] *= (expected[e] + r * size) / size;
      trial[row.count() + e] *= (expected[e] + r * size) / size;
    }
    by_trial.set_bound(slip, trial, bound);
    for (Eigen::Index e = 0; e < row.count(); ++e) {
      EXPECT_NEAR(bound[e], expected[e], 1e-9 * expected[e]);
      EXPECT_EQ(by_trial.yields(e), by_slip.yields(e));
      EXPECT_NEAR(by_trial.plastic(e), by_slip.plastic(e), 1e-12);
    }
  }
}

/// Change of g by differences and as Newton's method has it.
void expect_derivative_of_yielding(const TangentialProblem& problem, const FrictionRow& row,
                                   double r = 0.0) {
  FrictionState state;
  state.begin(row.grid, problem, row.places, r);
  const VectorXd slip = row.slip(growing_slip);
  const VectorXd trial = row.slip([](double x) { return 150.0 + 300.0 * (1.0 - x); });
  VectorXd change(slip.size()), trial_change(slip.size());
  for (Eigen::Index e = 0; e < change.size(); ++e) {
    change[e] = std::sin(1.7 * e + 0.3);
    trial_change[e] = 3e3 * std::cos(1.3 * e);
  }
  const double h = 1e-9;
  VectorXd above(row.count()), below(row.count()), linear(row.count());
  state.set_bound(slip + h * change, trial + h * trial_change, above);
  state.set_bound(slip - h * change, trial - h * trial_change, below);
  state.linearise(slip, trial);
  state.change(change, trial_change, linear);
  EXPECT_GT(linear.norm(), 0.0);
  EXPECT_LT(((above - below) / (2.0 * h) - linear).norm(), 1e-5 * linear.norm());
}

TEST(Yielding, DerivativesAreThoseOfTheBounds) {
  const FrictionRow row(20, highest);
  const FrictionPast past{Field::LinSpaced(row.grid.nx, 0.4, 0.5), 0.3,
                          Field::LinSpaced(row.grid.nx, 0.0, 0.01)};
  for (const double hardening : {3000.0, 50e3, -3000.0}) {
    const CoulombFriction law = yielding_at(180.0, hardening);
    expect_derivative_of_yielding({row.pressure, row.motion(0.5), shared(law)}, row);
    expect_derivative_of_yielding({row.pressure, row.motion(0.5), shared(law)}, row, 4e3);
    expect_derivative_of_yielding({row.pressure, row.motion(0.5, past), shared(law)}, row, 4e3);
    expect_derivative_of_yielding({row.pressure, row.motion(0.5, past), shared(law)}, row);
    FallingFriction falling{
        FallShape::exponential, 0.3, {{{0.2, 0.02}, {}}}, FrictionMemory{2e-3, 1e-3}};
    falling.plasticity = law.plasticity;
    expect_derivative_of_yielding({row.pressure, row.motion(0.5), shared(falling)}, row);
    expect_derivative_of_yielding({row.pressure, row.motion(0.5, past), shared(falling)}, row);
    expect_derivative_of_yielding({row.pressure, row.motion(0.5), shared(falling)}, row, 4e3);
  }
}

TEST(Yielding, WhatYieldsDoesNotSlip) {
  // The friction of particles that yield stays that at rest, however fast they move.
  const FrictionRow row(25, highest);
  FallingFriction law{FallShape::exponential, 0.3, {{{0.2, 0.02}, {}}}, FrictionMemory{2e-3, 1e-9}};
  law.plasticity = Plasticity{1e-3, 1.0};
  const TangentialProblem problem{row.pressure, row.still, shared(law)};
  FrictionState state;
  state.begin(row.grid, problem, row.places);
  const VectorXd bound = row.bound(state, row.slip([](double) { return 1.0; }));
  for (Eigen::Index e = 0; e < row.count(); ++e) {
    EXPECT_TRUE(state.yields(e));
    EXPECT_NEAR(state.coefficient(e), 0.5, 1e-6);
  }
}

}  // namespace
}  // namespace rollfem::contact

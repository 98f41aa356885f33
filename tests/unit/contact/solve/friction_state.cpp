// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction that remembers: mu along a row against the solution of its differential equation, its
// order, its derivative, and steps of a history.
#include "support/friction_row.hpp"

namespace rollfem::contact {
namespace {

using Eigen::VectorXd;

constexpr double d_c = 2e-3, s_0 = 1e-3, half_slip = 5e-3;

FallingFriction law_with(std::optional<FrictionMemory> memory) {
  return {FallShape::exponential, 0.15, {{{0.25, half_slip}, {}}}, memory};
}

/// mu of every element.
VectorXd coefficient(const FrictionRow& row, FrictionState& state, const VectorXd& slip) {
  VectorXd found = row.bound(state, slip);
  for (Eigen::Index e = 0; e < found.size(); ++e) found[e] /= row.pressure[row.place(e)];
  return found;
}

/// Runge and Kutta's method from the leading edge to x, 2000 steps.
template <class Size>
double integrated(const FrictionLaw& law, const Size& size, double x) {
  const auto rate = [&](double at, double mu) {
    const double w = size(at);
    return std::max(w, s_0) / d_c * (law.at(w).value - mu);
  };
  constexpr int steps = 2000;
  const double h = (1.0 - x) / steps;
  double mu = law.coefficient();
  for (int k = 0; k < steps; ++k) {
    const double at = 1.0 - k * h;
    const double a = rate(at, mu);
    const double b = rate(at - 0.5 * h, mu + 0.5 * h * a);
    const double c = rate(at - 0.5 * h, mu + 0.5 * h * b);
    const double d = rate(at - h, mu + h * c);
    mu += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return mu;
}

double smooth_slip(double x) {
  return 4e-3 * (1.2 - x) * (1.0 + 0.3 * std::cos(5.0 * x));
}

double worst_error(int elements) {
  const FrictionRow row(elements);
  const FallingFriction law = law_with(FrictionMemory{d_c, s_0});
  FrictionState state;
  const TangentialProblem problem{row.pressure, row.still, shared(law)};
  state.begin(row.grid, problem, row.places);
  const VectorXd mu = coefficient(row, state, row.slip(smooth_slip));
  double worst = 0.0;
  for (Eigen::Index e = 0; e < mu.size(); ++e) {
    const double x = row.x(e);
    worst = std::max(worst, std::abs(mu[e] - integrated(law, smooth_slip, x)));
  }
  return worst;
}

TEST(FrictionState, MemoryIsOfSecondOrderAlongTheRow) {
  const double coarse = worst_error(10), middle = worst_error(20), fine = worst_error(40);
  EXPECT_GT(std::log2(coarse / middle), 1.8);
  EXPECT_GT(std::log2(middle / fine), 1.8);
  EXPECT_LT(fine, 2e-4);
}

TEST(FrictionState, ConstantSlipDecaysExponentially) {
  const FrictionRow row(20);
  const FallingFriction law = law_with(FrictionMemory{d_c, s_0});
  FrictionState state;
  const TangentialMotion motion = row.motion(2.0);  // the law's slip is twice
  const TangentialProblem problem{row.pressure, motion, shared(law)};
  state.begin(row.grid, problem, row.places);
  for (const double w : {2e-4, 3e-3, 0.5}) {
    const VectorXd mu = coefficient(row, state, row.slip([&](double) { return 0.5 * w; }));
    for (Eigen::Index e = 0; e < mu.size(); ++e) {
      const double x = row.x(e);
      const double left = std::exp(-(1.0 - x) * std::max(w, s_0) / d_c);
      const double there = law.at(w).value;
      EXPECT_NEAR(mu[e], there + left * (law.coefficient() - there), 1e-10);
    }
  }
}

TEST(FrictionState, AVanishingMemoryHasNoEffect) {
  const FrictionRow row(20);
  const FallingFriction law = law_with(FrictionMemory{1e-12, s_0});
  FrictionState state;
  const TangentialProblem problem{row.pressure, row.still, shared(law)};
  state.begin(row.grid, problem, row.places);
  const VectorXd mu = coefficient(row, state, row.slip(smooth_slip));
  for (Eigen::Index e = 0; e < mu.size(); ++e) {
    const double x = row.x(e);
    EXPECT_NEAR(mu[e], law.at(smooth_slip(x)).value, 1e-9);
  }
}

TEST(FrictionState, AGapInTheRowBringsFrictionBackToThatAtRest) {
  FrictionRow row(20);
  row.pressure[9] = 0.0;  // element 7 of the row
  row.places.erase(row.places.begin() + 7);
  const FallingFriction law = law_with(FrictionMemory{d_c, s_0});
  FrictionState state;
  const TangentialProblem problem{row.pressure, row.still, shared(law)};
  state.begin(row.grid, problem, row.places);
  const VectorXd mu = coefficient(row, state, row.slip([](double) { return 0.02; }));
  EXPECT_LT(mu[7], 0.2);   // behind the first half of the row
  EXPECT_GT(mu[6], 0.25);  // the first behind the gap
}

/// Change of g by differences and as Newton's method has it.
void expect_derivative(const TangentialProblem& problem, const FrictionRow& row) {
  FrictionState state;
  state.begin(row.grid, problem, row.places);
  const VectorXd slip = row.slip(smooth_slip);
  const Eigen::Index count = slip.size() / 2;
  VectorXd change(slip.size());
  for (Eigen::Index e = 0; e < change.size(); ++e) change[e] = std::sin(1.7 * e + 0.3);
  const double h = 1e-8;
  VectorXd above(count), below(count), linear(count);
  state.set_bound(slip + h * change, slip, above);
  state.set_bound(slip - h * change, slip, below);
  state.linearise(slip, slip);
  state.change(change, change, linear);
  EXPECT_LT(((above - below) / (2.0 * h) - linear).norm(), 1e-6 * linear.norm());
}

TEST(FrictionState, DerivativesAreThoseOfTheBounds) {
  const FrictionRow row(20);
  const FallingFriction at_once = law_with({}), slow = law_with(FrictionMemory{d_c, s_0});
  expect_derivative({row.pressure, row.motion(0.5), shared(at_once)}, row);
  expect_derivative({row.pressure, row.motion(0.5), shared(slow)}, row);
  const FrictionPast past{Field::LinSpaced(row.grid.nx, 0.2, 0.4), 0.3};
  expect_derivative({row.pressure, row.motion(0.5, past), shared(slow)}, row);
}

TEST(FrictionState, AStepOfAHistoryRemembersItsParticle) {
  const FrictionRow row(20);
  const FallingFriction law = law_with(FrictionMemory{d_c, s_0});
  const FrictionPast past{Field::LinSpaced(row.grid.nx, 0.2, 0.4), 0.3};
  FrictionState state;
  const TangentialMotion motion = row.motion(1.0, past);
  const TangentialProblem problem{row.pressure, motion, shared(law)};
  state.begin(row.grid, problem, row.places);
  const double w = 6e-3;
  const VectorXd mu = coefficient(row, state, row.slip([&](double) { return w; }));
  for (Eigen::Index e = 0; e < mu.size(); ++e) {
    const double before = past.coefficient[row.place(e)];
    const double there = law.at(w).value;
    EXPECT_NEAR(mu[e], there + std::exp(-0.3 * w / d_c) * (before - there), 1e-12);
  }
}

}  // namespace
}  // namespace rollfem::contact

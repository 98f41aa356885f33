// SPDX-License-Identifier: LGPL-2.1-or-later
// State inherited by a step: upstream interpolation, and slip of steps against a displacement given
// as a function.
#include "base/errors.hpp"
#include "contact/solve/point_motion.hpp"

#include "support/test.hpp"

namespace rollfem::contact {
namespace {

const ContactGrid grid = ContactGrid::centred(40, 3, 0.1, 0.2);

TangentialField wave(double phase) {
  return {grid.sample([&](double x, double y) { return std::sin(x + phase) + y; }),
          grid.sample([&](double x, double) { return std::cos(2.0 * x + phase); })};
}

TEST(Upstream, IsExactForCubicsAndForWholeElements) {
  const auto cubic = [](double x, double y) { return 1.0 + x - 2.0 * x * x + x * x * x + y; };
  const Field values = grid.sample(cubic);
  for (const double distance : {0.0, 0.1, 0.137, 0.25, 0.3}) {
    const Field moved = upstream(grid, values, distance);
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 1; i + 6 < grid.nx; ++i)
        EXPECT_NEAR(moved[grid.index(i, j)], cubic(grid.x(i) + distance, grid.y(j)), 1e-12);
  }
  // Also where the step has more elements than an int holds.
  for (const double distance : {100.0, 1e9, 1e300}) {
    const Field far = upstream(grid, values, distance);
    EXPECT_NEAR(far[grid.index(0, 1)], cubic(grid.x(grid.nx - 1), grid.y(1)), 1e-12) << distance;
  }
}

TEST(History, AShiftComparesWithTheStepBefore) {
  History history(grid, UpwindOrder::second);
  const TangentialField shift{Field::Constant(grid.size(), 0.3), Field::Constant(grid.size(), 0.1)};
  EXPECT_EQ((history.shift_step(shift).rigid_slip.x - shift.x).norm(), 0.0);
  history.advance(wave(0.0), 0.0);
  EXPECT_LT((history.shift_step(shift).rigid_slip.x - shift.x + wave(0.0).x).norm(), 1e-14);
}

/// Slip of rolling under a displacement u(x + c t), of which w = s + (u_t - u_x) is known: the
/// material derivative of u(x, t) at V = 1 in the direction -x.
double slip_error(UpwindOrder order, double step) {
  const double speed = 0.7;
  History history(grid, order);
  const TangentialField s{Field::Constant(grid.size(), 2e-3), Field::Constant(grid.size(), 1e-3)};
  TangentialMotion problem;
  double t = 0.0;
  for (int k = 0; k < 4; ++k, t += step) {
    problem = history.rolling_step(s, step);
    if (k < 3) history.advance(wave(speed * t), step);
  }
  t -= step;
  const TangentialField now = wave(speed * t);
  // With A_tt p = u: w' = rigid_slip + (the factor in front of u is 1).
  const Field slip = problem.slip_factor * (problem.rigid_slip.x + now.x);
  double error = 0.0;
  for (int i = 2; i + 10 < grid.nx; ++i) {
    const double x = grid.x(i);
    const double exact = 2e-3 + (speed - 1.0) * std::cos(x + speed * t);
    error = std::max(error, std::abs(slip[grid.index(i, 1)] - exact));
  }
  return error;
}

TEST(History, RollingStepsHaveTheirOrder) {
  for (const auto& [order, power] :
       {std::pair{UpwindOrder::first, 1.0}, {UpwindOrder::second, 2.0}}) {
    // Whole elements: no interpolation in between.
    const double coarse = slip_error(order, 0.4);
    const double fine = slip_error(order, 0.2);
    EXPECT_NEAR(std::log2(coarse / fine), power, 0.2);
  }
  EXPECT_LT(slip_error(UpwindOrder::second, 0.1), 0.1 * slip_error(UpwindOrder::first, 0.1));
}

TEST(History, RollingNeedsAPositiveStep) {
  const History history(grid, UpwindOrder::first);
  EXPECT_THROW(history.rolling_step(wave(0.0), 0.0), InputError);
}

}  // namespace
}  // namespace rollfem::contact

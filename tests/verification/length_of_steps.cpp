// SPDX-License-Identifier: LGPL-2.1-or-later
// Bars of transients under long steps: against the steady start that must go on, and against the
// same history in shorter steps.
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/model/step_errors.hpp"

#include "support/test.hpp"
#include "support/thesis_cases.hpp"

namespace {

constexpr double sliding_of_long_steps = 0.55 * 50e3;

/// Case b over `count` steps of `part` of its patch.
contact::Case in_long_steps(double part, std::size_t count, int across) {
  contact::Case input = thesis_case('b', across);
  roll_on(input, count, part * 2.0 * halfspace::hertz_of_scene(input).semi_axis_x,
          {0.0015, 0.0007, 2e-4});
  return input;
}

double bar_of_x(const contact::PointResult& point) {
  return point.error_estimate.at("longitudinal_force");
}

TEST(LongSteps, BarsHoldTheSteadyStartThatGoesOn) {
  for (const double part : {0.1, 0.25, 0.5, 1.0, 2.0, 20.0}) {
    contact::Case input = in_long_steps(part, 5, 16);
    input.starts_steady = true;
    const auto points = halfspace::run_halfspace(input, {}).points;
    for (std::size_t k = 1; k < points.size(); ++k) {
      const double error = std::abs(points[k].longitudinal_force - points[0].longitudinal_force);
      EXPECT_LT(error, bar_of_x(points[k]) + bar_of_x(points[0])) << part << ' ' << k;
      EXPECT_LT(bar_of_x(points[k]), 3.0 * error + 0.03 * sliding_of_long_steps)
          << part << ' ' << k;
    }
  }
}

TEST(LongSteps, BarsFromRestHoldTheSameHistoryInShortSteps) {
  for (const double part : {0.125, 0.25, 0.5, 1.0, 3.0}) {
    const contact::Case input = in_long_steps(part, 3, 16);
    const auto whole = halfspace::run_halfspace(input, {}).points;
    const int pieces = static_cast<int>(16 * part);
    const auto divided =
        halfspace::run_halfspace(
            in_long_steps(1.0 / 16.0, 3 * static_cast<std::size_t>(pieces), 16), {})
            .points;
    for (std::size_t k = 0; k < whole.size(); ++k) {
      const double exact =
          divided[(k + 1) * static_cast<std::size_t>(pieces) - 1].longitudinal_force;
      EXPECT_NEAR(whole[k].longitudinal_force, exact, bar_of_x(whole[k])) << part << ' ' << k;
    }
  }
}

TEST(LongSteps, AreDividedAtTheSameEnds) {
  contact::Case input = in_long_steps(1.0, 3, 16);
  input.starts_steady = true;
  input.history[1].step_length = 0.7;
  input.history[1].normal_force = 10e3;
  input.history[2].step_length = 100.0;
  input.history[2].normal_force = 20e3;
  const halfspace::DividedSteps steps = halfspace::divided_steps(input, 10.0);
  ASSERT_EQ(steps.ends, (std::vector<std::size_t>{0, 2, 18}));
  const auto& points = steps.scene.points;
  EXPECT_EQ(points[1].step_length, 0.35);
  EXPECT_NEAR(*points[1].load.force, 30e3, 1e-9);  // between 50 and 10 kN
  EXPECT_EQ(*points[2].load.force, 10e3);
  EXPECT_NEAR(points[3].step_length, 81.25, 1e-12);  // before the last two patches, and a piece
  EXPECT_NEAR(*points[3].load.force, 18.125e3, 1e-9);
  EXPECT_NEAR(points[18].step_length, 1.25, 1e-12);
  EXPECT_EQ(*points[18].load.force, 20e3);
}

}  // namespace

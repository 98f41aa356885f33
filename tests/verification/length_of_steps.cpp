// SPDX-License-Identifier: LGPL-2.1-or-later
// Where long steps of a transient are divided for their bars (which hold: the book).
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/step_errors.hpp"

#include "support/test.hpp"
#include "support/thesis_cases.hpp"

namespace {

TEST(LongSteps, AreDividedAtTheSameEnds) {
  contact::Case input = thesis_case('b', 16);
  roll_on(input, 3, 2.0 * halfspace::hertz_of_scene(input).semi_axis_x, {0.0015, 0.0007, 2e-4});
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

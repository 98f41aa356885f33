// SPDX-License-Identifier: LGPL-2.1-or-later
// Pressing on a patch of four elements (Cattaneo and Mindlin, Spence, rolling from rest and on from
// steady rolling: the book).
#include "halfspace/model/halfspace_model.hpp"

#include "support/test.hpp"

namespace {

/// An elastic sphere of Spence's pressed on a rigid one with the first and these further forces.
Case pressed_sphere(const std::vector<double>& forces) {
  Case input;
  input.file = "test.toml";
  input.wheel.rolling_radius = input.wheel.transverse_radius = 121.5;
  input.wheel.material = {1.0, 0.0};
  input.rail.material = {infinity, 0.0};
  input.friction_coefficient = 0.2986;
  input.rolling.problem = Problem::shift;
  for (const double force : forces) input.history.emplace_back().normal_force = force;
  input.rolling.creepages.assign(forces.size(), {});
  return input;
}

TEST(Spence, FirstStepOnFourElements) {
  // A load whose patch is four elements: friction has changed their displacement alike, and the
  // gap is closed where the approach has followed.
  Case input = pressed_sphere({0.00011, 0.4495});
  input.contact_grid.elements_across = 20;
  input.load.normal_force = 0.4495;
  const ModelResult result = halfspace::run_halfspace(input, {});
  const PointResult& first = result.points.front();
  const Field& pressure = first.fields.traction.n;
  ASSERT_EQ((pressure.array() > 0.0).count(), 4);
  const double left =
      (pressure.array() > 0.0).select(first.fields.gap.array().abs(), 0.0).maxCoeff();
  EXPECT_LT(left, 1e-6 * first.approach);
  EXPECT_TRUE(first.converged);
}

}  // namespace

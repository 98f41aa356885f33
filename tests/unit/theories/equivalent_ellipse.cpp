// SPDX-License-Identifier: LGPL-2.1-or-later
// The ellipse that theories of elliptic patches are given for a patch of profiles.
#include "base/errors.hpp"
#include "result/patch_size.hpp"

#include "support/half_space_models.hpp"
#include "support/profile_scenes.hpp"
#include "support/temporary_folder.hpp"

TEST(EquivalentEllipse, LiesWithinTheGridThoughThePatchEndsEarlierOnOneSide) {
  // 2 mm away from its rail's gauge side: a patch with a tail, whose centre of pressure is far from
  // its middle.
  const contact::Scene scene = left_wheel_scenes(-2.0, {1e-3}).at(0);
  const contact::ModelResult result = half_space_models().run("fastsim", scene, {});
  const contact::Field& pressure = result.points.front().fields.traction.n;
  EXPECT_GT(pressure.maxCoeff(), 0.0);
  EXPECT_FALSE(contact::touches_border(result.grid, pressure));
  double force = 0.0;
  for (const double p : pressure) force += p * result.grid.dx * result.grid.dy;
  EXPECT_NEAR(force / result.points.front().normal_force, 1.0, 0.01);
}

TEST(EquivalentEllipse, FrictionWithoutABoundDoesNotCarryTheWheel) {
  // On a plane tilted by 0.8 rad friction may lift the wheel by mu F_n sin 0.8; the linear theory
  // has three times that, and at twice the creepage no balance at all.
  contact::Scene scene = left_wheel_scenes(-2.0, {1e-3}).at(0);
  ASSERT_TRUE(scene.points.at(0).load.force);
  scene.points[0].load.direction = {std::sin(0.8), std::cos(0.8)};
  scene.points[0].creepage.lateral = -0.01;
  const contact::PointResult bounded =
      half_space_models().run("vermeulen-johnson", scene, {}).points.at(0);
  EXPECT_NEAR(bounded.normal_force * std::cos(0.8) + bounded.lateral_force * std::sin(0.8),
              *scene.points[0].load.force, 1e-6 * *scene.points[0].load.force);
  for (const double eta : {-0.01, -0.02}) {
    scene.points[0].creepage.lateral = eta;
    EXPECT_TRUE(
        says(refusal<contact::SolveError>([&] { half_space_models().run("linear", scene, {}); }),
             "this theory has no traction bound"))
        << eta;
  }
  // Where it hardly matters the theory's forces are its own.
  scene.points[0].load.direction = {std::sin(0.005), std::cos(0.005)};
  EXPECT_NO_THROW(half_space_models().run("linear", scene, {}));
}

// The ellipse that theories of elliptic patches are given for a patch of profiles.
#include "contact/result/patch_size.hpp"
#include "halfspace/model/registry.hpp"

#include <gtest/gtest.h>

#include "support/profile_scenes.hpp"

namespace {

using namespace rollfem;

TEST(EquivalentEllipse, LiesWithinTheGridThoughThePatchEndsEarlierOnOneSide) {
  // 2 mm away from its rail's gauge side: a patch with a tail, whose centre of pressure is far from
  // its middle.
  const contact::Scene scene = rollfem::testing::left_wheel_scenes(-2.0, {1e-3}).at(0);
  const contact::ModelResult result = halfspace::run_model("fastsim", scene, {});
  const contact::Field& pressure = result.points.front().fields.traction.n;
  EXPECT_GT(pressure.maxCoeff(), 0.0);
  EXPECT_FALSE(contact::touches_border(result.grid, pressure));
  double force = 0.0;
  for (const double p : pressure) force += p * result.grid.dx * result.grid.dy;
  EXPECT_NEAR(force / result.points.front().normal_force, 1.0, 0.01);
}

}  // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Rolling radii over the lateral shift against the conicity of circular profiles in closed form.
#include "track/motion/rigid_touch.hpp"

#include "base/errors.hpp"
#include "track/motion/placed_scenes.hpp"
#include "track/motion/wheelset_motion.hpp"

#include "support/worn_wheels.hpp"

namespace {

/// Coned wheel that is concave with radius `wheel` on a rail of radius `rail`, mm.
contact::Case circles(double wheel, double rail) {
  contact::Case input = hollow_tread(0.0);
  input.wheel.profile.radii = {-wheel};
  input.wheel.profile.ends = {-60.0, 60.0};
  input.wheel.profile.slope = -0.05;
  input.wheelset.flange_back_position = -70.0;
  input.rail.profile.radii = {rail, 20.0};
  input.rail.profile.ends = {28.0, 45.0};
  input.track.gauge_height = 8.0;
  input.wheelset.roll.clear();
  return input;
}

}  // namespace

TEST(RigidTouch, CircularProfilesHaveWickensConicity) {
  // A. H. Wickens, Fundamentals of Rail Vehicle Dynamics (2003): for small shifts the conicity is
  // R d / (R - R') (l + R' d) / (l - r d), with radii R of the wheel's and R' of the rail's
  // profile, the slope d of the contact in the middle, the half distance l of the contacts and the
  // rolling radius r.
  for (const double wheel : {260.0, 300.0, 400.0}) {
    const double rail = 200.0;
    const contact::Case input = circles(wheel, rail);
    const auto touches = track::rigid_touches(input, track::search_scene_of(input), {0.0, 0.1});
    ASSERT_EQ(touches.size(), 2u);
    const track::RigidWheelset& middle = touches[0];
    EXPECT_NEAR(touches[0].radius_difference(), 0.0, 1e-9);
    EXPECT_NEAR(touches[0].roll, 0.0, 1e-12);
    const double slope = std::tan(middle.angle_right);
    ASSERT_GT(slope, 0.06);
    const double expected = wheel * slope / (wheel - rail) * (middle.y_track_right + rail * slope) /
                            (middle.y_track_right - middle.radius_right * slope);
    EXPECT_NEAR(touches[1].radius_difference() / 0.2, expected, 5e-4 * expected) << wheel;
  }
}

TEST(RigidTouch, RollersSteerByTheirOwnRadiiToo) {
  // The same closed form with the height of the contact on the roller, whose profile turns by the
  // angle between the bodies alone: R' d / (R - R') (l + R d) / (l - r d) r / R_roller more.
  for (const double roller : {500.0, -2000.0}) {
    const double wheel = 300.0, rail = 200.0;
    contact::Case input = circles(wheel, rail);
    const auto on_rails = track::rigid_touches(input, track::search_scene_of(input), {0.0, 0.1});
    input.rail.rolling_radius = roller;
    const auto touches = track::rigid_touches(input, track::search_scene_of(input), {0.0, 0.1});
    const track::RigidWheelset& middle = touches.at(0);
    const double slope = std::tan(middle.angle_right), away = middle.y_track_right;
    const double both = (wheel - rail) * (away - middle.radius_right * slope);
    // The speed of the roller's surface in the middle, as far below its top as the slope is.
    const double speed = 1.0 - rail * (1.0 - std::cos(middle.angle_right)) / roller;
    const double of_wheels = wheel * slope * (away + rail * slope) / both / speed;
    const double of_rollers = rail * slope * (away + wheel * slope) / both * middle.radius_right /
                              roller / (speed * speed);
    EXPECT_NEAR(touches.at(1).rolling_difference / 0.2 / (of_wheels + of_rollers), 1.0, 5e-4);
    EXPECT_NEAR(touches[1].radius_difference(), on_rails.at(1).radius_difference(), 1e-6);
    EXPECT_EQ(on_rails[1].rolling_difference, on_rails[1].radius_difference());
    const auto mirrored = track::rigid_touches(input, track::search_scene_of(input), {-0.1});
    EXPECT_NEAR(mirrored.at(0).rolling_difference, -touches[1].rolling_difference, 1e-9);
  }
}

TEST(RigidTouch, ConicityOnRollersIsThatOfTheCreepages) {
  // In pure rolling of points the creepages of both wheels differ by what steers.
  contact::Case input = circles(300.0, 200.0);
  input.rail.rolling_radius = 500.0;
  input.load = {};
  input.load.approach = 1e-7;
  input.wheelset.side = contact::WheelSide::both;
  input.wheelset.lateral_shift = {2.0};
  const track::SearchScene search = track::search_scene_of(input);
  const auto scenes = make_scenes(input, search);
  ASSERT_EQ(scenes.size(), 2u);
  const auto slip = [&](std::size_t k) {
    return scenes[k].scene.points[0].creepage.longitudinal /
           (1.0 - scenes[k].contact.place.z_track / 500.0);
  };
  const auto touch = track::rigid_touches(input, search, {2.0}).at(0);
  EXPECT_NEAR(touch.rolling_difference, input.wheel.rolling_radius * (slip(0) - slip(1)), 1e-5);
  EXPECT_GT(touch.rolling_difference, 1.3 * touch.radius_difference());
}

TEST(RigidTouch, TheOtherSideIsTheMirrorImage) {
  const contact::Case input = circles(300.0, 200.0);
  const auto touches = track::rigid_touches(input, track::search_scene_of(input), {-1.5, 1.5});
  ASSERT_EQ(touches.size(), 2u);
  EXPECT_NEAR(touches[0].radius_left, touches[1].radius_right, 1e-9);
  EXPECT_NEAR(touches[0].angle_right, touches[1].angle_left, 1e-9);
  EXPECT_NEAR(touches[0].roll, -touches[1].roll, 1e-12);
}

TEST(RigidTouch, EndsWhereAWheelLeavesItsRail) {
  const contact::Case input = circles(300.0, 200.0);
  const track::SearchScene search = track::search_scene_of(input);
  const auto touches = track::rigid_touches(input, search, {0.0, 1.0, 70.0, 2.0});
  EXPECT_EQ(touches.size(), 2u);
  EXPECT_ANY_THROW(static_cast<void>(track::rigid_touches(input, search, {70.0})));
}

TEST(RigidTouch, ARowHasEveryShiftOnEitherSide) {
  const contact::Case input = circles(300.0, 200.0);
  const track::SearchScene search = track::search_scene_of(input);
  const auto rows = track::wheelset_rows(input, search, 3.0, 0.2);
  ASSERT_EQ(rows.size(), 16u);
  const auto right = track::wheelset_row(input, search, rows, 2.0);
  const auto left = track::wheelset_row(input, search, rows, -2.0);
  ASSERT_TRUE(right && left);
  EXPECT_NEAR(right->radius_difference(), rows[10].radius_difference(), 1e-9);
  EXPECT_NEAR(right->conicity_wave.value(), rows[10].conicity_wave.value(), 1e-6);
  EXPECT_EQ(left->lateral_shift, -2.0);
  EXPECT_NEAR(left->radius_difference(), -right->radius_difference(), 1e-12);
  EXPECT_EQ(left->conicity_wave, right->conicity_wave);
  // Between the steps, near the conicity of both neighbours.
  const auto between = track::wheelset_row(input, search, rows, 2.1);
  EXPECT_NEAR(between->conicity_harmonic.value(),
              0.5 * (*rows[10].conicity_harmonic + *rows[11].conicity_harmonic), 1e-5);
  EXPECT_FALSE(track::wheelset_row(input, search, rows, 0.0)->conicity_wave.has_value());
  EXPECT_FALSE(track::wheelset_row(input, search, rows, 70.0).has_value());
}

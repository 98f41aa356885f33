// SPDX-License-Identifier: LGPL-2.1-or-later
// Rails by gauge and inclination, axles by flange backs, shift, yaw and roll.
#include "track/placement/placement.hpp"

#include "base/errors.hpp"

#include "support/temporary_folder.hpp"
#include "support/wheel_rail_cases.hpp"

namespace {

using track::RailPlace;

contact::Track track_of(double inclination) {
  contact::Track track;
  track.inclination = inclination;
  return track;
}

TEST(RailPlace, FaceOfAnUprightRailIsHalfTheGaugeFromTheMiddle) {
  // The side of 60E1 at 14 mm: 35.9813 mm from its middle (shared/reference/profiles.md).
  const auto rail = profiles::find_built_in_profile("60E1")->make();
  const RailPlace place = track::rail_place(rail, track_of(0.0));
  EXPECT_NEAR(place.shift_y, 717.5 + 35.9813, 1e-4);
  EXPECT_NEAR(place.shift_z, 0.0, 1e-12);
}

TEST(RailPlace, ManchesterRailStandsWhereTheBenchmarkPutsIt) {
  // Crown of the upright rail at (-7.49170, 0.09371) of the benchmark's frame, which CONTACT puts
  // 760.5326 from the middle (profiles.md, manchester_left.csv: y_track + y_rail).
  const RailPlace place = track::rail_place(manchester_pair().rail, track_of(1.0 / 40.0));
  EXPECT_NEAR(place.shift_y + 7.49170, 760.5326, 2e-4);
  EXPECT_NEAR(place.shift_z, 0.09371, 1e-5);
  EXPECT_NEAR(place.angle, -std::atan(0.025), 1e-15);
}

TEST(RailPlace, TopOfTheInclinedRailIsLevelAndItsFootLeansOut) {
  const auto rail = manchester_pair().rail;
  for (const double inclination : {0.0, 1.0 / 40.0, 1.0 / 20.0}) {
    const RailPlace place = track::rail_place(rail, track_of(inclination));
    const auto placed = track::place_rail(rail, place);
    double top = 1e3, face = 1e3;
    for (double t = placed.first(); t <= placed.last(); t += 5e-4) {
      const auto at = placed.at(t);
      top = std::min(top, at.z);
      if (at.z <= 14.0) face = std::min(face, at.y);
    }
    EXPECT_NEAR(top, 0.0, 1e-8);
    EXPECT_NEAR(face, 717.5, 1e-4);
    // A point straight below the crown in the rail's own axes.
    const auto below = placed.at(placed.parameter_at(place.shift_y));
    const auto inside = track::profile_coordinates(place, below.y, below.z);
    EXPECT_NEAR(below.y, place.shift_y, 1e-9);
    EXPECT_LT(inside[0] * inclination, 1e-12);
  }
}

TEST(RailPlace, ProfileCoordinatesComeBack) {
  const auto rail = manchester_pair().rail;
  const RailPlace place = track::rail_place(rail, track_of(1.0 / 20.0));
  const auto placed = track::place_rail(rail, place);
  for (const double part : {0.1, 0.5, 0.83}) {
    const double t = rail.first() + part * (rail.last() - rail.first());
    const auto back = track::profile_coordinates(place, placed.at(t).y, placed.at(t).z);
    EXPECT_NEAR(back[0], rail.at(t).y, 1e-11);
    EXPECT_NEAR(back[1], rail.at(t).z, 1e-11);
  }
}

TEST(RailPlace, RefusesAProfileThatEndsAboveTheGaugeHeight) {
  const auto flat = profile_of([](double y) { return y * y / 600.0; },
                               [](double y) { return y / 300.0; }, -30.0, 30.0);
  EXPECT_TRUE(says(refusal<contact::InputError>([&] { track::rail_place(flat, track_of(0.0)); }),
                   "ends 1.5 mm below its top", "do: "));
}

TEST(Axle, RunningCirclesAreSetByTheFlangeBacks) {
  contact::Case input;  // 1360 between the backs, which are at profile y = -70
  input.wheel.rolling_radius = 460.0;
  const track::WheelsetPose pose{2.0, 0.0, 0.0, 0.3};
  const auto left = track::place_axle(pose, input, true);
  const auto right = track::place_axle(pose, input, false);
  // Outward: a shift to the right takes the left wheel inward.
  EXPECT_NEAR(left.point[1], 748.0, 1e-12);
  EXPECT_NEAR(right.point[1], 752.0, 1e-12);
  EXPECT_NEAR(left.point[2], -459.7, 1e-12);
  EXPECT_NEAR(left.direction[1], 1.0, 1e-15);
}

TEST(Axle, YawTurnsTheRightWheelBackAndRollLowersIt) {
  contact::Case input;
  input.wheel.rolling_radius = 460.0;
  const track::WheelsetPose pose{0.0, 0.01, 0.002, 0.0};
  const auto left = track::place_axle(pose, input, true);
  const auto right = track::place_axle(pose, input, false);
  // Turning x towards y takes the right end of the axle to smaller x.
  EXPECT_NEAR(right.point[0], -750.0 * std::sin(0.01) * std::cos(0.002), 1e-9);
  EXPECT_NEAR(left.point[0], -right.point[0], 1e-12);
  EXPECT_NEAR(right.point[2], -460.0 + 750.0 * std::sin(0.002), 1e-9);
  EXPECT_NEAR(left.point[2], -460.0 - 750.0 * std::sin(0.002), 1e-9);
}

}  // namespace

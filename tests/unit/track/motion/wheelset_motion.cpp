// SPDX-License-Identifier: LGPL-2.1-or-later
// Slip of wheel over rail from the motion of the wheelset, and the forces back on the wheelset.
#include "track/motion/wheelset_motion.hpp"

#include "support/wheel_rail_cases.hpp"

namespace {

using track::Motion;
using track::WheelRailContact;

WheelRailContact contact_of(const contact::Case& input, bool left) {
  return contacts_of(input, left).at(0);
}

TEST(Slip, WheelThatDoesNotTurnSlidesForward) {
  for (const bool left : {true, false}) {
    const auto contact = contact_of(manchester_case(2.0, 0.0), left);
    const auto creepage = track::creepage_of(contact, {0.0, 0.0, 0.0});
    EXPECT_NEAR(creepage.longitudinal, 1.0, 1e-12);
    EXPECT_NEAR(creepage.lateral, 0.0, 1e-12);
    EXPECT_NEAR(creepage.spin, 0.0, 1e-15);
  }
}

TEST(Slip, StraightRollingSlipsByTheRollingRadiusAndSpinsByTheContactAngle) {
  contact::Case input = manchester_case(2.0, 0.0);
  input.wheelset.roll = {0.0};
  for (const bool left : {true, false}) {
    const auto contact = contact_of(input, left);
    const auto creepage = track::creepage_of(contact, track::motion_of(input, 0.001));
    EXPECT_NEAR(creepage.longitudinal, 1.0 - 1.001 * contact.place.rolling_radius / 460.0, 1e-9);
    EXPECT_NEAR(creepage.lateral, 0.0, 1e-12);
    const double spin = std::sin(contact.place.contact_angle) * 1.001 / 460.0;
    EXPECT_NEAR(creepage.spin, left ? -spin : spin, 1e-12);
  }
}

TEST(Slip, YawMakesLateralCreepageToTheOtherSide) {
  // The wheel rolls to the right, so its surface slips to the left, where the patch's y points;
  // along an inclined tangent the more, as the contact runs ahead: psi / cos(angle).
  for (const bool left : {true, false}) {
    contact::Case input = manchester_case(-3.0, 0.01);
    input.load = {};
    input.load.approach = 1e-7;
    const auto contact = contact_of(input, left);
    const auto creepage = track::creepage_of(contact, track::motion_of(input, 0.0));
    EXPECT_NEAR(creepage.lateral, 0.01 / std::cos(contact.place.contact_angle), 2e-4);
    // The wheel's material moves along its own surface: nothing parts.
    EXPECT_NEAR(track::slip_at(contact, track::motion_of(input, 0.0), {})[2], 0.0, 1e-7);
  }
}

TEST(Slip, YawedFlangeSlipsInItsPlaneUnderLoad) {
  // Rolling moves the wheel across by yaw times its height below the axle, and no part of that
  // along the normal, which the plane of a loaded patch has from both bodies.
  constexpr double yaw = 0.005, radius = 460.0;
  for (const bool left : {true, false}) {
    contact::Case input = manchester_case(left ? -7.0 : 7.0, yaw);
    input.load.vertical_force = 80e3;
    input.wheelset.roll = {0.0};
    const auto contact = contact_of(input, left);
    ASSERT_GT(contact.place.contact_angle, 0.9);
    const double below = contact.place.z_track - contact.place.height + radius;
    const auto creepage = track::creepage_on_rail(contact, track::motion_of(input, 0.0));
    const double expected =
        std::sin(yaw) * below / (radius * std::cos(contact.place.contact_angle));
    EXPECT_NEAR(creepage.lateral, expected, 1e-9 * expected);
    EXPECT_NEAR(track::slip_at(contact, track::motion_of(input, 0.0), {})[2], 0.0, 1e-14);
  }
}

TEST(Slip, LateralVelocityToTheRightIsSlipAgainstThePatchesY) {
  contact::Case input = manchester_case(0.0, 0.0);
  for (const bool left : {true, false}) {
    const auto contact = contact_of(input, left);
    input.wheelset.lateral_velocity = 0.0;
    const auto without = track::creepage_of(contact, track::motion_of(input, 0.0));
    input.wheelset.lateral_velocity = 0.004;
    const auto with = track::creepage_of(contact, track::motion_of(input, 0.0));
    EXPECT_NEAR(with.lateral - without.lateral, -0.004 / std::cos(contact.place.contact_angle),
                1e-12);
    EXPECT_NEAR(with.longitudinal, without.longitudinal, 1e-15);
  }
}

TEST(Slip, YawVelocitySpeedsUpTheLeftWheelAndSpinsBoth) {
  contact::Case input = manchester_case(0.0, 0.0);
  const double rate = 1e-6;
  for (const bool left : {true, false}) {
    const auto contact = contact_of(input, left);
    const Motion still = track::motion_of(input, 0.0);
    Motion turning = still;
    turning.yaw_velocity = rate;
    const auto a = track::creepage_of(contact, still), b = track::creepage_of(contact, turning);
    // Turning to the right carries the left end of the axle forward.
    EXPECT_NEAR(b.longitudinal - a.longitudinal, -rate * contact.place.y_track, 1e-10);
    EXPECT_NEAR(b.spin - a.spin, -rate * std::cos(contact.place.contact_angle), 1e-15);
  }
}

TEST(Slip, AtOtherPlacesIsThatOfARotation) {
  const contact::Case input = manchester_case(2.0, 0.0048);
  for (const bool left : {true, false}) {
    const auto contact = contact_of(input, left);
    const Motion motion = track::motion_of(input, 0.0);
    const auto creepage = track::creepage_of(contact, motion);
    const double z = track::surface_place(contact)[2];
    const auto at = track::slip_at(contact, motion, {3.0, -4.0, z});
    EXPECT_NEAR(at[0], creepage.longitudinal + 4.0 * creepage.spin, 1e-12);
    EXPECT_NEAR(at[1], creepage.lateral + 3.0 * creepage.spin, 1e-12);
    // Higher up the wheel's material moves forward faster.
    const double higher = track::slip_at(contact, motion, {0.0, 0.0, z + 1.0})[0];
    const double tilt = contact.place.contact_angle + (left ? 1.0 : -1.0) * contact.place.roll;
    EXPECT_NEAR(higher - creepage.longitudinal, std::cos(0.0048) * std::cos(tilt) / 460.0, 1e-7);
  }
}

TEST(Force, VerticalForceOfManchesterCaseOneIsTenKilonewtons) {
  // manchester_left.csv, case 1: F_N 9997 N, F_s 0.08458 mu F_N at angle 0.0290. CONTACT prints the
  // force on the rail to the right, which is ours on the wheel to the left.
  contact::ContactPlace place;
  place.contact_angle = 0.0290;
  const double lateral = 0.08458 * 0.3 * 9997.0;
  EXPECT_NEAR(track::vertical_force(9997.0, lateral, place), 10e3, 0.6);
  // Case 3: 1.005e4 N (printed with four digits), F_s -0.9592 mu F_N, 0.0176.
  place.contact_angle = 0.0176;
  EXPECT_NEAR(track::vertical_force(1.005e4, -0.9592 * 0.3 * 1.005e4, place), 10e3, 5.0);
}

TEST(Force, VerticalForceIsThatOfTheFrame) {
  const contact::Case input = manchester_case(-6.0, 0.0);
  for (const bool left : {true, false}) {
    const auto contact = contact_of(input, left);
    const double up = -(1000.0 * contact.normal[2] + 300.0 * contact.across[2]);
    EXPECT_NEAR(track::vertical_force(1000.0, 300.0, contact.place), up, 1e-9);
  }
}

TEST(Force, DrivesByItsArmAndPowerIsSlip) {
  // Work of the tangential forces on the wheel per distance is force times slip; of it, moment
  // times rotation plus the forward force.
  const contact::Case input = manchester_case(-6.0, 0.01);
  for (const bool left : {true, false})
    for (const auto& contact : contacts_of(input, left)) {
      const track::PatchForce force{-700.0, 400.0, 9000.0, 1200.0};
      const Motion motion{1.01 / 460.0, 0.0, 0.0, 0.0, 0.0};
      const auto slip = track::slip_at(contact, motion, track::surface_place(contact));
      const auto creepage = track::creepage_of(contact, motion);
      const double power = force.longitudinal * slip[0] + force.lateral * slip[1] +
                           force.normal * slip[2] + force.spin_moment * creepage.spin;
      EXPECT_NEAR(track::driving_moment(contact, force) * motion.rotation + force.longitudinal,
                  power, 1e-8 * 9000.0);
    }
}

}  // namespace

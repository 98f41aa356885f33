// SPDX-License-Identifier: LGPL-2.1-or-later
// Bending of a flange under shared load, against finite elements of the sections of wheel and rail.
#include "track/balance/flange_bending.hpp"

#include "track/balance/balance.hpp"

#include "support/wheel_rail_cases.hpp"

namespace {

/// S1002 on UIC60, flange and root under 50 kN at a yaw of 30 mrad.
contact::Case two_contacts(double lateral_shift) {
  contact::Case input = manchester_case(lateral_shift, 0.0);
  input.wheel.profile.name = "S1002";
  input.rail.profile.name = "UIC60-manchester";
  input.wheelset.side = contact::WheelSide::right;
  input.wheelset.yaw = {0.03};
  input.wheelset.roll = {-0.00087};
  input.load.vertical_force = 50e3;
  input.friction_coefficient = 0.0;
  return input;
}

}  // namespace

TEST(FlangeBending, ChangesSharesAsElementsOfTheSectionsDo) {
  const contact::Case input = two_contacts(5.9);
  const track::BalancedCase balanced = track::balance(input);
  ASSERT_EQ(balanced.scenes.size(), 2U);
  const auto shares = track::shares_with_bending(input, balanced.scenes);
  ASSERT_EQ(shares.bent.size(), 2U);
  const std::size_t flange = balanced.scenes[0].place->contact_angle > 0.8 ? 0 : 1;
  // benchmarks/sections.py: 55.49 and 33.87 kN by the cross part alone, 49.02 and 36.27 kN wholly.
  EXPECT_NEAR(shares.bent[flange] - shares.stiff[flange], -6.47e3, 6.47e3 / 3.0);
  EXPECT_NEAR(shares.bent[1 - flange] - shares.stiff[1 - flange], 2.40e3, 2.40e3 / 3.0);
  // Both carry the same load.
  double change = 0.0;
  for (std::size_t i = 0; i < 2; ++i)
    change +=
        (shares.bent[i] - shares.stiff[i]) * std::cos(balanced.scenes[i].place->contact_angle);
  EXPECT_NEAR(change, 0.0, 2e-3 * 50e3);
  EXPECT_EQ(track::bending_notes(input, balanced.scenes).size(), 1U);
}

TEST(FlangeBending, IsNoConcernOfTheTread) {
  const contact::Case input = two_contacts(0.0);
  const track::BalancedCase balanced = track::balance(input);
  EXPECT_TRUE(track::shares_with_bending(input, balanced.scenes).bent.empty());
  EXPECT_TRUE(track::bending_notes(input, balanced.scenes).empty());
}

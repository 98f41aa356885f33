// SPDX-License-Identifier: LGPL-2.1-or-later
// The start of a balance: wheels placed once, for a check of the case and for the balance.
#include "track/balance/balance.hpp"

#include "support/wheel_rail_cases.hpp"

namespace {

contact::Case free_left_wheel() {
  contact::Case input = manchester_case(2.0, 0.0048);
  input.wheel.profile.name = "S1002";
  input.rail.profile.name = "UIC60-manchester";
  input.wheelset.side = contact::WheelSide::left;
  input.wheelset.free_rolling = contact::FreeRolling::torque;
  return input;
}

}  // namespace

TEST(PlacedWheels, OfAFreeWheelsetAreBothAndResultsOfThoseAskedFor) {
  const contact::Case input = free_left_wheel();
  const track::PlacedWheels placed = track::place_for_balance(input);
  const auto left = [](const track::PlacedScene& scene) { return scene.contact.place.left; };
  EXPECT_TRUE(std::any_of(placed.scenes.begin(), placed.scenes.end(), left));
  EXPECT_FALSE(std::all_of(placed.scenes.begin(), placed.scenes.end(), left));
  for (const track::PlacedScene& scene : placed.scenes)
    EXPECT_EQ(track::asked_for(input, scene), left(scene) && scene.contact.place.patch > 0);
  for (const contact::Scene& scene : track::balance(input, placed).scenes)
    EXPECT_TRUE(scene.place->left);
}

TEST(PlacedWheels, AreBalancedAgainAsTheyWereTheFirstTime) {
  const contact::Case input = free_left_wheel();
  const track::PlacedWheels placed = track::place_for_balance(input);
  const auto anew = track::balance(input).scenes;
  for (int time = 0; time < 2; ++time) {
    const auto scenes = track::balance(input, placed).scenes;
    ASSERT_EQ(scenes.size(), anew.size());
    for (std::size_t k = 0; k < anew.size(); ++k)
      EXPECT_EQ(scenes[k].points[0].creepage.longitudinal, anew[k].points[0].creepage.longitudinal);
  }
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Case files with profiles: track, wheelset and vertical force.
#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"

#include "support/case_examples.hpp"

namespace {

const std::string& pair = wheel_on_rail;

std::string with_pair(const std::string& piece, const std::string& replacement) {
  std::string text = pair;
  return text.replace(text.find(piece), piece.size(), replacement);
}

TEST(Track, DefaultsAreThoseOfStandardGauge) {
  const Case input = parse_case(pair, "c.toml");
  EXPECT_TRUE(input.has_profiles());
  EXPECT_EQ(input.track.gauge, 1435.0);
  EXPECT_EQ(input.track.gauge_height, 14.0);
  EXPECT_EQ(input.track.inclination, 0.025);
  EXPECT_EQ(input.wheelset.flange_back_distance, 1360.0);
  EXPECT_EQ(input.wheelset.flange_back_position, -70.0);
  EXPECT_EQ(input.wheelset.positions(), 1u);
  EXPECT_TRUE(input.wheelset.roll.empty());
  EXPECT_EQ(*input.load.vertical_force, 100e3);
  EXPECT_FALSE(input.load.normal_force);
}

TEST(Track, InclinationsAreTangents) {
  EXPECT_EQ(parse_case(with_pair("1:40", "1:20"), "c.toml").track.inclination, 0.05);
  EXPECT_EQ(parse_case(with_pair("1:40", "none"), "c.toml").track.inclination, 0.0);
  EXPECT_EQ(parse_case(with_pair("1:40", "1:30"), "c.toml").track.inclination, 1.0 / 30.0);
  const Case angle = parse_case(with_pair("\"1:40\"", "0.05"), "c.toml");
  EXPECT_DOUBLE_EQ(angle.track.inclination, std::tan(0.05));
  EXPECT_TRUE(says(describe(angle), "inclination            0.05\n"));
  EXPECT_DOUBLE_EQ(parse_case(with_pair("\"1:40\"", "-0.01"), "c.toml").track.inclination,
                   -std::tan(0.01));
}

TEST(Wheelset, PositionsAndLoadPointsAreListsOfTheirOwn) {
  const Case input = parse_case(pair +
                                    "[wheelset]\nlateral_shift = [0.0, 1.0, 2.0]\n"
                                    "yaw = 0.001\nroll = [0.0, 1e-4, 2e-4]\n"
                                    "rotation_change = [-0.001, 0.001]\n"
                                    "[rolling]\nlateral_creepage = 0.002\n",
                                "c.toml");
  EXPECT_EQ(input.wheelset.positions(), 3u);
  EXPECT_EQ(input.wheelset.yaw, (std::vector<double>{0.001, 0.001, 0.001}));
  EXPECT_EQ(input.wheelset.roll[2], 2e-4);
  ASSERT_EQ(input.rolling.creepages.size(), 2u);
  EXPECT_EQ(input.wheelset.rotation_change, (std::vector<double>{-0.001, 0.001}));
  EXPECT_FALSE(input.rolling.given.longitudinal);
  EXPECT_TRUE(input.rolling.given.lateral);
  EXPECT_FALSE(input.rolling.given.spin);
}

TEST(Wheelset, OneRotationChangeServesAllLoadPoints) {
  const Case input = parse_case(
      pair + "[wheelset]\nrotation_change = 0.001\n[rolling]\nlateral_creepage = [0.0, 0.002]\n",
      "c.toml");
  EXPECT_EQ(input.wheelset.rotation_change, (std::vector<double>{0.001, 0.001}));
}

TEST(Wheelset, WordsAreUnderstood) {
  const Case input =
      parse_case(pair + "[wheelset]\nside = \"both\"\nfree_rolling = \"torque\"\n", "c.toml");
  EXPECT_EQ(input.wheelset.side, contact::WheelSide::both);
  EXPECT_EQ(input.wheelset.free_rolling, contact::FreeRolling::torque);
}

TEST(Track, IsSaidBackByCheck) {
  const std::string text = describe(
      parse_case(pair + "[wheelset]\nlateral_shift = [0.0, 1.0]\nside = \"both\"\n", "c.toml"));
  EXPECT_TRUE(says(text, "[track]", "\"1:40\"", "1435", "[wheelset]", "[0, 1]", "\"both\"",
                   "vertical_force", "both wheels touch their rails"));
}

const std::string wheel_alone =
    "[friction]\ncoefficient = 0.3\n[wheel]\nrolling_radius = 460.0\nprofile = \"S1002\"\n"
    "[rail]\nprofile = \"60E1\"\n";

TEST(Placement, NeedsNoTrack) {
  const Case input = parse_case(
      wheel_alone + "[placement]\nside = \"right\"\nlateral_position = [1.0, 2.0]\nheight = 0.1\n",
      "c.toml");
  EXPECT_TRUE(input.wheelset.on_rail);
  EXPECT_TRUE(input.sinks());
  EXPECT_EQ(input.wheelset.side, contact::WheelSide::right);
  EXPECT_EQ(input.wheelset.height, (std::vector<double>{0.1, 0.1}));
  EXPECT_EQ(input.wheelset.lateral_shift, (std::vector<double>{1.0, 2.0}));
}

}  // namespace

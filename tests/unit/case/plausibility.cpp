// SPDX-License-Identifier: LGPL-2.1-or-later
// Unit mistakes are reported; intended values are not.
#include "case/checks/plausibility.hpp"

#include "case/reading/case_reader.hpp"

#include "support/places.hpp"
#include "support/temporary_folder.hpp"

namespace {

struct Values {
  std::string wheel = "460", rail = "300", force = "80e3", creepage = "0.001", spin = "0",
              modulus = "210e3", friction = "0.3";
};

std::vector<std::string> doubts(const Values& v) {
  return implausible_values(parse_case(
      "[load]\nnormal_force = " + v.force + "\n[friction]\ncoefficient = " + v.friction +
          "\n[wheel]\n" + "rolling_radius = " + v.wheel +
          "\ntransverse_radius = inf\nyoung_modulus = " + v.modulus +
          "\n[rail]\ntransverse_radius = " + v.rail + "\nyoung_modulus = " + v.modulus +
          "\n[rolling]\nlongitudinal_creepage = " + v.creepage + "\nspin = " + v.spin + "\n",
      "slip.toml"));
}

void expect_one(const Values& values, const std::string& beginning) {
  const auto found = doubts(values);
  ASSERT_EQ(found.size(), 1u) << beginning;
  EXPECT_EQ(found.front().rfind("slip.toml: " + beginning, 0), 0u) << found.front();
  EXPECT_TRUE(says(found.front(), "do: give it "));
}

TEST(Plausibility, WarnsOfWrongUnits) {
  Values metres;
  metres.wheel = "0.46";
  metres.force = "1";
  expect_one(metres, "wheel.rolling_radius = 0.46 mm");
  Values profile;
  profile.rail = "0.3";
  expect_one(profile, "rail.transverse_radius = 0.3 mm");
  Values kilonewtons;
  kilonewtons.force = "80";
  expect_one(kilonewtons, "load.normal_force = 80 N: a wheel of 460 mm carries more than 1058 N");
  Values per_cent;
  per_cent.creepage = "[0.1, -0.6]";
  expect_one(per_cent, "rolling.longitudinal_creepage = -0.6");
  Values per_metre;
  per_metre.spin = "1";
  expect_one(per_metre, "rolling.spin = 1 rad/mm");
  Values friction;
  friction.friction = "30";
  expect_one(friction, "friction.coefficient = 30: dry steel has");
  Values pascals;
  pascals.modulus = "2.1e8";
  EXPECT_EQ(doubts(pascals).size(), 2u);
  for (const char* gigapascals : {"210", "2100"}) {
    Values soft;
    soft.modulus = gigapascals;
    const auto found = doubts(soft);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_TRUE(says(found[0], std::string("wheel.young_modulus = ") + gigapascals + " MPa",
                     "do: give it in MPa if this is in GPa"));
    EXPECT_TRUE(says(found[1], "rail.young_modulus"));
  }
}

TEST(Plausibility, WarnsOfWrongUnitsOfTheTrack) {
  const auto doubts_of = [](const std::string& lines) {
    return implausible_values(parse_case(
        "[load]\nvertical_force = 80e3\n[friction]\ncoefficient = 0.3\n[wheel]\nrolling_radius = "
        "460\nprofile = \"S1002\"\n[rail]\nprofile = \"60E1\"\n" +
            lines,
        "slip.toml"));
  };
  const std::string leaning = "[track]\ninclination = \"1:20\"\n";
  EXPECT_TRUE(doubts_of(leaning + "gauge = 1000\n").empty());
  EXPECT_TRUE(doubts_of("[track]\ninclination = \"none\"\n").empty());
  for (const auto& [lines, beginning] :
       {std::pair<std::string, std::string>{leaning + "gauge = 1.435\n", "track.gauge = 1.435 mm"},
        {leaning + "[wheelset]\nflange_back_distance = 1.36\n",
         "wheelset.flange_back_distance = 1.36 mm"},
        {"[track]\ninclination = 0.4\n", "track.inclination = 0.4 rad"}}) {
    const auto found = doubts_of(lines);
    ASSERT_EQ(found.size(), 1u) << lines;
    EXPECT_TRUE(says(found.front(), "slip.toml: " + beginning, "do: give it in "));
  }
}

TEST(Plausibility, AcceptsDeliberateExtremeValues) {
  EXPECT_TRUE(doubts({}).empty());
  EXPECT_TRUE(doubts({"100", "20", "60", "0.3", "0.1", "210e3"}).empty());  // a roller rig
  EXPECT_TRUE(doubts({"250", "300", "80", "0.1", "0", "5"}).empty());       // rubber
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(ROLLFEM_SOURCE_DIR "/cases")) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_TRUE(implausible_values(read_case(entry.path().string())).empty()) << entry.path();
  }
}

}  // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Profiles of VAMPIRE: four columns behind a header of four lines.
#include "profiles/profile_format.hpp"
#include "profiles/profiles.hpp"

#include <fmt/format.h>

#include "support/contact_inputs.hpp"
#include "support/profile_texts.hpp"

namespace rollfem::profiles {
namespace {

const std::string wheel_header =
    "WHEELPROFILE\nmade by hand\nTREADDATUM EUROPEAN\nFLANGEBACK 1360.0\n";
const std::string rail_header = "RAILPROFILE\n! made by hand\nGAUGEPOINT EUROPEAN\nGAUGE 1435.0\n";

/// S1002 with its tape line `datum` mm from the back of the flange, which is 680 mm from the middle
/// of the track; or the rail with z upward and its crown 36 mm from the gauge. The left side is
/// lowered.
std::string rows(const std::string& name, double datum = 70.0, double lower = 0.0) {
  const bool wheel = find_built_in_profile(name)->wheel;
  std::string text;
  for (const auto& [y, z] : points_of(name)) {
    const double place = wheel ? 680.0 + datum + y : 717.5 + 36.0 + y, down = wheel ? z : 171.3 - z;
    text += fmt::format("{:.10f} {:.10f}, {:.10f}\t{:.10f}\n", -place, down + lower, place, down);
  }
  return text;
}

TEST(VampireFiles, WheelsAndRailsGetTheFrameOfProfiles) {
  EXPECT_LT(off(read(wheel_header + rows("S1002"), true, {}, "a.whe"), "S1002"), spline_tolerance);
  ProfileSource rail;
  rail.shift = {-36.0, 0.0};
  EXPECT_LT(off(read(rail_header + rows("60E1"), false, rail, "a.RAI"), "60E1"), spline_tolerance);
  EXPECT_EQ(body_of_profile("a.whe"), true);
  EXPECT_EQ(body_of_profile("a.rai"), false);
}

TEST(VampireFiles, TheTreadDatumIsTheOrigin) {
  for (const auto& [word, datum] :
       {std::pair{"US1", 72.23125}, {"US2", 77.7875}, {"CUSTOM 66.5", 66.5}}) {
    const std::string text = replaced(wheel_header, "EUROPEAN", word) + rows("S1002", datum);
    EXPECT_LT(off(read(text, true, {}, "a.whe"), "S1002"), spline_tolerance) << word;
  }
}

TEST(VampireFiles, SidesThatDifferAreChosenByTheCase) {
  const std::string text = wheel_header + rows("S1002", 70.0, 0.5);
  ProfileSource source;
  EXPECT_TRUE(says(refusal(text, true, source, "a.whe"),
                   "a.whe: its left and right profiles differ by up to 0.5 mm",
                   "section = \"left\"", "[wheel_profile]"));
  source.section = "right";
  EXPECT_LT(off(read(text, true, source, "a.whe"), "S1002"), spline_tolerance);
  source.section = "left";
  source.shift = {0.0, -0.5};
  EXPECT_LT(off(read(text, true, source, "a.whe"), "S1002"), spline_tolerance);
  source.section = "middle";
  EXPECT_TRUE(says(refusal(text, true, source, "a.whe"), "\"middle\"", "left, right"));
}

TEST(VampireFiles, WheelsWithZUpwardAreFlipped) {
  std::string text = wheel_header;
  for (const auto& [y, z] : points_of("S1002"))
    text += fmt::format("{:.10f} {:.10f} {:.10f} {:.10f}\n", -750.0 - y, -z, 750.0 + y, -z);
  ProfileSource source;
  EXPECT_TRUE(says(refusal(text, true, source, "a.whe"), "flip = true"));
  source.flip = true;
  EXPECT_LT(off(read(text, true, source, "a.whe"), "S1002"), spline_tolerance);
}

TEST(VampireFiles, WrongOnesAreRefusedWithTheirLine) {
  const auto wheel = [&](const std::string& header, const std::string& more = "") {
    return refusal(header + rows("S1002") + more, true, {}, "a.whe");
  };
  EXPECT_TRUE(says(wheel(rail_header), "a.whe:1: the first line is not WHEELPROFILE", "do: "));
  EXPECT_TRUE(says(wheel(""), "a.whe:1: "));
  EXPECT_TRUE(says(wheel(replaced(wheel_header, "EUROPEAN", "EAST")), "a.whe:3: ", "US1, US2"));
  EXPECT_TRUE(says(wheel(replaced(wheel_header, "EUROPEAN", "CUSTOM")), "a.whe:3: "));
  EXPECT_TRUE(says(wheel(replaced(wheel_header, "1360.0", "")), "a.whe:4: FLANGEBACK"));
  EXPECT_TRUE(says(wheel("WHEELPROFILE\n\nTREADDATUM US1\n"), "FLANGEBACK is missing"));
  EXPECT_TRUE(says(wheel("WHEELPROFILE\n\nFLANGEBACK 1360\n"), "TREADDATUM is missing"));
  EXPECT_TRUE(says(wheel(replaced(wheel_header, "FLANGEBACK", "BACK")), "a.whe:4: ", "BACK"));
  EXPECT_TRUE(says(refusal("RAILPROFILE\n\nGAUGEPOINT US\n" + rows("60E1"), false, {}, "a.rai"),
                   "GAUGE is missing"));
  const std::size_t last = 5 + points_of("S1002").size();
  const std::string at = fmt::format("a.whe:{}: ", last);
  EXPECT_TRUE(says(wheel(wheel_header, "-1 2 3\n"), at + "has 3 numbers", "left side"));
  EXPECT_TRUE(says(wheel(wheel_header, "1 2 3 4\n"), at, "y = 1 (left)"));
  EXPECT_TRUE(says(wheel(wheel_header, "-1 2 3 x\n"), at, "x"));
  EXPECT_TRUE(says(refusal(wheel_header, true, {}, "a.whe"), "a.whe"));
  ProfileSource source;
  source.unit = LengthUnit::inch;
  EXPECT_TRUE(says(refusal(wheel_header + rows("S1002"), true, source, "a.whe"), "remove `unit`"));
}

}  // namespace
}  // namespace rollfem::profiles

// SPDX-License-Identifier: LGPL-2.1-or-later
// The keys of profiles in a case file: what they set.
#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"

#include "support/case_examples.hpp"

namespace {

const std::string rest = R"([load]
normal_force = 50e3
[friction]
coefficient = 0.3
[wheel]
rolling_radius = 460.0
)";

/// What profiles need besides; after the sections of the bodies.
const std::string track = "[track]\ninclination = \"1:40\"\n";

TEST(ProfileKeys, AreReadOfBothBodies) {
  const contact::Case input = contact::parse_case(rest + R"(profile = "measured/wheel.csv"
[rail]
profile = "arcs"
[wheel_profile]
unit = "inch"
mirror = true
flip = true
reverse = true
sort = true
drop_duplicates = true
drop_zigzag = true
thinning = 0.2
longest_gap = 7.0
largest_kink = 30.0
rounding = 1.5
rotation = 0.01
shift = [1.0, -2.0]
smoothing = 0.01
[rail_profile]
radii = [300.0, 80.0, 13.0]
ends = [10.0, 26.0, 35.0]
symmetric = true
)" + track,
                                                  "case.toml");
  EXPECT_TRUE(input.has_profiles());
  const contact::ProfileSource& wheel = input.wheel.profile;
  EXPECT_EQ(wheel.name, "measured/wheel.csv");
  EXPECT_EQ(wheel.unit, contact::LengthUnit::inch);
  EXPECT_TRUE(wheel.mirror && wheel.flip && wheel.reverse && wheel.sort);
  EXPECT_TRUE(wheel.drop_duplicates && wheel.drop_zigzag);
  EXPECT_EQ(wheel.thinning, 0.2);
  EXPECT_EQ(wheel.longest_gap, 7.0);
  EXPECT_EQ(wheel.largest_kink, 30.0);
  EXPECT_EQ(wheel.rounding, 1.5);
  EXPECT_EQ(wheel.rotation, 0.01);
  EXPECT_EQ(wheel.shift[1], -2.0);
  EXPECT_EQ(wheel.smoothing, 0.01);
  const contact::ProfileSource& rail = input.rail.profile;
  EXPECT_EQ(rail.radii, (std::vector<double>{300.0, 80.0, 13.0}));
  EXPECT_EQ(rail.ends, (std::vector<double>{10.0, 26.0, 35.0}));
  EXPECT_TRUE(rail.symmetric);
  // Lists of a profile are not load points.
  EXPECT_EQ(input.rolling.creepages.size(), 1u);
}

TEST(ProfileKeys, NothingIsMendedUnlessTold) {
  const contact::Case input = contact::parse_case(
      rest + "profile = \"a.csv\"\n[rail]\nprofile = \"60E1\"\n" + track, "case.toml");
  const contact::ProfileSource& wheel = input.wheel.profile;
  EXPECT_FALSE(wheel.mirror || wheel.flip || wheel.reverse || wheel.sort);
  EXPECT_FALSE(wheel.drop_duplicates || wheel.drop_zigzag);
  EXPECT_EQ(wheel.rounding + wheel.smoothing + wheel.thinning + wheel.rotation, 0.0);
  EXPECT_EQ(wheel.unit, contact::LengthUnit::mm);
}

}  // namespace

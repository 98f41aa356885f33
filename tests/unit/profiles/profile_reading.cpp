// SPDX-License-Identifier: LGPL-2.1-or-later
// Profiles as instruments and programs write them: comments, headings, refusals, and wheels
// measured from the back of the flange.
#include "profiles/profiles.hpp"

#include <fmt/format.h>

#include "support/profile_texts.hpp"
#include <regex>

namespace rollfem::profiles {
namespace {

/// Every third row with one of the comments behind it, and a row of comment after it.
std::string commented(const std::string& rows) {
  const char* marks[] = {" % 0.1 mm steps", " ! worn", " \"here\"", " # 12", " // see 3"};
  std::string text;
  int k = 0;
  for (const char c : rows) {
    if (c == '\n' && k++ % 3 == 0) {
      text += marks[(k / 3) % 5];
      text += "\n% a remark, with 2 numbers 3\n";
      continue;
    }
    text += c;
  }
  return text;
}

TEST(ProfileReading, CommentsMayStandBehindARowInEveryFormat) {
  const std::string rows = commented(columns(points_of("60E1")));
  EXPECT_LT(off(read(rows, false), "60E1"), spline_tolerance);
  const std::string simpack =
      "% by hand\nheader.begin % rail\ntype = 0 % rail\nheader.end\n"
      "spline.begin\nunits.len.f = 1000 \"mm\"\npoint.begin ! list\n" +
      rows + "point.end\nspline.end\n";
  EXPECT_LT(off(read(simpack, false, {}, "rail.prr"), "60E1"), spline_tolerance);
  for (const char* name : {"rail.ban", "rail.whl", "rail.mpt", "RAIL.MPT"})
    EXPECT_LT(
        off(read("% as measured\nDate=1 % of May\nColumnDef=X,Y % mm\n\n" + rows, false, {}, name),
            "60E1"),
        spline_tolerance)
        << name;
}

TEST(ProfileReading, CurveKnowsRoundingOfDensePoints) {
  const auto rounding = [](double spacing, int decimals) {
    std::string text;
    for (const auto& [y, z] : points_of("60E1", spacing))
      text += fmt::format("{:.{}f} {:.{}f}\n", y, decimals, z, decimals);
    const ProfileCurve curve = read(text, false);
    EXPECT_EQ(curve.part(-5.0, 5.0).moved(0.1, 2.0, 3.0).knots().rounding, curve.knots().rounding);
    return curve.knots().rounding;
  };
  EXPECT_NEAR(rounding(0.005, 4), 1e-4 / std::sqrt(12.0), 1e-5);
  for (const double spacing : {0.1, 0.2, 0.5}) EXPECT_EQ(rounding(spacing, 4), 0.0);
  EXPECT_EQ(rounding(0.005, 9), 0.0);
}

TEST(ProfileReading, HeadingsMayFillSeveralLines) {
  const Points points = points_of("60E1");
  const std::string rows = columns(points, ",");
  for (const std::string& heading :
       {std::string("Rail 60E1\nmeasured in May\n\ny,z\n[mm],[mm]\n-----,-----\n"),
        std::string("Operator: N. N.\ny,z\n"), std::to_string(points.size()) + "\n",
        std::string("rail\n") + std::to_string(points.size()) + "\ny,z\n"})
    EXPECT_LT(off(read(heading + rows, false), "60E1"), spline_tolerance) << heading;
  std::string swapped;
  for (const auto& [y, z] : points) swapped += fmt::format("{:.9f},{:.9f},7\n", z, y);
  EXPECT_LT(off(read("Rail\nz,y,n\n(mm),(mm),(-)\n" + swapped, false), "60E1"), spline_tolerance);
}

TEST(ProfileReading, TextThatMakesNoSenseIsRefusedWithItsLine) {
  const std::string rows = columns(points_of("60E1"));
  const auto expect_said = [](const std::string& text, const std::string& name,
                              const std::string& said) {
    const std::string message = refusal(text, false, {}, name);
    EXPECT_EQ(message.rfind(said, 0), 0u) << message;
    EXPECT_TRUE(says(message, "; do: "));
  };
  expect_said("y z\n" + rows + "end of list\n", "a.txt",
              fmt::format("a.txt:{}: expected a number, got `end`", points_of("60E1").size() + 2));
  expect_said("-36.0 37.x\n" + rows, "a.txt", "a.txt:1: expected a number, got `37.x`");
  expect_said("rail\n-36,0 37,5\n-35,9x 37\n", "a.txt", "a.txt:2: has 4 numbers");
  expect_said("1o.5 3\n" + rows, "a.txt", "a.txt:1: expected a number, got `1o.5`");
  expect_said("To whom it may concern:\nno list follows\n", "a.txt", "a.txt:2: is not a profile");
  // Messages never quote the contents of files that hold no profile.
  expect_said("root:x:0:0:root:/root:/bin/sh\nuser:secret:1000\n", "passwd",
              "passwd:2: is not a profile");
  EXPECT_FALSE(says(refusal("root:x:0:0\nuser:secret:1000\n", false, {}, "a.prr"), "secret"));
  expect_said("12\n" + rows, "a.txt", "a.txt:1: only one number");
  expect_said("Rail\n-36.0 37..5 0\n" + rows, "a.ban", "a.ban:2: expected a number, got `37..5`");
  expect_said("Rail\n" + rows + "the end\n", "a.mpt",
              fmt::format("a.mpt:{}: expected a number, got `the`", points_of("60E1").size() + 2));
  expect_said("spline.begin\nfree text\npoint.begin\n" + rows + "point.end\nspline.end\n", "a.prr",
              "a.prr:2: `free text` is not a key");
  expect_said("spline.begin\npoint.begin\n1 2\nand so on\npoint.end\n", "a.prr",
              "a.prr:4: expected a number, got `and`");
}

/// A corner right after points in a row: it is where the curve turns, and as large as it is.
TEST(ProfileReading, AKinkIsReportedWithItsPlaceAndAngle) {
  std::string rows;
  for (int k = -40; k <= 40; ++k)
    rows += fmt::format("{} {:.9f}\n", 0.5 * k, k <= 0 ? 0.0 : 0.5 * k * std::tan(0.4));
  const std::string message = refusal(rows, false);
  EXPECT_EQ(message.rfind("profile.txt:41: kink of 22.9 degrees at y = 0,", 0), 0u) << message;
  EXPECT_TRUE(says(message, "`largest_kink = 23`"));
  ProfileSource source;
  source.largest_kink = 23.0;
  EXPECT_NO_THROW(read(rows, false, source));
  source.largest_kink = 22.9;
  EXPECT_FALSE(says(refusal(rows, false, source), "kink of 0 "));
}

/// Steps everywhere are scatter: the least that explains them is proposed, and half does not.
TEST(ProfileReading, TheLeastSmoothingThatSufficesIsProposed) {
  Points points = points_of("60E1", 0.1);
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k][1] += 0.01 * std::sin(12.9898 * static_cast<double>(k * k));
  const std::string text = columns(points);
  const std::string message = refusal(text, false);
  std::smatch found;
  ASSERT_TRUE(std::regex_search(message, found, std::regex("`smoothing = ([0-9.]+)`"))) << message;
  ProfileSource source;
  source.smoothing = std::stod(found[1]);
  EXPECT_NO_THROW(read(text, false, source));
  EXPECT_LE(source.smoothing, 0.01);
  source.smoothing *= 0.5;
  EXPECT_THROW(read(text, false, source), contact::InputError);
}

TEST(ProfileReading, AWheelMeasuredFromTheBackOfItsFlangeIsToldFromOneThatIsNot) {
  const TemporaryFolder folder;
  Points points = points_of("S1002");
  for (auto& q : points) q[0] += 70.0;
  folder.file("back.txt", columns(points));
  contact::Case input;
  input.file = folder.path("case.toml");
  input.wheel.rolling_radius = 460.0;
  input.wheel.profile.name = "back.txt";
  const std::string message =
      refusal<contact::InputError>([&] { static_cast<void>(profile_of_case(input, true)); });
  EXPECT_TRUE(says(message, "the tip of the flange is at y = 15 mm, where the tread should be",
                   "put `shift = [-70, 0]` under [wheel_profile]",
                   "flange_back_position under [wheelset]"));
  input.wheel.profile.shift = {-70.0, 0.0};
  EXPECT_NEAR(*flange_tip(profile_of_case(input, true)), -55.0, 0.1);
  // Or the wheelset knows where the back is.
  input.wheel.profile.shift = {0.0, 0.0};
  input.wheelset.flange_back_position = 0.0;
  EXPECT_NEAR(*flange_tip(profile_of_case(input, true)), 15.0, 0.1);
}

/// S1002 with the back of its flange and its chamfer measured up to this height above the tread.
Points measured_around(double height) {
  Points points = points_of("S1002");
  const auto first = points.front(), last = points.back();
  for (double z = first[1] - 0.5; z > -height; z -= 0.5)
    points.insert(points.begin(), {first[0], z});
  for (double z = last[1] - 0.5; z > -height; z -= 0.5) points.push_back({last[0], z});
  return points;
}

/// The flange is what the curve comes back from, however far the sides were measured.
TEST(ProfileReading, AWheelIsKnownToBeUpsideDownByItsFlange) {
  ProfileSource source;
  source.largest_kink = 100.0;
  for (const double height : {5.0, 23.0, 60.0}) {
    Points points = measured_around(height);
    EXPECT_NO_THROW(read(columns(points), true, source)) << height;
    for (auto& q : points) q[1] = -q[1];
    EXPECT_TRUE(says(refusal(columns(points), true, source), "upward", "`flip = true`")) << height;
    ProfileSource flipped = source;
    flipped.flip = true;
    EXPECT_NO_THROW(read(columns(points), true, flipped)) << height;
    // A right wheel that is flipped by mistake.
    for (auto& q : points) q[1] = -q[1];
    EXPECT_TRUE(says(refusal(columns(points), true, flipped), "`flip = false`")) << height;
    flipped.mirror = true;
    EXPECT_TRUE(says(refusal(columns(points), true, flipped), "`flip = false`, `mirror = false`"))
        << height;
  }
}

TEST(ProfileReading, AWheelWithTwoFlangesIsNotUpsideDown) {
  Points points;
  for (double y = -40.0; y <= 40.0; y += 0.5)
    points.push_back({y, std::max(0.0, 2.0 * (std::abs(y) - 28.0))});
  ProfileSource source;
  source.largest_kink = 100.0;
  EXPECT_NO_THROW(read(columns(points), true, source));
}

TEST(ProfileReading, AMiniprofFileOfSeveralProfilesIsReadByItsSection) {
  const std::string rail = columns(points_of("60E1"));
  const std::string text = "ProgramName=MiniProf\nColumnDef=X,Y\n[Profile1Points]\n" + rail +
                           "[Profile2Points]\n" + columns(measured_around(5.0));
  EXPECT_TRUE(
      says(refusal(text, false, {}, "both.mpt"), "holds 2 profiles",
           fmt::format("Profile1Points ({} points), Profile2Points", points_of("60E1").size()),
           "`section = "));
  ProfileSource source;
  source.section = "Profile1Points";
  EXPECT_LT(off(read(text, false, source, "both.mpt"), "60E1"), spline_tolerance);
  source.section = "Profile2Points";
  source.largest_kink = 100.0;
  EXPECT_LT(off(read(text, true, source, "both.mpt"), "S1002"), spline_tolerance);
  source.section = "Profile3Points";
  EXPECT_TRUE(says(refusal(text, true, source, "both.mpt"), "\"Profile3Points\" is not one"));
  EXPECT_TRUE(says(refusal(rail, false, source, "rail.txt"), "section cannot be set"));
  // The only one needs no name.
  EXPECT_LT(off(read("[ProfilePoints]\n" + rail, false, {}, "one.ban"), "60E1"), spline_tolerance);
}

TEST(ProfileReading, OldMiniprofHeadersAndRemarksNeedNoQuotes) {
  std::string rows = columns(points_of("60E1"));
  rows.insert(rows.find('\n'), "  added by hand (see 3)");
  for (const char* const header :
       {"MINIPROF 101 148 1994 3 24\nWheel ID....:\n32.58 37.11 14.71  (Sd/Sh/qR)\n\n",
        "MINIPROF 2020\n32.58 37.11 14.71\n(Sd/Sh/qR)\n\n", "MINIPROF 2020\n32.58 37.11 14.71\n\n",
        "Sh=1.2\n", ""}) {
    const ProfileCurve curve = read(header + rows, false, {}, "rail.ban");
    EXPECT_LT(off(curve, "60E1"), spline_tolerance) << header;
    EXPECT_NEAR(curve.at(curve.first()).y, points_of("60E1").front()[0], 1e-9) << header;
  }
  rows.insert(rows.size() - 1, " last");
  EXPECT_LT(off(read(rows, false, {}, "rail.ban"), "60E1"), spline_tolerance);
}

/// Everything is wrong; what the message names mends it in one go.
TEST(ProfileReading, AllRepairsAreNamedInOneMessage) {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(0.0, 0.01);
  Points points = points_of("S1002", 0.2);
  const Points smooth = points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto &a = smooth[k > 0 ? k - 1 : 0], &b = smooth[std::min(k + 1, points.size() - 1)];
    const double part = normal(generator) / std::hypot(b[0] - a[0], b[1] - a[1]);
    points[k] = {part * (b[1] - a[1]) - smooth[k][0], -part * (b[0] - a[0]) - smooth[k][1]};
  }
  points.erase(points.begin() + 400, points.begin() + 430);
  points.insert(points.begin() + 300, points[299]);
  points.insert(points.begin() + 200, {points[199][0] + 0.5, points[199][1] + 0.1});
  const std::string text = columns(points, " ", 1000.0);
  const std::string message = refusal(text, true);
  EXPECT_TRUE(says(message, "profile.txt:302: the point", "profile.txt:201: zig-zag", "gap of 6."));
  EXPECT_TRUE(says(message,
                   "do: put `unit = \"m\"`, `flip = true`, `mirror = true`, "
                   "`drop_duplicates = true`, `drop_zigzag = true`, `longest_gap = 7`, "
                   "`smoothing = "));
  EXPECT_FALSE(says(message, "\n"));
  std::smatch found;
  ASSERT_TRUE(std::regex_search(message, found, std::regex("`smoothing = ([0-9.]+)`"))) << message;
  ProfileSource source;
  source.smoothing = std::stod(found[1]);
  EXPECT_NEAR(source.smoothing, 0.01, 0.0015);
  source.unit = contact::LengthUnit::m;
  source.flip = source.mirror = source.drop_duplicates = source.drop_zigzag = true;
  source.longest_gap = 7.0;
  EXPECT_LT(off(read(text, true, source), "S1002"), 0.02);
}

TEST(ProfileReading, AMeasuredTreadWithoutFlangeHasNoTip) {
  Points points = points_of("S1002");
  points.erase(
      std::remove_if(points.begin(), points.end(), [](const auto& q) { return q[0] < -45.0; }),
      points.end());
  EXPECT_FALSE(flange_tip(read(columns(points), true)).has_value());
}

}  // namespace
}  // namespace rollfem::profiles

// SPDX-License-Identifier: LGPL-2.1-or-later
// The command profile: its output, files, figures and refusals.
#include "contact/base/text_fields.hpp"

#include <fmt/format.h>

#include "support/profile_texts.hpp"
#include "support/program.hpp"
#include <cmath>
#include <regex>

namespace {

namespace fs = std::filesystem;

bool tells(const Outcome& outcome, const std::string& part) {
  return outcome.out.find(part) != std::string::npos;
}

/// A case of S1002 on the rail of this section.
std::string with_s1002(const std::string& rail) {
  return "[load]\nvertical_force = 50e3\n[friction]\ncoefficient = 0.3\n[wheel]\n"
         "rolling_radius = 460.0\nprofile = \"S1002\"\n[track]\ninclination = \"1:40\"\n[rail]\n" +
         rail;
}

using Profile = ProgramTest;

TEST_F(Profile, TellsWhatTheStandardSaysOfS1002) {
  const Outcome outcome = done({"profile", "S1002", "-o", "out"});
  EXPECT_EQ(outcome.err, "");
  // EN 13715: flange 28 high, its tip at y = -55, 32.5 thick at 10 below the tape line (-70
  // + 32.5).
  EXPECT_TRUE(tells(outcome, "y = -55.0000, z = 28.0000")) << outcome.out;
  EXPECT_TRUE(tells(outcome, "flange face at z = 10, mm           y = -37.5000")) << outcome.out;
  EXPECT_TRUE(tells(outcome, "12.000 at")) << outcome.out;
  EXPECT_TRUE(tells(outcome, "y = 32.1580, z = -0.7795")) << outcome.out;
  EXPECT_EQ(folder.made(), (std::vector<std::string>{"out", "out/profile.csv", "out/profile.svg"}));
  EXPECT_TRUE(says(folder.text("out/profile.svg"), "<svg"));
}

TEST_F(Profile, SectionsAlongTheWayAreDrawnWithTheirFeatures) {
  const std::string list = std::string(ROLLFEM_SOURCE_DIR) + "/cases/profiles/crossing.sections";
  const Outcome outcome = done({"profile", list, "-o", "out"});
  EXPECT_TRUE(says(outcome.out, "rail " + list, "sections                            25",
                   "0 to 240, 10 apart", "a cubic spline", "10 given in the list"));
  // The nose's crown begins at y = 8 in all sections and rises with it.
  EXPECT_TRUE(
      std::regex_search(outcome.out, std::regex(" 2 +8\\.000, +3\\.\\d+  -> +8\\.000, +2\\.")))
      << outcome.out;
  EXPECT_EQ(folder.made(),
            (std::vector<std::string>{"out", "out/sections.csv", "out/sections.svg"}));
  EXPECT_TRUE(
      says(folder.text("out/sections.svg"), "height of the surface, up [mm]; lines: features"));
  EXPECT_TRUE(says(done({"profile", list, "--json"}).out, "\"features\": 10"));
}

TEST_F(Profile, FeaturesAreFoundWhereAListGivesNone) {
  // Of the crossing, whose nose begins at 0 here: before it there is only the wing.
  const std::string crossing = std::string(ROLLFEM_SOURCE_DIR) + "/cases/profiles/crossing/";
  const std::string whole = contact::text_of_file(crossing + "000.csv", "000.csv", 1'000'000);
  std::string wing;
  for (contact::TextLines lines(whole); lines.next();)
    if (std::stod(std::string(lines.line())) > 34.0) wing += std::string(lines.line()) + "\n";
  folder.file("wing.csv", wing);
  std::string list = "-20 wing.csv\n-10 wing.csv\n";
  for (const char* at : {"000", "010", "020"}) list += at + (" " + crossing) + at + ".csv\n";
  const std::string file = folder.file("nose.sections", list);
  const Outcome outcome = done({"profile", file, "-o", "out"});
  EXPECT_TRUE(says(outcome.out, "5 found, bends and kinks", "  from 0 to 20\n"));
  EXPECT_TRUE(says(folder.text("out/sections.svg"), "lines: features"));
  EXPECT_TRUE(says(folder.text("out/sections.csv"), "-20,1,,\n"));
  // Equal sections have one height everywhere along the way.
  const std::string equal = folder.file("equal.sections", "0 wing.csv\n1 wing.csv\n");
  done({"profile", equal, "-o", "equal"});
  EXPECT_TRUE(folder.holds("equal/sections.svg"));
  EXPECT_TRUE(says(done({"profile", file, "--json"}).out, "null", "\"features\": 5"));
}

TEST_F(Profile, SectionsThatChangeOverThePatchAreNotForFiniteElements) {
  const std::string file = std::string(ROLLFEM_SOURCE_DIR) + "/cases/crossing.toml";
  for (const std::string model : {"fem", "hybrid"}) {
    const Outcome outcome = call(
        {"run", file, "--model", model, "-o", "out", "--set", "placement.track_position=[80.0]"});
    expect_refused(outcome,
                   "it cannot handle profiles that change over the patch by more than 1 %");
    expect_refused(outcome, "do: run with --model halfspace");
  }
}

TEST_F(Profile, TheTableIsAProfileAgain) {
  done({"profile", "60E1", "-o", "one"});
  // Every joint has two rows in the table, one for each side of it, which are one point.
  done({"profile", "one/profile.csv", "--rail", "-o", "again"});
  done({"profile", "S1002", "-o", "wheel"});
  done({"profile", "wheel/profile.csv", "--wheel", "-o", "wheel_again"});
  const std::string file = folder.file("60E1.toml", with_s1002(R"(
profile = "work/one/profile.csv"
)"));
  const Outcome outcome = done({"profile", file, "--rail", "-o", "two"});
  EXPECT_TRUE(tells(outcome, "gauge face 14 mm below the top, mm  y = -35.8712")) << outcome.out;
  EXPECT_TRUE(folder.holds("two/rail.svg"));
}

TEST_F(Profile, SmoothingAndWeightsOfASimpackFileAreNamed) {
  std::string points;
  for (int k = -70; k <= 70; ++k)
    points += fmt::format("{} {:.9f} {}\n", 0.5 * k, 40.0 - std::sqrt(1600.0 - 0.25 * k * k),
                          k == 0 ? 0.5 : 1.0);
  const auto file = [&](const std::string& smooth, const std::string& list) {
    return "header.begin\ntype = 0\nheader.end\nspline.begin\napprox.smooth = " + smooth +
           "\nunits.len.f = 1000\npoint.begin\n" + list + "point.end\nspline.end\n";
  };
  folder.file("rail.prr", file("0.5", points));
  const std::string note =
      "rail.prr: approx.smooth = 0.5 and weights other than 1 (of 1 points) are not applied; "
      "do: give `smoothing` under [rail_profile]";
  EXPECT_TRUE(says(done({"profile", "../rail.prr", "-o", "out"}).err, note));
  const std::string asked = folder.file("c.toml", with_s1002("profile = \"rail.prr\"\n"));
  EXPECT_TRUE(says(done({"check", asked}).err, note));
  EXPECT_TRUE(says(done({"run", asked, "--model", "hertz", "--no-report", "-o", "r"}).err, note));
  const std::string smoothed = folder.file(
      "s.toml", with_s1002("profile = \"rail.prr\"\n[rail_profile]\nsmoothing = 0.001\n"));
  EXPECT_FALSE(says(done({"check", smoothed}).err, "not applied"));
  folder.file("plain.prr", file("0", std::regex_replace(points, std::regex(" 0.5\n"), " 1\n")));
  EXPECT_EQ(done({"profile", "../plain.prr", "-o", "plain"}).err, "");
}

TEST_F(Profile, OfACaseShowsBothBodiesAndMayBeAskedForAgain) {
  const std::string file = folder.file("c.toml", with_s1002("profile = \"60E1\"\n"));
  for (int time = 0; time < 2; ++time) {
    const Outcome outcome = done({"profile", file});
    EXPECT_TRUE(tells(outcome, "wheel S1002")) << outcome.out;
    EXPECT_TRUE(tells(outcome, "rail 60E1")) << outcome.out;
    EXPECT_TRUE(tells(outcome, "where wheel and rail touch")) << outcome.out;
  }
  EXPECT_EQ(folder.made(), (std::vector<std::string>{
                               "results", "results/c_profile", "results/c_profile/pair_left.csv",
                               "results/c_profile/pair_left.svg", "results/c_profile/rail.csv",
                               "results/c_profile/rail.svg", "results/c_profile/wheel.csv",
                               "results/c_profile/wheel.svg"}));
}

TEST_F(Profile, RefusesFilesWithoutAProfileAndWritesNothing) {
  refuses({"profile", "S1003"}, "S1002, S1002-smooth, 60E1");
  refuses({"profile", folder.file("a.csv", "1,2\n")}, "--wheel or --rail");
  refuses({"profile", folder.file("a.csv", "1,2\n"), "--rail"}, "has 1 points");
  refuses({"profile", folder.file("e.csv", ""), "--wheel"}, "is empty");
  refuses({"profile", "60E1", "--wheel"}, "belongs to a rail");
  refuses({"profile", "60E1", "--wheel", "--rail"}, "exclude each other");
  EXPECT_TRUE(folder.made().empty());
}

/// A measured rail with every kind of fault: the keys of one message, pasted into the case, mend
/// it.
TEST_F(Profile, TheKeysOfOneMessageMendAFile) {
  Points points = points_of("60E1", 0.2);
  std::reverse(points.begin(), points.end());
  for (auto& q : points) q[1] = -q[1];
  points.insert(points.begin() + 300, {points[299][0] + 0.5, points[299][1] + 0.1});
  points.insert(points.begin() + 200, points[199]);
  points.erase(points.begin() + 100, points.begin() + 130);
  folder.file("rail.ban", "Gauge=1437.5\n\n" + columns(points));
  const auto case_with = [&](const std::string& keys) {
    return folder.file("c.toml", with_s1002("profile = \"rail.ban\"\n[rail_profile]\n" + keys));
  };
  const Outcome refused = call({"profile", case_with("")});
  expect_refused(refused, "under [rail_profile]");
  std::string keys;
  const std::string list = refused.err.substr(refused.err.find("do: put"));
  const std::regex key("`([^`]*)`");
  for (std::sregex_iterator at(list.begin(), list.end(), key), end; at != end; ++at)
    keys += (*at)[1].str() + '\n';
  EXPECT_EQ(keys, "flip = true\ndrop_duplicates = true\ndrop_zigzag = true\nlongest_gap = 7\n");
  const Outcome outcome = done({"profile", case_with(keys)});
  EXPECT_TRUE(tells(outcome, "gauge face 14 mm below the top, mm  y = -35.87")) << outcome.out;
}

TEST_F(Profile, ScatterIsReportedWithTheSmoothingThatItNeeds) {
  Points points = points_of("60E1", 0.2);
  std::mt19937 generator(4);
  std::normal_distribution<double> normal(0.0, 0.004);
  for (auto& q : points) q[1] += normal(generator);
  folder.file("rail.txt", columns(points));
  const std::string file = folder.file(
      "c.toml", with_s1002("profile = \"rail.txt\"\n[rail_profile]\nlargest_kink = 60\n"));
  EXPECT_TRUE(tells(done({"profile", file, "--rail"}), "put `smoothing = 0.00"));
  EXPECT_TRUE(says(done({"check", file}).err,
                   "warning: " + file + ": rail.profile = \"rail.txt\": its points scatter by 0.00",
                   "do: put `smoothing = 0.00"));
  const Outcome smoothed = done({"check", file, "--set", "rail_profile.smoothing=0.004"});
  EXPECT_FALSE(says(smoothed.err, "scatter"));
}

TEST_F(Profile, CoarseRoundingOfDensePointsIsReported) {
  const auto written = [&](double spacing, int decimals) {
    std::string text;
    for (const auto& [y, z] : points_of("60E1", spacing))
      text += fmt::format("{:.{}f} {:.{}f}\n", y, decimals, z, decimals);
    folder.file("rail.txt", text);
    return folder.file("c.toml", with_s1002("profile = \"rail.txt\"\n"));
  };
  for (const char* command : {"profile", "check"}) {
    EXPECT_TRUE(says(done({command, written(0.005, 4)}).err, "rail.txt: points 0.005 mm apart",
                     "rounded to 0.0001 mm", "`thinning = 0.05`", "under [rail_profile]"));
    EXPECT_FALSE(says(done({command, written(0.2, 4)}).err, "rounded to"));
    EXPECT_FALSE(says(done({command, written(0.005, 9)}).err, "rounded to"));
  }
}

using Wheelset = ProgramTest;

TEST_F(Wheelset, TellsRadiiAnglesAndConicity) {
  const std::string file =
      folder.file("case.toml", with_s1002("profile = \"60E1\"\n[wheelset]\nside = \"both\"\n"));
  const Outcome outcome = done({"wheelset", file, "--reach", "4", "-o", "out"});
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(folder.made(),
            (std::vector<std::string>{"out", "out/wheelset.csv", "out/wheelset.svg"}));
  const std::string table = folder.text("out/wheelset.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 42);  // heading and 0 to 4 mm by 0.1
  EXPECT_TRUE(tells(outcome, "conicity")) << outcome.out;
  refuses({"wheelset", file, "--reach", "90"}, "0.2 to 30 mm");
}

}  // namespace

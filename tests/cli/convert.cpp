// SPDX-License-Identifier: LGPL-2.1-or-later
// convert: from an input file of CONTACT to a result with a known closed form.
#include "halfspace/closed_forms/hertz.hpp"

#include "support/contact_inputs.hpp"
#include "support/profile_texts.hpp"
#include "support/program.hpp"

namespace {

namespace fs = std::filesystem;

using Convert = ProgramTest;

TEST_F(Convert, PushedBallHasTheShiftOfCattaneoAndMindlin) {
  const std::string file = folder.file("ball.inp", pushed_ball);
  const Outcome made = done({"convert", file});
  EXPECT_EQ(made.err, "");
  EXPECT_EQ(made.out.rfind("ball_cases/ball.toml: case 1\n", 0), 0u) << made.out;
  done({"run", "ball_cases/ball.toml", "-o", "out", "--no-report"});
  const auto summary = folder.json("out/summary.json");
  const auto& point = summary["models"][0]["points"][0];
  // Hertz: R = 25 mm, E* = G / (1 - nu). Mindlin: shift for a force of half of mu F_z.
  const double force = 20.0, G = 300.0, nu = 0.25, mu = 0.3;
  const double radius = std::cbrt(0.75 * force * 25.0 * (1.0 - nu) / G);
  const double shift = 3.0 * mu * force * (2.0 - nu) / (8.0 * G * radius) * (1.0 - std::cbrt(0.25));
  EXPECT_NEAR(point["max_pressure"].get<double>(), 1.5 * force / (M_PI * radius * radius),
              0.002 * point["max_pressure"].get<double>());
  EXPECT_NEAR(point["longitudinal_force"].get<double>(), -0.5 * mu * force, 1e-5 * mu * force);
  EXPECT_NEAR(point["longitudinal_shift"].get<double>(), shift, 0.005 * shift);
}

TEST_F(Convert, WritesTheOthersWhenToldTo) {
  const std::string file = folder.file(
      "two.inp", replaced(rolling_ellipse, " 0\n",
                          " 3\n 203100\n 000000\n 0101341\n 40000. 0.002 0. 0.\n 0.4 0.3\n 0\n"));
  const Outcome refused = call({"convert", file, "-o", "made"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(says(refused.err, "case 4: no equivalent: FSTAT = 0.4 and FKIN = 0.3 differ",
                   "convert the others with --partial"));
  EXPECT_TRUE(folder.made().empty());
  const Outcome made = done({"convert", file, "-o", "made", "--partial"});
  EXPECT_EQ(folder.made(), (std::vector<std::string>{"made", "made/two_1.toml"}));
  done({"check", "made/two_1.toml"});
  // Never overwrites a file.
  const Outcome again = call({"convert", file, "-o", "made", "--partial"});
  EXPECT_EQ(again.status, 2);
  EXPECT_TRUE(says(again.err, "made/two_1.toml exists already"));
  EXPECT_EQ(folder.made().size(), 2U);
}

TEST_F(Convert, TakesTheCasesThatAreNamed) {
  const std::string file = folder.file("roll.inp", rolling_ellipse);
  const Outcome made = done({"convert", file, "--cases", "2-3"});
  EXPECT_EQ(made.out.rfind("roll_cases/roll_2.toml: cases 2, 3\n", 0), 0u) << made.out;
  done({"convert", file, "--cases", "3,1", "-o", "other"});
  for (const char number : {'1', '3'}) {  // not consecutive: a file each
    const std::string head = std::string("# Made by rollfem convert of roll.inp, case ") + number;
    EXPECT_EQ(folder.text(std::string("other/roll_") + number + ".toml").rfind(head, 0), 0u);
  }
  for (const auto& [cases, said] : std::vector<std::pair<std::string, std::string>>{
           {"4", "--cases 4: 4: there is no case 4; allowed: numbers and ranges from 1 to 3"},
           {"1-9", "there is no case 9"},
           {"0", "there is no case 0"},
           {"3-1", "the range runs backwards"},
           {"1;2", "1;2: not a number or a range"}})
    refuses({"convert", file, "-o", "wrong", "--cases", cases}, said);
  EXPECT_FALSE(folder.holds("wrong"));
}

/// The ball, pressed on in a second step: by Hertz the patches are 0.156 and 1.96 mm across, 2 and
/// 26 elements of 0.075 mm.
std::string pressed_twice() {
  return replaced(replaced(pushed_ball, " 20.0  -0.5", " 0.01 -0.5"), " 0 module",
                  " 3\n 001120\n 100000\n 0011111\n 200 100 30 1 1d-6\n 20.0 -0.5 0.0 0.0\n 0\n");
}

TEST_F(Convert, FewElementsAreSolvedWithAWarning) {
  const std::string file = folder.file("press.inp", pressed_twice());
  EXPECT_TRUE(says(done({"convert", file}).out, "press_cases/press.toml: cases 1, 2",
                   "note: the patch is only 2 by 2 elements"));
  const Outcome run = done({"run", "press_cases/press.toml", "-o", "out", "--no-report"});
  EXPECT_TRUE(says(run.err + run.out, "warning: the patch has only 2 by 2 of the elements"));
  // Four elements carry alike.
  const auto points = folder.json("out/summary.json")["models"][0]["points"];
  EXPECT_NEAR(points[0]["max_pressure"].get<double>(), 0.01 / (4.0 * 0.075 * 0.075), 1e-6);
}

TEST_F(Convert, HistoryOfCasesLeftOutIsMissed) {
  const std::string file =
      folder.file("press.inp", replaced(pressed_twice(), " 0.01 -0.5", " 10.0 -0.5"));
  done({"convert", file});
  const Outcome made = call({"convert", file, "-o", "second", "--cases", "2"});
  EXPECT_EQ(made.status, 2);
  EXPECT_TRUE(says(made.err, "the case continues case 1, which --cases leaves out"));
}

TEST_F(Convert, PointwiseDistanceIsRead) {
  const std::string file = folder.file(
      "turned.inp", replaced(pushed_ball, "0.02 0.0 0.02\n 0.0 0.0", "0.02 0.004 0.02\n 0.0 0.0"));
  done({"convert", file, "-o", "."});
  done({"run", "turned.toml", "-o", "out", "--no-report"});
  const auto summary = folder.json("out/summary.json");
  // An ellipse at 45 degrees: the principal curvatures are those on the diagonals.
  const double expected =
      rollfem::halfspace::hertz_from_force(0.022, 0.018, 300.0 / 0.75, 20.0).max_pressure;
  EXPECT_NEAR(summary["models"][0]["points"][0]["max_pressure"].get<double>(), expected,
              0.003 * expected);
}

/// Number of files written, all of which `check` accepts.
int accepted(const Folder& folder, const std::string& file, const std::string& into) {
  const Outcome made = folder.call({"convert", file, "--partial", "-o", into});
  EXPECT_TRUE(made.status == 0 || made.status == 2) << made.status << ": " << made.err;
  int files = 0;
  for (const std::string& name : folder.made()) {
    if (name.rfind(into + "/", 0) != 0 || fs::path(name).extension() != ".toml") continue;
    ++files;
    const Outcome checked = folder.call({"check", name});
    EXPECT_EQ(checked.status, 0) << name << ": " << checked.err;
  }
  return files;
}

TEST_F(Convert, CheckAcceptsConvertedCases) {
  int number = 0;
  for (const std::string& text : {pushed_ball, rolling_ellipse, rolled_twice, driven_roller,
                                  pushed_ellipse, pushed_then_rolled, pressed_twice()}) {
    const std::string name = "input_" + std::to_string(++number);
    EXPECT_EQ(accepted(folder, folder.file(name + ".inp", text), name), 1) << text;
  }
}

/// Profiles of our own beside the input of the left wheel.
std::string with_profiles(const Folder& folder, const std::string& text) {
  folder.file("work/wheel.csv", columns(points_of("S1002")));
  folder.file("work/rail.csv", columns(points_of("60E1")));
  return folder.file("work/wheel.inp", text);
}

TEST_F(Convert, ElementsThatAreTooFewAreHalved) {
  const std::string usual =
      replaced(left_wheel, "'wheel.csv' 1 1.0 0.0 1", "'wheel.csv' 0 1.0 0.0");
  done({"convert", with_profiles(folder, usual), "-o", "usual"});
  EXPECT_TRUE(says(folder.text("usual/wheel.toml"), "cell_size = [0.25, 0.2] "));
  const Outcome made = done(

      {"convert", with_profiles(folder, replaced(usual, " 0.25 0.2 ", " 2.5 0.2 ")), "-o", "few"});
  EXPECT_TRUE(says(made.out, "note: elements of 1.25 by 0.2 mm instead of DX by DS"));
  EXPECT_TRUE(says(folder.text("few/wheel.toml"), "cell_size = [1.25, 0.2]\n", "# note: elements"));
  done({"run", "few/wheel.toml", "-o", "out", "--no-report"});
}

TEST_F(Convert, PointsOfProfilesAreRepairedWithANote) {
  // The same case, with a rail whose heights point up and a wheel that repeats a point.
  const std::string usual =
      replaced(left_wheel, "'wheel.csv' 1 1.0 0.0 1", "'wheel.csv' 0 1.0 0.0");
  Points rail = points_of("60E1"), wheel = points_of("S1002");
  for (auto& [y, z] : rail) z = -z;
  wheel.insert(wheel.begin() + 50, wheel[50]);
  const std::string file = with_profiles(folder, usual);
  folder.file("work/rail.csv", columns(rail));
  folder.file("work/wheel.csv", columns(wheel));
  const Outcome made = done({"convert", file, "-o", "made"});
  EXPECT_TRUE(
      says(made.out, "note: points of the profile of the rail are repaired: flip = true",
           "note: points of the profile of the wheel are repaired: drop_duplicates = true"));
  EXPECT_TRUE(says(folder.text("made/wheel.toml"), "\n[rail_profile]\n", "\nflip = true\n",
                   "\n[wheel_profile]\ndrop_duplicates = true\n"));
  done({"check", "made/wheel.toml"});
}

TEST_F(Convert, ProfilesThatAreNotThereAreWarnedOf) {
  const std::string file = folder.file("wheel.inp", left_wheel);
  const Outcome made = done({"convert", file});
  EXPECT_TRUE(says(made.err, "warning: the profile rail.csv does not exist",
                   "warning: the profile wheel.csv does not exist"));
}

TEST_F(Convert, FilesThatAreNoInputAreRefused) {
  refuses({"convert", "none.inp"}, "none.inp");
  refuses({"convert", folder.file("text.inp", "hello\n")}, "is not an input file of CONTACT");
  EXPECT_TRUE(folder.made().empty());
}

}  // namespace

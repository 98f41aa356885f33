// SPDX-License-Identifier: LGPL-2.1-or-later
// Results are the same to the last bit for 1, 2, 3 and 16 threads, on every kind of problem.
#include "support/case_examples.hpp"
#include "support/resume.hpp"

namespace {

struct Kind {
  const char* name;
  std::string text;
};

void PrintTo(const Kind& of, std::ostream* stream) {
  *stream << of.name;
}

const std::string creep_curve = "rolling.longitudinal_creepage=[0.0, 0.0005, 0.001, 0.004]";

const std::string roller_at_heights =
    "[friction]\ncoefficient = 0.3\n[wheel]\nrolling_radius = 460.0\nprofile = \"S1002\"\n"
    "[rail]\nrolling_radius = 500.0\nprofile = \"60E1\"\n[placement]\nyaw = 0.002\n"
    "height = [-0.42, -0.4]\n";

class SameBits : public ProgramTest, public ::testing::WithParamInterface<Kind> {};

TEST_P(SameBits, ForAnyNumberOfThreads) {
  const std::string file = folder.file("case.toml", GetParam().text);
  const auto run = [&](const std::string& threads) {
    done({"run", file, "--no-report", "--threads", threads, "-o", "on" + threads});
  };
  run("1");
  for (const char* threads : {"2", "3", "16"}) {
    run(threads);
    expect_same_results(folder, folder.work() / "on1",
                        folder.work() / ("on" + std::string(threads)));
  }
}

const std::vector<Kind> kinds{
    // 100 elements across: transforms in pieces.
    {"CreepCurve", edited(small_case, {"models=[\"halfspace\"]", creep_curve,
                                       "contact_grid.elements_across=100"})},
    // Sums over its elements in pieces.
    {"LargeGrid",
     edited(small_case, {"models=[\"halfspace\"]", "rolling.longitudinal_creepage=0.001",
                         "contact_grid.elements_across=200"})},
    {"UnlikeBodies",
     edited(small_case, {"models=[\"halfspace\"]", creep_curve, "wheel.young_modulus=70e3",
                         "friction.coefficient=0.3", "contact_grid.elements_across=20"})},
    {"FallingFriction",
     edited(small_case, {"models=[\"halfspace\"]", creep_curve, "friction.law=linear",
                         "friction.kinetic_coefficient=0.4", "friction.half_velocity=500.0",
                         "rolling.speed=10e3", "contact_grid.elements_across=16"})},
    {"PrescribedForces",
     edited(small_case, {"models=[\"halfspace\"]", "rolling.longitudinal_force=[1e3, 5e3, 10e3]",
                         "contact_grid.elements_across=16"})},
    {"Transient",
     edited(small_case, {"models=[\"halfspace\"]", "rolling.problem=transient",
                         "rolling.longitudinal_creepage=0.001", "history.steps=3",
                         "history.step_length=0.5", "contact_grid.elements_across=16"})},
    {"StressBelow",
     edited(small_case, {"models=[\"halfspace\"]", "rolling.longitudinal_creepage=0.001",
                         "output.stress_maxima=true", "contact_grid.elements_across=24"})},
    {"Wheelset",
     edited(wheel_on_rail, {"models=[\"halfspace\"]", "friction.coefficient=0.3",
                            "wheelset.side=both", "wheelset.lateral_shift=[0.0, 3.0, 5.5]",
                            "wheelset.free_rolling=torque", "contact_grid.elements_across=12"})},
    {"RollerAtHeights",
     edited(roller_at_heights, {"models=[\"halfspace\"]", "contact_grid.elements_across=12"})}};

INSTANTIATE_TEST_SUITE_P(Kinds, SameBits, ::testing::ValuesIn(kinds),
                         [](const auto& of) { return of.param.name; });

using Threads = ProgramTest;

TEST_F(Threads, FillTheSameTable) {
  const std::string file =
      folder.file("case.toml", small_case +
                                   "[table]\npoints = [4, 3, 5]\naxis_ratio = [0.5, 2.0]\n"
                                   "largest = [2.0, 2.0, 2.0]\ncheck_points = 10\n");
  for (const char* threads : {"1", "16"})
    done({"table", file, "--no-report", "--threads", threads, "-o", "on" + std::string(threads)});
  for (const std::string name : {"table.csv", "interpolation.csv"})
    EXPECT_EQ(folder.text("on16/" + name), folder.text("on1/" + name)) << name;
}

TEST_F(Threads, SolveAPlanOfSeveralContactsAlike) {
  const std::string file = folder.file(
      "case.toml",
      edited(wheel_on_rail, {"models=[\"auto\"]", "accuracy=0.05", "friction.coefficient=0.3",
                             "wheelset.side=both", "wheelset.lateral_shift=[0.0, 3.0, 5.5]"}));
  const auto points_on = [&](const std::string& threads) {
    done({"run", file, "--no-report", "--threads", threads, "-o", "on" + threads});
    std::vector<nlohmann::json> points;
    const auto summary = folder.json("on" + threads + "/summary.json");
    for (const auto& model : summary["models"])
      for (auto point : model["points"]) {
        point.erase("seconds");
        points.push_back(point);
      }
    return points;
  };
  const auto alone = points_on("1");
  EXPECT_GE(alone.size(), 6U);
  EXPECT_EQ(points_on("16"), alone);
}

TEST_F(Threads, FindTheSameLevelsOfAStudy) {
  const std::string file = folder.file("case.toml", small_case);
  for (const char* threads : {"1", "16"})
    done({"study", file, "-m", "halfspace", "fastsim", "--levels", "3", "--no-report", "--threads",
          threads, "-o", "on" + std::string(threads)});
  EXPECT_EQ(timeless(folder.work() / "on16/study.json"),
            timeless(folder.work() / "on1/study.json"));
}

TEST_F(Threads, ThrowTheErrorOfASerialRun) {
  // The second position lies beyond the rail, the third too.
  const std::string file = folder.file(
      "case.toml", edited(wheel_on_rail, {"models=[\"halfspace\"]", "wheelset.side=both",
                                          "wheelset.lateral_shift=[0.0, 60.0, 70.0]"}));
  const Outcome alone = call({"run", file, "--threads", "1", "-o", "out"});
  const Outcome many = call({"run", file, "--threads", "16", "-o", "out"});
  EXPECT_NE(alone.status, 0);
  EXPECT_EQ(many.status, alone.status);
  EXPECT_TRUE(says(alone.err, "position 2"));
  EXPECT_TRUE(says(many.err, "position 2"));
}

TEST_F(Threads, OutOfRangeAreRefused) {
  const std::string file = folder.file("case.toml", small_case);
  for (const char* wrong : {"0", "-1", "many"})
    EXPECT_EQ(call({"run", file, "--threads", wrong}).status, 2) << wrong;
}

}  // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// --json on standard output, --quiet, and what --version lists.
#include "support/case_examples.hpp"
#include "support/program.hpp"

namespace {

using nlohmann::json;

std::string case_of(const std::string& name) {
  return std::string(ROLLFEM_SOURCE_DIR) + "/cases/" + name;
}

using Json = ProgramTest;

TEST_F(Json, OfCheckHasKeysDefaultsAndModels) {
  const Outcome outcome = done({"check", "--json", folder.file("case.toml", small_case), "--set",
                                "friction.coefficient=0.25"});
  const json found = json::parse(outcome.out);
  EXPECT_EQ(found["kind"], "check");
  EXPECT_EQ(found["keys"]["friction.coefficient"], 0.25);
  EXPECT_EQ(found["keys"]["wheel.transverse_radius"], "inf");
  EXPECT_EQ(found["keys"]["table.check_points"], 200);  // a default
  EXPECT_EQ(found["cannot"]["hertz"], "");
  EXPECT_TRUE(found["contacts"].empty());  // those of true profiles
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(folder.made().empty());
}

TEST_F(Json, OfCheckNamesWheelsAndWarns) {
  const json found = json::parse(done({"check", "--json", case_of("s1002_uic60_left.toml")}).out);
  EXPECT_EQ(found["contacts"].at(0)["place"]["wheel"], "left");
  const Outcome doubtful = done(
      {"check", "--json", folder.file("case.toml", small_case), "--set", "load.normal_force=50"});
  EXPECT_EQ(json::parse(doubtful.out)["warnings"].size(), 1U) << doubtful.err;
  EXPECT_EQ(doubtful.err.rfind("warning: ", 0), 0u);
}

TEST_F(Json, OfAWheelsetHasItsTableInColumns) {
  const std::string file = case_of("manchester_A22.toml");
  const json found = json::parse(done({"wheelset", "--json", file, "--reach", "2"}).out);
  const auto shifts = found["columns"]["lateral_shift"].get<std::vector<double>>();
  ASSERT_EQ(shifts.size(), 21U);
  EXPECT_DOUBLE_EQ(shifts.back(), 2.0);
  const json& left = found["columns"]["radius_left"];
  const json& right = found["columns"]["radius_right"];
  // A shift to the right raises the right wheel's radius; both are alike in the middle.
  EXPECT_NEAR(left.at(0).get<double>(), right.at(0).get<double>(), 1e-9);
  EXPECT_GT(right.at(20).get<double>(), left.at(20).get<double>());
  EXPECT_EQ(found["units"]["radius_left"], "mm");
  EXPECT_TRUE(found["columns"]["conicity_wave"].at(0).is_null());
  EXPECT_TRUE(folder.made().empty());
  done({"wheelset", "--json", file, "--reach", "2", "-o", "out"});
  EXPECT_TRUE(folder.holds("out/wheelset.csv"));
}

TEST_F(Json, OfAProfileHasRadiiAndPoints) {
  const json found = json::parse(done({"profile", "UIC60", "--json"}).out);
  const json& rail = found["profiles"].at(0);
  EXPECT_EQ(rail["body"], "rail");
  // The smallest arc of the head of UIC 60 (EN 13674-1, 60 E1) has a radius of 13 mm.
  EXPECT_NEAR(rail["smallest_radius_convex"]["radius"].get<double>(), 13.0, 0.05);
  const json& columns = rail["columns"];
  EXPECT_EQ(columns["y"].size(), columns["curvature"].size());
  EXPECT_EQ(rail["units"]["curvature"], "1/mm");
  EXPECT_TRUE(folder.made().empty());
}

TEST_F(Json, OfBenchHasRowsAndKeepsProgressOffStandardOutput) {
  const Outcome outcome = done({"bench", "--quick", "--json"}, {"ROLLFEM_CACHE=cache"});
  const json found = json::parse(outcome.out);
  int half_spaces = 0;
  for (const json& row : found["rows"])
    if (row["model"] == "halfspace") {
      ++half_spaces;
      EXPECT_LT(std::abs(row["force_error"].get<double>()), 0.006) << row;
    }
  EXPECT_EQ(half_spaces, 2);
  EXPECT_TRUE(says(outcome.err, "halfspace"));
}

TEST_F(Json, OfStressIsItsFile) {
  done(
      {"run", folder.file("case.toml", small_case), "-m", "halfspace", "-o", "out", "--no-report"});
  const auto before = folder.made();
  const std::vector<std::string> stress{"stress", "out", "--depth-profile", "--json"};
  const json found = json::parse(done(stress).out);
  EXPECT_EQ(folder.made(), before);
  EXPECT_FALSE(found["models"].at(0)["maxima"].empty());
  const Outcome again = done(joined(stress, {"-o", "kept", "--no-figures"}));
  EXPECT_EQ(again.out, folder.text("kept/stress.json"));
}

TEST_F(Json, ThatCannotBeWrittenIsAnError) {
  const std::string command = std::string(ROLLFEM_PROGRAM) + " profile UIC60 --json > /dev/full";
  EXPECT_EQ(execute({"sh", "-c", command}).status, 1);
}

using Quiet = ProgramTest;

TEST_F(Quiet, PrintsNothingAndLeavesWarnings) {
  const std::string file = folder.file("case.toml", small_case);
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"check", file, "-q"},
           {"bench", "--quick", "-q"},
           {"cache", "--quiet"},
           {"profile", "UIC60", "-q", "-o", "profile"},
           {"wheelset", case_of("manchester_A22.toml"), "-q", "-o", "wheelset"}}) {
    const Outcome outcome = done(words);
    EXPECT_EQ(outcome.out, "") << words.front();
    EXPECT_EQ(outcome.err, "") << words.front();
  }
  EXPECT_TRUE(folder.holds("wheelset/wheelset.csv"));
  const Outcome doubtful = done({"check", file, "-q", "--set", "load.normal_force=50"});
  EXPECT_EQ(doubtful.out, "");
  EXPECT_EQ(doubtful.err.rfind("warning: ", 0), 0u);
  // JSON was asked for, so it is printed.
  EXPECT_EQ(json::parse(done({"check", file, "-q", "--json"}).out)["kind"], "check");
}

using Version = ProgramTest;

TEST_F(Version, ListsFeaturesAndLibraries) {
  const Outcome outcome = done({"--version"});
  EXPECT_TRUE(says(outcome.out, "\nfinite elements ", "\nPython module ", "\nlibraries ",
                   "Eigen 3.", "HDF5 1."));
#if ROLLFEM_WITH_FEM
  EXPECT_TRUE(says(outcome.out, "deal.II 9.", "\nMPI              Open MPI", "\nSIMD ", "sse2"));
  const Outcome narrow = done({"--version"}, {"ROLLFEM_SIMD=sse2"});
  EXPECT_TRUE(says(narrow.out, "\nSIMD             sse2 (this machine has sse2"));
#else
  EXPECT_TRUE(says(outcome.out, "no (built without deal.II)"));
#endif
}

}  // namespace

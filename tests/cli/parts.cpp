// SPDX-License-Identifier: LGPL-2.1-or-later
// Work divided among calls (--part, --merge): the merged result equals that of one call to the last
// bit, missing parts are named, and cases that cannot be divided are refused.
#include "support/case_examples.hpp"
#include "support/resume.hpp"

namespace {

namespace fs = std::filesystem;

/// The balance of each position is solved for, too.
const std::string three_positions =
    edited(wheel_on_rail, {"models=[\"halfspace\"]", "friction.coefficient=0.3",
                           "wheelset.side=both", "wheelset.lateral_shift=[0.0, 2.0, 3.0]",
                           "wheelset.free_rolling=torque", "contact_grid.elements_across=16"});

using Parts = ProgramTest;

TEST_F(Parts, OfARowOfPositionsAreOneRun) {
  const std::vector<std::string> run{"run", folder.file("row.toml", three_positions), "--no-report",
                                     "-o"};
  done(joined(run, {"whole"}));
  EXPECT_TRUE(says(done(joined(run, {"out", "--part", "2/2"})).err, "part 2 of 2 is done"));
  EXPECT_FALSE(folder.holds("out"));
  refuses(joined(run, {"out", "--merge", "2"}), "missing beside out: 1; do: run the same");
  done(joined(run, {"out", "--part", "1/2"}));
  EXPECT_GE(records(folder.work() / "out.part-1-of-2.unfinished", "balance-"), 1);
  done(joined(run, {"out", "--merge", "2"}));
  expect_same_results(folder, folder.work() / "whole", folder.work() / "out");
  for (const char* part : {"1", "2"})
    EXPECT_FALSE(folder.holds(std::string("out.part-") + part + "-of-2.unfinished"));
}

TEST_F(Parts, UnderMpirunARowIsDividedAmongTheProcesses) {
  if (std::system("command -v mpirun > /dev/null 2>&1") != 0) GTEST_SKIP() << "no mpirun";
  const std::vector<std::string> run{"run", folder.file("row.toml", three_positions), "--no-report",
                                     "-o"};
  done(joined(run, {"whole"}));
  const Outcome outcome = checked(execute(command_of(joined(run, {"out"}), 2)));
  EXPECT_TRUE(says(outcome.err, "part 1 of 2 is done"));
  expect_same_results(folder, folder.work() / "whole", folder.work() / "out");
  EXPECT_FALSE(folder.holds("out.part-2-of-2.unfinished"));
}

TEST_F(Parts, OfATableAreOneTable) {
  const std::vector<std::string> table{
      "table",
      folder.file("case.toml", small_case + "[table]\npoints = [4, 3, 5]\naxis_ratio = [0.5, 2.0]\n"
                                            "largest = [2.0, 2.0, 2.0]\ncheck_points = 10\n"),
      "--no-report", "-o"};
  done(joined(table, {"whole"}));
  for (const char* part : {"1/2", "2/2"}) done(joined(table, {"out", "--part", part}));
  done(joined(table, {"out", "--merge", "2"}));
  for (const std::string name : {"table.csv", "interpolation.csv"})
    EXPECT_EQ(folder.text("out/" + name), folder.text("whole/" + name)) << name;
}

TEST_F(Parts, OfAStudyAreItsLevels) {
  const std::vector<std::string> study{
      "study", folder.file("case.toml", small_case), "--levels", "3", "--no-report", "-o", "out"};
  for (const char* part : {"1/2", "2/2"}) done(joined(study, {"--part", part}));
  const Outcome merged = done(joined(study, {"--merge", "2"}));
  EXPECT_EQ(folder.json("out/study.json")["places"][0]["series"][0]["levels"].size(), 3U);
  EXPECT_TRUE(says(merged.err, "resumed"));
}

TEST_F(Parts, AnEmptyPartSaysSo) {
  const std::vector<std::string> study{
      "study", folder.file("case.toml", small_case), "--levels", "2", "--no-report", "-o", "out"};
  for (const char* part : {"1/3", "2/3"})
    EXPECT_FALSE(says(done(joined(study, {"--part", part})).err, "is empty")) << part;
  EXPECT_TRUE(
      says(done(joined(study, {"-q", "--part", "3/3"})).err, "warning: part 3 of 3 is empty"));
  done(joined(study, {"--merge", "3"}));
  EXPECT_EQ(folder.json("out/study.json")["places"][0]["series"][0]["levels"].size(), 2U);
}

TEST_F(Parts, WhatCannotBeDividedIsRefused) {
  const std::string file = folder.file("case.toml", small_case);
  const auto refused = [&](const std::vector<std::string>& options, const std::string& says) {
    refuses(joined({"run", file}, options), says);
  };
  refused({"--part", "1/2"}, "nothing to divide");
  refused({"--merge", "2"}, "nothing to divide");
  refused({"--part", "1/2", "--merge", "2"}, "--part with --merge");
  for (const char* wrong : {"3/2", "0/2", "1/1", "1", "a/b", "1/", "/"})
    refused({"--part", wrong}, "K/N");
}

}  // namespace

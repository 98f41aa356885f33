// SPDX-License-Identifier: LGPL-2.1-or-later
// One owner of a result at a time, from the start of a command to its end, and the messages when a
// signal ends it or nobody reads its output.
#include "support/case_examples.hpp"
#include "support/resume.hpp"

namespace {

namespace fs = std::filesystem;

std::string slow_case() {
  return "models = [\"halfspace\"]\n" + small_case +
         "[rolling]\nlongitudinal_creepage = [0.0, 0.0003, 0.0006, 0.0009, 0.0012, 0.0015, 0.002, "
         "0.0025, 0.003, 0.004]\nspin = 1e-4\n[contact_grid]\nelements_across = 100\n";
}

/// Runs `second` while `first` has just begun, then lets `first` be killed.
Outcome second_of(const Folder& folder, const std::vector<std::string>& first,
                  const std::string& lock, const std::vector<std::string>& second) {
  Outcome outcome;
  kill_when(folder, command_of(first), [&] {
    if (folder.text(lock).empty()) return false;
    outcome = folder.call(second);
    return true;
  });
  return outcome;
}

using Owner = ProgramTest;

TEST_F(Owner, ASecondRunIsRefusedAtOnceAndToldByWhom) {
  const std::string file = folder.file("slow.toml", slow_case());
  const std::vector<std::string> run{"run", file, "-o", "out", "--no-report"};
  const Outcome second = second_of(folder, run, "out.lock", run);
  expect_refused(second, "another run is writing this result: process ");
  EXPECT_TRUE(says(second.err, ", started 20"));
  EXPECT_TRUE(says(second.err, "run " + file + " -o out"));
  // The first was killed and has left its file: the next run takes it over and removes it.
  EXPECT_TRUE(folder.holds("out.lock"));
  done({"run", file, "-o", "out", "--no-report", "-m", "hertz", "--quiet"});
  EXPECT_FALSE(folder.holds("out.lock"));
}

TEST_F(Owner, OtherCommandsOwnTheirFoldersToo) {
  const std::string file = folder.file("slow.toml", slow_case());
  // A run into one of the folders of a comparison.
  expect_refused(second_of(folder, {"compare", file, "-o", "c", "-m", "halfspace", "--no-report"},
                           "c/slow.lock", {"run", file, "-o", "c/slow"}),
                 "another run is writing");
  expect_refused(second_of(folder, {"study", file, "-o", "s", "--no-report"}, "s.lock",
                           {"study", file, "-o", "./s/../s"}),
                 "another run is writing");
}

using Interruption = ProgramTest;

TEST_F(Interruption, NamesTheKeptWorkAndHowToResume) {
  const std::string file = folder.file("slow.toml", slow_case());
  const fs::path unfinished = folder.work() / "out.unfinished";
  for (const auto& [signal, status] : {std::pair{"INT", 130}, std::pair{"TERM", 143}}) {
    // Waits until load points are stored; most users run it in a shell script, which is interrupted
    // too.
    const Outcome outcome =
        execute({"/bin/bash", "-c",
                 "\"$0\" run \"$1\" -o out --no-report --resume & child=$!\n"
                 "until ls out.unfinished/*-000[23].point >/dev/null 2>&1; do sleep 0.01; done\n"
                 "kill -" +
                     std::string(signal) + " $child; wait $child; exit $?",
                 ROLLFEM_PROGRAM, file});
    if (std::string(signal) == "TERM") {
      EXPECT_EQ(outcome.status, status) << outcome.err;
      EXPECT_TRUE(says(outcome.err, "rollfem: interrupted: ", "finished solutions are kept in ",
                       "--resume continues from them"));
      EXPECT_FALSE(folder.holds("out.lock"));
    } else {
      // A shell starts background commands with Ctrl-C ignored, and it stays ignored.
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      fs::remove_all(folder.work() / "out");
    }
  }
  const Outcome resumed = done({"run", file, "-o", "out", "--no-report", "--resume"});
  EXPECT_TRUE(says(resumed.err, "solutions of an earlier run"));
  EXPECT_FALSE(fs::exists(unfinished));
}

TEST_F(Interruption, OfNothingKeptSaysSo) {
  std::string text = slow_case();
  text.replace(text.find("= 100\n"), 6, "= 400\n");
  const Outcome outcome =
      call({"run", folder.file("slow.toml", text), "-o", "deep/out"}, {}, interrupt_after(300));
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_TRUE(says(outcome.err, "interrupted: no finished work was stored"));
  EXPECT_TRUE(folder.made().empty());
}

using ClosedOutput = ProgramTest;

TEST_F(ClosedOutput, IsNoFailure) {
  const std::string file = folder.file("small.toml", small_case);
  const auto shell = [&](const std::string& line) {
    return execute({"/bin/bash", "-o", "pipefail", "-c", line, ROLLFEM_PROGRAM, file});
  };
  for (const char* line : {"\"$0\" run \"$1\" -m hertz -o out --no-report | true",
                           "\"$0\" check \"$1\" | true", "trap '' PIPE; \"$0\" check \"$1\" | true",
                           "\"$0\" run \"$1\" -m hertz -o out --no-report >&-"}) {
    const Outcome outcome = shell(line);
    EXPECT_EQ(outcome.status, 0) << line << ": " << outcome.err;
    EXPECT_FALSE(says(outcome.err, "rollfem: ")) << line;
  }
  EXPECT_TRUE(folder.holds("out/summary.json"));
  const Outcome full = shell("\"$0\" check \"$1\" >/dev/full");
  EXPECT_EQ(full.status, 1);
  EXPECT_TRUE(says(full.err, "standard output cannot be written"));
}

}  // namespace

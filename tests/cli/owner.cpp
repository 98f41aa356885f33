// One owner of a result at a time, from the start of a command to its end, and what is said when a
// signal ends it or nobody reads what it prints.
#include "support/case_examples.hpp"
#include "support/places.hpp"
#include "support/resume.hpp"

namespace {

using namespace rollfem::testing;
namespace fs = std::filesystem;

std::string slow_case() {
  return "models = [\"halfspace\"]\n" + small_case +
         "[rolling]\nlongitudinal_creepage = [0.0, 0.0003, 0.0006, 0.0009, 0.0012, 0.0015, 0.002, "
         "0.0025, 0.003, 0.004]\nspin = 1e-4\n[contact_grid]\nelements_across = 100\n";
}

std::vector<std::string> program(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), ROLLFEM_PROGRAM);
  return arguments;
}

/// Runs `second` while `first` has just begun, then lets `first` be killed.
Outcome second_of(const Folder& folder, const std::vector<std::string>& first,
                  const std::string& lock, const std::vector<std::string>& second) {
  Outcome outcome;
  const Killed killed = kill_when(folder, program(first), [&] {
    if (contents(folder.work() / lock).empty()) return false;
    outcome = execute(folder, program(second));
    return true;
  });
  EXPECT_TRUE(killed.killed) << killed.err;
  return outcome;
}

TEST(Owner, ASecondRunIsRefusedAtOnceAndToldByWhom) {
  const Folder folder;
  const std::string file = folder.file("slow.toml", slow_case());
  const std::vector<std::string> run{"run", file, "-o", "out", "--no-report"};
  const Outcome second = second_of(folder, run, "out.lock", run);
  expect_refused(second, "another run is writing this result: process ");
  EXPECT_NE(second.err.find(", started 20"), std::string::npos) << second.err;
  EXPECT_NE(second.err.find("run " + file + " -o out"), std::string::npos) << second.err;
  // The first was killed and has left its file: the next run takes it over and removes it.
  EXPECT_TRUE(fs::exists(folder.work() / "out.lock"));
  const Outcome third =
      execute(folder, program({"run", file, "-o", "out", "--no-report", "-m", "hertz", "--quiet"}));
  EXPECT_EQ(third.status, 0) << third.err;
  EXPECT_FALSE(fs::exists(folder.work() / "out.lock"));
}

TEST(Owner, OtherCommandsOwnTheirFoldersToo) {
  const Folder folder;
  const std::string file = folder.file("slow.toml", slow_case());
  // A run into one of the folders of a comparison.
  expect_refused(second_of(folder, {"compare", file, "-o", "c", "-m", "halfspace", "--no-report"},
                           "c/slow.lock", {"run", file, "-o", "c/slow"}),
                 "another run is writing");
  expect_refused(second_of(folder, {"study", file, "-o", "s", "--no-report"}, "s.lock",
                           {"study", file, "-o", "./s/../s"}),
                 "another run is writing");
}

TEST(Owner, AFileOfTheUserInTheWayIsSpared) {
  const Folder folder;
  const std::string file = folder.file("slow.toml", slow_case());
  folder.file("work/out.lock", "my notes");
  expect_refused(execute(folder, program({"run", file, "-o", "out"})), "is in the way");
  EXPECT_EQ(contents(folder.work() / "out.lock"), "my notes");
}

TEST(Interruption, SaysWhatIsKeptAndHowToGoOn) {
  const Folder folder;
  const std::string file = folder.file("slow.toml", slow_case());
  const fs::path unfinished = folder.work() / "out.unfinished";
  for (const auto& [signal, status] : {std::pair{"INT", 130}, std::pair{"TERM", 143}}) {
    // Until load points are kept; an interrupted shell script is what most users have around it.
    const Outcome outcome = execute(
        folder, {"/bin/bash", "-c",
                 "\"$0\" run \"$1\" -o out --no-report --resume & child=$!\n"
                 "until ls out.unfinished/*-000[23].point >/dev/null 2>&1; do sleep 0.01; done\n"
                 "kill -" +
                     std::string(signal) + " $child; wait $child; exit $?",
                 ROLLFEM_PROGRAM, file});
    if (std::string(signal) == "TERM") {
      EXPECT_EQ(outcome.status, status) << outcome.err;
      EXPECT_NE(outcome.err.find("rollfem: interrupted: "), std::string::npos) << outcome.err;
      EXPECT_NE(outcome.err.find("finished solutions are kept in "), std::string::npos);
      EXPECT_NE(outcome.err.find("--resume continues from them"), std::string::npos) << outcome.err;
      EXPECT_FALSE(fs::exists(folder.work() / "out.lock"));
    } else {
      // A shell starts what is in the background with Ctrl-C ignored, and so it stays.
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      fs::remove_all(folder.work() / "out");
    }
  }
  const Outcome resumed =
      execute(folder, program({"run", file, "-o", "out", "--no-report", "--resume"}));
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("solutions of an earlier run"), std::string::npos) << resumed.err;
  EXPECT_FALSE(fs::exists(unfinished));
}

TEST(Interruption, OfNothingKeptSaysSo) {
  const Folder folder;
  std::string text = slow_case();
  text.replace(text.find("= 100\n"), 6, "= 400\n");
  const Outcome outcome =
      call(folder, {"run", folder.file("slow.toml", text), "-o", "deep/out"}, {}, 300);
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_NE(outcome.err.find("interrupted: no finished work was kept"), std::string::npos)
      << outcome.err;
  EXPECT_TRUE(folder.made().empty());
}

TEST(ClosedOutput, IsNoFailure) {
  const Folder folder;
  const std::string file = folder.file("small.toml", small_case);
  const auto shell = [&](const std::string& line) {
    return execute(folder, {"/bin/bash", "-o", "pipefail", "-c", line, ROLLFEM_PROGRAM, file});
  };
  for (const char* line : {"\"$0\" run \"$1\" -m hertz -o out --no-report | true",
                           "\"$0\" check \"$1\" | true", "trap '' PIPE; \"$0\" check \"$1\" | true",
                           "\"$0\" run \"$1\" -m hertz -o out --no-report >&-"}) {
    const Outcome outcome = shell(line);
    EXPECT_EQ(outcome.status, 0) << line << ": " << outcome.err;
    EXPECT_EQ(outcome.err.find("rollfem: "), std::string::npos) << line << outcome.err;
  }
  EXPECT_TRUE(fs::exists(folder.work() / "out" / "summary.json"));
  const Outcome full = shell("\"$0\" check \"$1\" >/dev/full");
  EXPECT_EQ(full.status, 2);
  EXPECT_NE(full.err.find("standard output cannot be written"), std::string::npos) << full.err;
}

}  // namespace

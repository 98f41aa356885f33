// SPDX-License-Identifier: LGPL-2.1-or-later
// The command run after a kill: it resumes from finished load points with a result identical to the
// last bit; records that are damaged, belong to another case or cannot be written are reported and
// do no harm.
#include "support/resume.hpp"

#include "postprocess/files/seal.hpp"

#include "support/case_examples.hpp"
#include <fstream>

namespace {

namespace fs = std::filesystem;

// Load points are kept from half a second on: enough of them, and on a grid fine enough, for a
// quick machine too.
std::string slow_creepages(const std::string& rolling = "") {
  std::string creepages = "0.0005";
  for (int k = 2; k <= 12; ++k) creepages += ", " + std::to_string(0.0005 * k);
  return "models = [\"halfspace\"]\n" + small_case + "[rolling]\n" +
         (rolling.empty() ? "longitudinal_creepage = [" + creepages + "]\nspin = 1e-4\n"
                          : rolling) +
         "[contact_grid]\nelements_across = 120\n";
}

std::vector<std::string> run(const std::string& file, const std::string& directory,
                             const std::vector<std::string>& options = {}) {
  return joined({"run", file, "-o", directory, "--no-report"}, options);
}

/// The result of the case without a kill, for all tests.
const fs::path& whole() {
  static const Folder folder;
  static const fs::path result = [] {
    folder.done(run(folder.file("slow.toml", slow_creepages()), "whole"));
    return folder.work() / "whole";
  }();
  return result;
}

/// Kills a run once it has kept a few load points; their number.
int leave_unfinished(const Folder& folder, const std::string& file, const std::string& directory) {
  const fs::path unfinished = folder.work() / (directory + ".unfinished");
  kill_when(folder, command_of(run(file, directory)), [&] { return records(unfinished) >= 3; });
  EXPECT_FALSE(folder.holds(directory));
  return records(unfinished);
}

void expect_resumed_like(const fs::path& whole, const Folder& folder, const std::string& file) {
  const int kept = leave_unfinished(folder, file, "killed");
  const Outcome outcome = folder.done(run(file, "killed", {"--resume"}));
  EXPECT_TRUE(says(outcome.err, "resume: " + std::to_string(kept) + " solutions"));
  expect_same_results(folder, whole, folder.work() / "killed");
  EXPECT_FALSE(folder.holds("killed.unfinished"));
}

using Resume = ProgramTest;

TEST_F(Resume, AfterAKillTheResultIsTheSameToTheLastBit) {
  expect_resumed_like(whole(), folder, folder.file("slow.toml", slow_creepages()));
}

TEST_F(Resume, AHistoryGoesOnFromTheStepsBefore) {
  std::string steps = "0.5";
  for (int k = 1; k < 12; ++k) steps += ", 0.5";
  const std::string file = folder.file(
      "slow.toml",
      slow_creepages("problem = \"transient\"\nlongitudinal_creepage = 0.002\n[history]\n"
                     "step_length = [" +
                     steps + "]\n"));
  done(run(file, "whole"));
  expect_resumed_like(folder.work() / "whole", folder, file);
}

TEST_F(Resume, FrictionThatRemembersGoesOnFromThatOfTheParticles) {
  std::string steps = "0.1";
  for (int k = 1; k < 8; ++k) steps += ", 0.1";
  std::string text = slow_creepages(
      "problem = \"transient\"\nspeed = 1e4\nlongitudinal_creepage = 0.01\n"
      "[history]\nstep_length = [" +
      steps + "]\n[layer]\nthickness = 1.0\nshear_modulus = 8200.0\n");
  const std::string constant = "coefficient = 0.55\n";
  text.insert(text.find(constant) + constant.size(),
              "law = \"exponential\"\nkinetic_coefficient = 0.4\nhalf_velocity = 1000.0\n"
              "memory_distance = 0.003\n");
  const std::string file = folder.file("slow.toml", text);
  done(run(file, "whole"));
  expect_resumed_like(folder.work() / "whole", folder, file);
}

TEST_F(Resume, WithoutItTheRunStartsAnewAndSaysThatItNeedNot) {
  const std::string file = folder.file("slow.toml", slow_creepages());
  leave_unfinished(folder, file, "out");
  const Outcome outcome = done(run(file, "out"));
  EXPECT_TRUE(says(outcome.err, "--resume would continue from them",
                   "until it is done they are kept in out.unfinished.earlier"));
  EXPECT_FALSE(folder.holds("out.unfinished"));
  EXPECT_FALSE(folder.holds("out.unfinished.earlier"));
  EXPECT_TRUE(folder.holds("out/summary.json"));
}

TEST_F(Resume, WithoutItNothingIsLostBeforeTheNewRunIsDone) {
  const std::string file = folder.file("slow.toml", slow_creepages());
  const int kept = leave_unfinished(folder, file, "out");
  kill_when(folder, command_of(run(file, "out")),
            [&] { return folder.holds("out.unfinished.earlier"); });
  EXPECT_EQ(records(folder.work() / "out.unfinished.earlier"), kept);
}

TEST_F(Resume, LoadPointsOfAChangedCaseAreRefused) {
  const std::string file = folder.file("slow.toml", slow_creepages());
  const int kept = leave_unfinished(folder, file, "out");
  std::string changed = slow_creepages();
  changed.replace(changed.find("0.0005"), 6, "0.0004");
  folder.file("slow.toml", changed);
  refuses(run(file, "out", {"--resume"}), "slow.toml (or a file that it names) has changed");
  EXPECT_EQ(records(folder.work() / "out.unfinished"), kept);
}

TEST_F(Resume, ADamagedLoadPointIsComputedAgain) {
  const std::string file = folder.file("slow.toml", slow_creepages());
  leave_unfinished(folder, file, "out");
  for (const auto& entry : fs::directory_iterator(folder.work() / "out.unfinished"))
    if (entry.path().string().find("-0002.point") != std::string::npos)
      fs::resize_file(entry.path(), fs::file_size(entry.path()) / 2);
  const Outcome outcome = done(run(file, "out", {"--resume"}));
  EXPECT_TRUE(says(outcome.err, "is damaged"));
  expect_same_results(folder, whole(), folder.work() / "out");
}

TEST_F(Resume, AForgedLoadPointIsComputedAgain) {
  const std::string file = folder.file("slow.toml", slow_creepages());
  leave_unfinished(folder, file, "out");
  const fs::path unfinished = folder.work() / "out.unfinished";
  const std::string about = contents(unfinished / "about.txt");
  int forged = 0;
  for (const auto& entry : fs::directory_iterator(unfinished)) {
    if (entry.path().string().find("-0002.point") == std::string::npos) continue;
    // Sealed as if it were whole.
    const std::string place = about + entry.path().stem().string() + '\n';
    const auto record = postprocess::opened_record(place, contents(entry.path()));
    ASSERT_TRUE(record.has_value());
    std::ofstream(entry.path()) << postprocess::sealed_record(
        place, record->substr(0, record->size() - 8 * 100));
    ++forged;
  }
  ASSERT_EQ(forged, 1);
  const Outcome outcome = done(run(file, "out", {"--resume"}));
  EXPECT_TRUE(says(outcome.err, "-0002.point is damaged"));
  expect_same_results(folder, whole(), folder.work() / "out");
}

TEST_F(Resume, RecordsWithoutTheirFileAreSomebodyElses) {
  const std::string file = folder.file("slow.toml", slow_creepages());
  const int kept = leave_unfinished(folder, file, "out");
  const fs::path unfinished = folder.work() / "out.unfinished";
  fs::remove(unfinished / "about.txt");
  for (const char* option : {"--resume", "--quiet"})
    refuses(run(file, "out", {option}), "which rollfem did not write");
  EXPECT_EQ(records(unfinished), kept);
}

TEST_F(Resume, ALinkInThePlaceOfTheFolderIsNotFollowed) {
  const std::string file = folder.file("slow.toml", slow_creepages());
  const int kept = leave_unfinished(folder, file, "out");
  fs::rename(folder.work() / "out.unfinished", folder.work() / "mine");
  for (const char* name : {"out.unfinished", "out.unfinished.earlier"}) {
    fs::create_directory_symlink("mine", folder.work() / name);
    for (const char* option : {"--resume", "--quiet"})
      refuses(run(file, "out", {option}), "is a symbolic link");
    fs::remove(folder.work() / name);
  }
  EXPECT_EQ(records(folder.work() / "mine"), kept);
  EXPECT_TRUE(folder.holds("mine/about.txt"));
}

TEST_F(Resume, WithNothingToTakeUpItIsAnOrdinaryRun) {
  const std::string file = folder.file("slow.toml", slow_creepages());
  const Outcome outcome = done(run(file, "out", {"--resume", "-m", "hertz"}));
  EXPECT_TRUE(says(outcome.err, "no load points"));
}

TEST_F(Resume, AFullDiskIsReportedOnceAndTheRunContinues) {
  const std::string file = folder.file("slow.toml", slow_creepages());
  // Records need more than the limit, the files of the result less, except results.h5.
  const Outcome outcome =
      execute({"/bin/sh", "-c", "ulimit -f 200; exec \"$0\" \"$@\"", ROLLFEM_PROGRAM, "run", file,
               "-o", "out", "--no-report", "--quiet"});
  const std::string told = "warning: finished load points are no longer stored";
  const std::size_t first = outcome.err.find(told);
  ASSERT_NE(first, std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find(told, first + 1), std::string::npos) << outcome.err;
  EXPECT_TRUE(says(outcome.err, "ulimit -f"));
  // The result does not fit either: nothing half-written is left of it.
  EXPECT_EQ(outcome.status, 1);
  EXPECT_FALSE(folder.holds("out"));
  EXPECT_EQ(records(folder.work() / "out.unfinished"), 0);
}

TEST_F(Resume, WhatAKilledProcessLeftWhileWritingIsCleanedUpAndALivingOnesIsNot) {
  const std::string file = folder.file("quick.toml", slow_creepages());
  const pid_t gone = fork();
  if (gone == 0) _exit(0);
  waitpid(gone, nullptr, 0);
  const fs::path stale = folder.work() / ("out.partial-" + std::to_string(gone));
  const fs::path living = folder.work() / ("out.partial-" + std::to_string(getpid()));
  const fs::path other = folder.work() / "out.partial-notes";
  for (const fs::path& path : {stale, living, other}) {
    fs::create_directory(path);
    std::ofstream(path / "summary.json") << "{";
  }
  done(run(file, "out", {"-m", "hertz"}));
  EXPECT_FALSE(fs::exists(stale));
  EXPECT_TRUE(fs::exists(living));
  EXPECT_TRUE(fs::exists(other));
}

}  // namespace

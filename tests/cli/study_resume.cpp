// SPDX-License-Identifier: LGPL-2.1-or-later
// The command study after a kill: it resumes from finished levels with numbers identical to the
// last bit; levels of another case are refused.
#include "support/case_examples.hpp"
#include "support/csv_rows.hpp"
#include "support/places.hpp"
#include "support/resume.hpp"

namespace {

using namespace rollfem::testing;
namespace fs = std::filesystem;

/// Levels of 10, 20, 40 and 80 across; the last takes a second or so.
std::string slow_study(const std::string& creepage = "0.0003") {
  return small_case + "[rolling]\nlongitudinal_creepage = [0.0, " + creepage +
         ", 0.0006, 0.0009, 0.0012, 0.0015, 0.002, 0.0025, 0.003, 0.004]\nspin = 1e-4\n"
         "[contact_grid]\nelements_across = 40\n";
}

std::vector<std::string> study(const std::string& file, const std::string& directory,
                               const std::vector<std::string>& options = {"-q", "--levels", "4"}) {
  return joined({"study", file, "-o", directory, "--no-report"}, options);
}

/// Records of whole levels in a folder, and of load points of the level at work.
int levels_kept(const fs::path& unfinished, bool whole) {
  std::error_code error;
  int count = 0;
  for (fs::directory_iterator entry(unfinished, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (entry->path().extension() == ".point" && (name.find("-of-") == std::string::npos) == whole)
      ++count;
  }
  return count;
}

/// study.json without times and without data that identify the call.
nlohmann::json timeless(const fs::path& folder) {
  auto all = nlohmann::json::parse(contents(folder / "study.json"));
  for (const char* name : {"command", "started", "checksum"}) all.erase(name);
  for (auto& place : all.at("places")) {
    place.erase("choice");  // says how long things took
    for (auto& series : place.at("series"))
      for (auto& level : series.at("levels")) {
        EXPECT_GT(level.at("seconds").get<double>(), 0.0);
        level.erase("seconds");
      }
  }
  return all;
}

/// Rows of study.csv without times.
auto timeless_rows(const fs::path& folder) {
  auto rows = csv_records(contents(folder / "study.csv"));
  for (auto& row : rows) row.erase("seconds");
  return rows;
}

/// Kills a study in the middle of its last level.
void leave_unfinished(const Folder& folder, const std::string& file) {
  const fs::path unfinished = folder.work() / "out.unfinished";
  kill_when(folder, command_of(study(file, "out")), [&] {
    return levels_kept(unfinished, true) >= 2 && levels_kept(unfinished, false) >= 2;
  });
  EXPECT_FALSE(folder.holds("out"));
}

TEST(StudyResume, FinishedLevelsAndLoadPointsAreTakenUp) {
  const Folder folder;
  const std::string file = folder.file("slow.toml", slow_study());
  done(folder, study(file, "whole"));
  EXPECT_FALSE(folder.holds("whole.unfinished"));
  leave_unfinished(folder, file);
  const int kept = levels_kept(folder.work() / "out.unfinished", true);
  const Outcome outcome = done(folder, study(file, "out", {"--levels", "4", "--resume"}));
  int taken_up = 0;
  for (std::size_t at = outcome.err.find(" across: resumed\n"); at != std::string::npos;
       at = outcome.err.find(" across: resumed\n", at + 1))
    ++taken_up;
  EXPECT_EQ(taken_up, kept) << outcome.err;
  EXPECT_EQ(timeless(folder.work() / "whole"), timeless(folder.work() / "out"));
  EXPECT_EQ(timeless_rows(folder.work() / "whole"), timeless_rows(folder.work() / "out"));
  EXPECT_FALSE(folder.holds("out.unfinished"));
}

TEST(StudyResume, LevelsOfAChangedCaseAreRefused) {
  const Folder folder;
  leave_unfinished(folder, folder.file("slow.toml", slow_study()));
  const std::string file = folder.file("slow.toml", slow_study("0.0004"));
  const Outcome outcome = call(folder, study(file, "out", {"-q", "--levels", "4", "--resume"}));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(says(outcome.err, "slow.toml (or a file that it names) has changed"));
  EXPECT_FALSE(folder.holds("out"));
}

TEST(StudyResume, LevelsOfAChangedProfileAreRefused) {
  const Folder folder;
  const std::string points =
      contents(fs::path(ROLLFEM_SOURCE_DIR) / "cases/profiles/hollow_s1002.csv");
  folder.file("wheel.csv", points);
  const std::string file = folder.file(
      "slow.toml",
      "[load]\nvertical_force = 80e3\n[friction]\ncoefficient = 0.4\n"
      "[wheel]\nrolling_radius = 460.0\nprofile = \"wheel.csv\"\n[rail]\nprofile = "
      "\"60E1\"\n[track]\ninclination = \"1:40\"\n"
      "[rolling]\nlongitudinal_creepage = [0.0, 0.0005, 0.001, 0.0015, 0.002, 0.0025, 0.003]\n"
      "[contact_grid]\nelements_across = 40\n");
  leave_unfinished(folder, file);
  folder.file("wheel.csv", points + "\n");
  const Outcome outcome = call(folder, study(file, "out", {"-q", "--levels", "4", "--resume"}));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(says(outcome.err, "has changed"));
}

TEST(StudyResume, WithoutItTheStudySaysThatThereIsSomething) {
  const Folder folder;
  const std::string file = folder.file("slow.toml", slow_study());
  leave_unfinished(folder, file);
  const Outcome short_study = done(folder, study(file, "out", {"-q", "--levels", "2"}));
  EXPECT_TRUE(says(short_study.err, "--resume would continue from them"));
  EXPECT_FALSE(folder.holds("out.unfinished"));
}

}  // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// The command study after a kill: it resumes from finished levels with numbers identical to the
// last bit; levels of another case are refused.
#include "support/case_examples.hpp"
#include "support/csv_rows.hpp"
#include "support/resume.hpp"

namespace {

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
  return records(unfinished, [&](const std::string& name) {
    return (name.find("-of-") == std::string::npos) == whole;
  });
}

/// study.json without times, of which every level has one.
nlohmann::json timeless_study(const fs::path& folder) {
  const auto all = nlohmann::json::parse(contents(folder / "study.json"));
  for (const auto& place : all.at("places"))
    for (const auto& series : place.at("series"))
      for (const auto& level : series.at("levels"))
        EXPECT_GT(level.at("seconds").get<double>(), 0.0);
  return timeless(folder / "study.json");
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

using StudyResume = ProgramTest;

TEST_F(StudyResume, FinishedLevelsAndLoadPointsAreTakenUp) {
  const std::string file = folder.file("slow.toml", slow_study());
  done(study(file, "whole"));
  EXPECT_FALSE(folder.holds("whole.unfinished"));
  leave_unfinished(folder, file);
  const int kept = levels_kept(folder.work() / "out.unfinished", true);
  const Outcome outcome = done(study(file, "out", {"--levels", "4", "--resume"}));
  int taken_up = 0;
  for (std::size_t at = outcome.err.find(" across: resumed\n"); at != std::string::npos;
       at = outcome.err.find(" across: resumed\n", at + 1))
    ++taken_up;
  EXPECT_EQ(taken_up, kept) << outcome.err;
  EXPECT_EQ(timeless_study(folder.work() / "whole"), timeless_study(folder.work() / "out"));
  EXPECT_EQ(timeless_rows(folder.work() / "whole"), timeless_rows(folder.work() / "out"));
  EXPECT_FALSE(folder.holds("out.unfinished"));
}

TEST_F(StudyResume, LevelsOfAChangedCaseAreRefused) {
  leave_unfinished(folder, folder.file("slow.toml", slow_study()));
  const std::string file = folder.file("slow.toml", slow_study("0.0004"));
  refuses(study(file, "out", {"-q", "--levels", "4", "--resume"}),
          "slow.toml (or a file that it names) has changed");
  EXPECT_FALSE(folder.holds("out"));
}

TEST_F(StudyResume, LevelsOfAChangedProfileAreRefused) {
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
  refuses(study(file, "out", {"-q", "--levels", "4", "--resume"}), "has changed");
}

TEST_F(StudyResume, WithoutItTheStudySaysThatThereIsSomething) {
  const std::string file = folder.file("slow.toml", slow_study());
  leave_unfinished(folder, file);
  const Outcome short_study = done(study(file, "out", {"-q", "--levels", "2"}));
  EXPECT_TRUE(says(short_study.err, "--resume would continue from them"));
  EXPECT_FALSE(folder.holds("out.unfinished"));
}

}  // namespace

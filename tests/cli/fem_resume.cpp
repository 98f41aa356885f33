// SPDX-License-Identifier: LGPL-2.1-or-later
// The finite-element model after a kill, in one process and in two: the run resumes from the coarse
// level of the error estimate and every finished load point, with a result identical to the last
// bit. And the hybrid, whose correction is then in the cache.
#include "support/case_examples.hpp"
#include "support/resume.hpp"

namespace {

namespace fs = std::filesystem;

/// Small bodies; `solver` decides whether two processes can take the case.
std::string coarse_creep_case(const std::string& solver, const std::string& creepages) {
  return "models = [\"fem\"]\n" + with("2000.0", "500.0") +
         "[rolling]\nlongitudinal_creepage = " + creepages +
         "\n[fem]\ncell_size = 1.8\nextent = 20\nlinear_solver = \"" + solver + "\"\n";
}

std::vector<std::string> run(int processes, const std::string& file, const std::string& directory,
                             const std::vector<std::string>& options = {}) {
  return command_of(joined({"run", file, "-o", directory, "--no-report"}, options), processes);
}

/// Kills a run of the case when `level` has more than that many records, resumes it and compares.
void expect_resumed_like(const fs::path& whole, const Folder& folder, const std::string& file,
                         int processes, const std::string& level, int more_than) {
  const fs::path unfinished = folder.work() / "killed.unfinished";
  kill_when(folder, run(processes, file, "killed"),
            [&] { return records(unfinished, level) > more_than; });
  EXPECT_FALSE(folder.holds("killed"));
  Outcome outcome = folder.execute(run(processes, file, "killed", {"--resume"}));
  // The processes of a killed mpirun end when they notice: until then the folder is theirs.
  for (int wait = 0; wait < 20 && says(outcome.err, "another run is writing"); ++wait) {
    std::this_thread::sleep_for(std::chrono::seconds(1));
    outcome = folder.execute(run(processes, file, "killed", {"--resume"}));
  }
  checked(outcome);
  EXPECT_TRUE(says(outcome.err, "solutions of an earlier run"));
  expect_same_results(folder, whole, folder.work() / "killed");
  EXPECT_FALSE(fs::exists(unfinished));
  fs::remove_all(folder.work() / "killed");
}

/// On a grid so fine that load points are kept, which they are after half a second.
const std::string hybrid_case =
    "models = [\"hybrid\"]\n" + with("transverse_radius = inf", "transverse_radius = 405.0") +
    "[rolling]\nlongitudinal_creepage = [0.0, 0.0003, 0.0006, 0.0009, 0.0012, 0.0015, 0.002, "
    "0.0025, "
    "0.003, 0.004]\n[contact_grid]\nelements_across = 80\n[fem]\ndegree = 1\nextent = 25\n";

}  // namespace

using FemResume = ProgramTest;

TEST_F(FemResume, TheHybridTakesUpLoadPointsAndItsCorrection) {
  const std::string file = folder.file("hybrid.toml", hybrid_case);
  const fs::path unfinished = folder.work() / "killed.unfinished";
  const std::vector<std::string> cache{"ROLLFEM_CACHE=cache"};
  kill_when(
      folder, run(1, file, "killed"), [&] { return records(unfinished, "hybrid") > 2; }, cache);
  const Outcome resumed = checked(execute(run(1, file, "killed", {"--resume"}), cache));
  EXPECT_TRUE(says(resumed.err, "solutions of an earlier run"));
  checked(execute(run(1, file, "whole"), cache));
  // Notes are compared as well: in both the correction is the one that the killed run has found.
  expect_same_results(folder, folder.work() / "whole", folder.work() / "killed");
  EXPECT_TRUE(says(folder.text("killed/summary.json"), "comes from the cache"));
}

TEST_F(FemResume, TheResultIsTheSameToTheLastBit) {
  const std::string file =
      folder.file("coarse.toml", coarse_creep_case("factorisation", "[0.0, 0.001, 0.002]"));
  checked(execute(run(1, file, "whole")));
  const fs::path whole = folder.work() / "whole";
  // On the level of the error estimate, after one load point; in the middle of the curve.
  expect_resumed_like(whole, folder, file, 1, "fem-3.6mm", 1);
  expect_resumed_like(whole, folder, file, 1, "fem-1.8mm", 2);
}

TEST_F(FemResume, InTwoProcesses) {
  const std::string file =
      folder.file("coarse.toml", coarse_creep_case("multigrid", "[0.0, 0.002]"));
  checked(execute(run(2, file, "whole")));
  expect_resumed_like(folder.work() / "whole", folder, file, 2, "fem-3.6mm", 2);
}

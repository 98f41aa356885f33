// The finite-element model after a kill, in one process and in two: the coarse level of the error
// estimate and every finished load point are taken up, the result is the same to the last bit. And
// the hybrid, whose correction is then in the cache.
#include "support/places.hpp"
#include "support/resume.hpp"
#include <chrono>
#include <thread>

namespace {

using namespace rollfem::testing;
namespace fs = std::filesystem;

/// Small bodies; `solver` decides whether two processes can take the case.
std::string coarse_creep_case(const std::string& solver, const std::string& creepages) {
  return "title = \"coarse\"\nmodels = [\"fem\"]\n"
         "[load]\nnormal_force = 50e3\n[friction]\ncoefficient = 0.55\n"
         "[wheel]\nrolling_radius = 405.0\ntransverse_radius = inf\n[rail]\ntransverse_radius = "
         "500.0\n"
         "[rolling]\nlongitudinal_creepage = " +
         creepages +
         "\n"
         "[fem]\ncell_size = 1.4\nextent = 20\nlinear_solver = \"" +
         solver + "\"\n";
}

std::vector<std::string> run(int processes, const std::string& file, const std::string& directory,
                             bool resume) {
  std::vector<std::string> command;
  if (processes > 1)
    command = {"mpirun", "--allow-run-as-root", "--oversubscribe", "-n", std::to_string(processes)};
  for (const char* argument : {ROLLFEM_PROGRAM, "run"}) command.emplace_back(argument);
  command.insert(command.end(), {file, "-o", directory, "--no-report"});
  if (resume) command.emplace_back("--resume");
  return command;
}

/// Kills a run of the case when `level` has more than that many records, resumes it and compares.
void expect_resumed_like(const fs::path& whole, const Folder& folder, const std::string& file,
                         int processes, const std::string& level, int more_than) {
  const fs::path unfinished = folder.work() / "killed.unfinished";
  const Killed killed = kill_when(folder, run(processes, file, "killed", false),
                                  [&] { return records(unfinished, level) > more_than; });
  ASSERT_TRUE(killed.killed) << killed.err;
  EXPECT_FALSE(fs::exists(folder.work() / "killed"));
  Outcome outcome = execute(folder, run(processes, file, "killed", true));
  // The processes of a killed mpirun end when they notice: until then the folder is theirs.
  for (int wait = 0; wait < 20 && outcome.err.find("another run is writing") != std::string::npos;
       ++wait) {
    std::this_thread::sleep_for(std::chrono::seconds(1));
    outcome = execute(folder, run(processes, file, "killed", true));
  }
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("solutions of an earlier run"), std::string::npos) << outcome.err;
  expect_same_results(folder, whole, folder.work() / "killed");
  EXPECT_FALSE(fs::exists(unfinished));
  fs::remove_all(folder.work() / "killed");
}

/// On a grid so fine that load points are kept, which they are after half a second.
const char* const hybrid_case =
    "models = [\"hybrid\"]\n[load]\nnormal_force = 50e3\n[friction]\ncoefficient = 0.55\n"
    "[wheel]\nrolling_radius = 405.0\ntransverse_radius = 405.0\n"
    "[rail]\ntransverse_radius = inf\n[rolling]\nlongitudinal_creepage = [0.0, 0.0003, 0.0006, "
    "0.0009, 0.0012, 0.0015, 0.002, 0.0025, 0.003, 0.004]\n"
    "[contact_grid]\nelements_across = 80\n[fem]\ndegree = 1\nextent = 25\n";

}  // namespace

TEST(FemResume, TheHybridTakesUpLoadPointsAndItsCorrection) {
  const Folder folder;
  const std::string file = folder.file("hybrid.toml", hybrid_case);
  const fs::path unfinished = folder.work() / "killed.unfinished";
  const Killed killed = kill_when(
      folder, run(1, file, "killed", false), [&] { return records(unfinished, "hybrid") > 2; },
      "cache");
  ASSERT_TRUE(killed.killed) << killed.err;
  const std::vector<std::string> cache{"ROLLFEM_CACHE=cache"};
  const Outcome resumed = execute(folder, run(1, file, "killed", true), cache);
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("solutions of an earlier run"), std::string::npos) << resumed.err;
  ASSERT_EQ(execute(folder, run(1, file, "whole", false), cache).status, 0);
  // Notes are compared as well: in both the correction is the one that the killed run has found.
  expect_same_results(folder, folder.work() / "whole", folder.work() / "killed");
  EXPECT_NE(contents(folder.work() / "killed" / "summary.json").find("comes from the cache"),
            std::string::npos);
}

TEST(FemResume, TheResultIsTheSameToTheLastBit) {
  const Folder folder;
  const std::string file =
      folder.file("coarse.toml", coarse_creep_case("factorisation", "[0.0, 0.001, 0.002]"));
  ASSERT_EQ(execute(folder, run(1, file, "whole", false)).status, 0);
  const fs::path whole = folder.work() / "whole";
  // On the level of the error estimate, after one load point; in the middle of the curve.
  expect_resumed_like(whole, folder, file, 1, "fem-2.8mm", 1);
  expect_resumed_like(whole, folder, file, 1, "fem-1.4mm", 2);
}

TEST(FemResume, InTwoProcesses) {
  const Folder folder;
  const std::string file =
      folder.file("coarse.toml", coarse_creep_case("multigrid", "[0.0, 0.002]"));
  ASSERT_EQ(execute(folder, run(2, file, "whole", false)).status, 0);
  expect_resumed_like(folder.work() / "whole", folder, file, 2, "fem-2.8mm", 2);
}

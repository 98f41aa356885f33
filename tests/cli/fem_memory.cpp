// The memory that a run says it will need against what it took, and a run that does not fit.
#include <gtest/gtest.h>

#include "support/program.hpp"
#include <cmath>
#include <sys/resource.h>

namespace {

using namespace rollfem::testing;

std::string case_a(const std::string& cell_size, const std::string& solver) {
  return "models = [\"fem\"]\n[load]\nnormal_force = 50e3\n[friction]\ncoefficient = 0.55\n"
         "[wheel]\nrolling_radius = 405.0\ntransverse_radius = inf\n"
         "[rail]\ntransverse_radius = 2000.0\n[rolling]\nproblem = \"frictionless\"\n"
         "[fem]\ncell_size = " +
         cell_size + "\nlinear_solver = \"" + solver + "\"\n";
}

/// Largest resident memory of the children so far, bytes.
double largest_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// Of the finest level, GB.
double told(const std::string& progress) {
  const std::string before = "needs about ";
  const std::size_t at = progress.rfind(before);
  return at == std::string::npos ? std::nan("") : std::stod(progress.substr(at + before.size()));
}

}  // namespace

// One test: the children's largest memory only grows, so the smaller run comes first.
TEST(FemMemoryOfARun, IsWithinThirtyPercentOfWhatWasTold) {
  for (const char* solver : {"multigrid", "factorisation"}) {
    const Folder folder;
    const std::string file = folder.file("a.toml", case_a("1.88", solver));
    const Outcome outcome = call(folder, {"run", file, "--no-report"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NEAR(told(outcome.err) / (1e-9 * largest_of_children()), 1.0, 0.3) << solver << '\n'
                                                                              << outcome.err;
  }
}

TEST(FemMemoryOfARun, ThatDoesNotFitIsRefusedBeforeAnythingIsComputed) {
  const Folder folder;
  const std::string file = folder.file("a.toml", case_a("0.1", "automatic"));
  const Outcome outcome = call(folder, {"run", file}, {"ROLLFEM_MEMORY_GB=1"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("1 GB are available"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("cell_size larger than 0.1 mm"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("mesh"), std::string::npos) << outcome.err;
  EXPECT_TRUE(folder.made().empty());
}

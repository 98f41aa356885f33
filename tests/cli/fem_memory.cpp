// SPDX-License-Identifier: LGPL-2.1-or-later
// The predicted memory of a run against the used memory, and a run that does not fit.
#include "support/case_examples.hpp"
#include "support/program.hpp"
#include <sys/resource.h>

namespace {

std::string case_a(const std::string& cell_size, const std::string& solver) {
  return "models = [\"fem\"]\n" + small_case + "[rolling]\nproblem = \"frictionless\"\n[fem]\n" +
         "cell_size = " + cell_size + "\nlinear_solver = \"" + solver + "\"\n";
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

using FemMemoryOfARun = ProgramTest;

// One test: the children's largest memory only grows, so the smaller run comes first.
TEST_F(FemMemoryOfARun, IsWithinThirtyPercentOfWhatWasTold) {
  for (const char* solver : {"multigrid", "factorisation"}) {
    const std::string file = folder.file("a.toml", case_a("1.88", solver));
    const Outcome outcome = done({"run", file, "--no-report"});
    EXPECT_NEAR(told(outcome.err) / (1e-9 * largest_of_children()), 1.0, 0.3) << solver << '\n'
                                                                              << outcome.err;
  }
}

TEST_F(FemMemoryOfARun, ThatDoesNotFitIsRefusedBeforeAnythingIsComputed) {
  const std::string file = folder.file("a.toml", case_a("0.1", "automatic"));
  const Outcome outcome = call({"run", file}, {"ROLLFEM_MEMORY_GB=1"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(says(outcome.err, "1 GB are available", "cell_size larger than 0.1 mm"));
  EXPECT_FALSE(says(outcome.err, "mesh"));
  EXPECT_TRUE(folder.made().empty());
}

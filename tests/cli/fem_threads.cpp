// SPDX-License-Identifier: LGPL-2.1-or-later
// Finite elements give the same bits for 1, 2, 3 and 16 threads.
#include "support/case_examples.hpp"
#include "support/resume.hpp"

namespace {

struct Solver {
  const char* name;
  const char* model;
  std::vector<std::string> changes;
};

void PrintTo(const Solver& of, std::ostream* stream) {
  *stream << of.name;
}

class SameBitsOfFiniteElements : public ProgramTest,
                                 public ::testing::WithParamInterface<Solver> {};

TEST_P(SameBitsOfFiniteElements, ForAnyNumberOfThreads) {
  const std::string file = folder.file(
      "case.toml", edited(edited(small_case, {"rolling.longitudinal_creepage=[0.0, 0.001]",
                                              "fem.cell_size=1.5", "output.stress_maxima=true"}),
                          GetParam().changes));
  const auto run = [&](const std::string& threads) {
    checked(folder.execute(
        joined({ROLLFEM_PROGRAM}, {"run", file, "-m", GetParam().model, "--no-report", "--threads",
                                   threads, "-o", "on" + threads}),
        {"ROLLFEM_CACHE="}));
  };
  run("1");
  for (const std::string threads : {"2", "3", "16"}) {
    run(threads);
    expect_same_results(folder, folder.work() / "on1", folder.work() / ("on" + threads));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Solvers, SameBitsOfFiniteElements,
    ::testing::Values(Solver{"Multigrid", "fem", {"fem.linear_solver=multigrid"}},
                      Solver{"Factorisation", "fem", {"fem.linear_solver=factorisation"}},
                      Solver{"Hybrid", "hybrid", {"contact_grid.elements_across=20"}}),
    [](const auto& of) { return of.param.name; });

}  // namespace

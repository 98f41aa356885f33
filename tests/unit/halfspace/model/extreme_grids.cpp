// SPDX-License-Identifier: LGPL-2.1-or-later
// Grids that cannot hold or resolve the patch are refused by arithmetic, with the key, before any
// iteration fails to converge on them.
#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "scene/scene.hpp"

#include "support/case_examples.hpp"
#include "support/temporary_folder.hpp"

namespace {

std::string refused(const std::string& grid) {
  const contact::Case input =
      contact::parse_case(plus("[contact_grid]\n" + grid + "\n"), "case.toml");
  return refusal<contact::InputError>([&] { halfspace::run_halfspace(contact::Scene(input), {}); });
}

TEST(ExtremeGrids, AreRefusedAtOnce) {
  for (const char* extent :
       {"extent = [1e-6, 2.65e8]", "extent = [2.65e8, 1e-6]", "extent = [20.0, 2.65e8]",
        "extent = [1e9, 1e9]", "extent = [1e-6, 1e-6]",
        "extent = [20.0, 50.0]\nmiddle = [20.0, 0.0]", "middle = [1e6, 0.0]"})
    EXPECT_TRUE(says(refused(extent), "contact_grid.extent")) << extent;
  for (const char* cells : {"cell_size = [1e-6, 1e6]", "cell_size = [1e6, 1e-6]",
                            "cell_size = [1e-6, 1e-6]", "cell_size = [0.001, 2.0]"})
    EXPECT_TRUE(says(refused(cells), "contact_grid.cell_size")) << cells;
}

TEST(ExtremeGrids, BeyondTheMemoryOfTheMachineAreRefusedAtOnce) {
  const contact::Case input =
      contact::parse_case(plus("[contact_grid]\nelements_across = 2000\n"), "case.toml");
  setenv("ROLLFEM_MEMORY_GB", "5", 1);
  const std::string text =
      refusal<contact::SolveError>([&] { halfspace::run_halfspace(contact::Scene(input), {}); });
  unsetenv("ROLLFEM_MEMORY_GB");
  // 1.5 kB for each of 4 million.
  EXPECT_TRUE(says(text, "needs about 6.03 GB and 5 GB are available: 4 million"));
}

TEST(ExtremeGrids, AnAccuracyIsNotClimbedForBeyondThatMemory) {
  const contact::Case input = contact::parse_case(
      "accuracy = 1e-5\n" + plus("[contact_grid]\nelements_across = 20\n"), "case.toml");
  setenv("ROLLFEM_MEMORY_GB", "0.04", 1);  // some 6 700 elements
  const contact::ModelResult result = halfspace::run_halfspace(contact::Scene(input), {});
  unsetenv("ROLLFEM_MEMORY_GB");
  EXPECT_LT(result.grid.size(), 10000);  // 320 across would have 100 000
  EXPECT_TRUE(says(result.shortfall, "accuracy = 1e-05 was not reached", "0.04 GB are available"));
}

TEST(ExtremeGrids, ThatHoldThePatchAreNotExtreme) {
  // Hertz's ellipse is 7.58 by 21.75 mm; the middle may be off where the area still holds it.
  for (const char* grid : {"extent = [10.0, 25.0]\nmiddle = [0.5, -0.5]\ncell_size = [0.5, 1.0]",
                           "cell_size = [0.1, 2.0]", "middle = [1.0, 0.0]\nelements_across = 10"})
    EXPECT_EQ(refused(grid), "") << grid;
}

}  // namespace

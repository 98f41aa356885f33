// SPDX-License-Identifier: LGPL-2.1-or-later
// The message for a run that does not fit in memory, and the count of unknowns before meshing.
#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"
#include "fem/discretisation/body.hpp"
#include "fem/linear/memory.hpp"
#include "fem/linear/solver_choice.hpp"
#include "fem/mesh/body_mesh.hpp"
#include "fem/mesh/run_layout.hpp"

#include "support/model_keys.hpp"
#include "support/mpi_environment.hpp"
#include "support/temporary_folder.hpp"

namespace {

fem::BodyOptions options_of(double cell_size, bool half) {
  fem::BodyOptions options;
  options.cell_size = cell_size;
  options.fine_half_length = 4.2;
  options.fine_half_width = 12.0;
  options.extent = 87.0;
  options.half = half;
  return options;
}

TEST(FemMemory, ARunThatDoesNotFitSaysWhatWouldHelp) {
  fem::MemoryDemand demand;
  demand.unknowns = {1e6, 1e6};
  demand.factorisation = true;
  demand.body_fields = 1;
  setenv("ROLLFEM_MEMORY_GB", "10", 1);
  const std::string text =
      refusal<contact::SolveError>([&] { fem::refuse_beyond_memory(demand, 0.2, MPI_COMM_WORLD); });
  EXPECT_TRUE(says(text, "10 GB are available", "2 million unknowns", "cell_size",
                   "linear_solver = \"multigrid\"", "body_fields = \"none\"", "mpirun"));
  demand.factorisation = false;
  EXPECT_NO_THROW(fem::refuse_beyond_memory(demand, 0.2, MPI_COMM_WORLD));
  unsetenv("ROLLFEM_MEMORY_GB");
}

TEST(FemMemory, UnknownsAreCountedWithoutAMesh) {
  for (const bool half : {true, false})
    for (const double cell_size : {1.88, 0.94, 0.47}) {
      const fem::BodyOptions options = options_of(cell_size, half);
      const fem::Body body({true, 405.0, contact::infinity}, {}, options, MPI_COMM_WORLD);
      const double predicted = fem::predicted_unknowns(options, 1e9);
      EXPECT_NEAR(predicted / static_cast<double>(body.unknowns()), 1.0, 0.15) << cell_size << half;
    }
}

TEST(FemMemory, CountingStopsAtEnough) {
  const double predicted = fem::predicted_unknowns(options_of(1e-4, true), 1e7);
  EXPECT_GT(predicted, 1e7);
}

TEST(FemMemory, RowsAtTheSurfaceAreAsThinAsMemoryAllows) {
  const contact::Scene scene(contact::parse_case(
      "[load]\nnormal_force = 60e3\n[friction]\ncoefficient = 0.35\n[wheel]\nrolling_radius = "
      "450.0\ntransverse_radius = inf\n[rail]\ntransverse_radius = 450.0\n[rail_plasticity]\n"
      "yield_stress = 400.0\nhardening = 10e3\n",
      "case"));
  constexpr double cell = 0.8;
  contact::Scene fitting = scene;
  std::optional<contact::Note> note;
  EXPECT_FALSE(fem::fit_surface_rows(fitting, cell)) << "no need";
  for (double gigabytes = 4.0; !note && gigabytes > 0.1; gigabytes *= 0.99) {
    setenv("ROLLFEM_MEMORY_GB", std::to_string(gigabytes).c_str(), 1);
    fitting = scene;
    note = fem::fit_surface_rows(fitting, cell);
  }
  ASSERT_TRUE(note);
  EXPECT_TRUE(fem::fit_together(fitting, {cell}));
  unsetenv("ROLLFEM_MEMORY_GB");
  const auto first_row = [&](const contact::Scene& of) {
    return fem::options_of(of, false, fem::run_layout(of, cell).bodies).rows.depth(cell);
  };
  EXPECT_GT(first_row(fitting), 1.2 * first_row(scene));
  EXPECT_TRUE(says(note->text, "memory", "not resolved"));
}

}  // namespace

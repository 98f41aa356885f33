// SPDX-License-Identifier: LGPL-2.1-or-later
// The message for a run that does not fit in memory, and the count of unknowns before meshing.
#include "base/errors.hpp"
#include "fem/discretisation/body.hpp"
#include "fem/linear/memory.hpp"
#include "fem/mesh/body_mesh.hpp"

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

}  // namespace

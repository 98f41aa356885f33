// What the machine still has: /proc/meminfo, cgroups of both versions, the environment; and the
// count of unknowns before there is a mesh.
#include "contact/base/errors.hpp"
#include "fem/body/body.hpp"
#include "fem/solver/memory.hpp"

#include <gtest/gtest.h>

#include "support/mpi_environment.hpp"
#include "support/temporary_folder.hpp"
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

using namespace rollfem;

/// Folders that stand for /proc and /sys/fs/cgroup.
class Machine : public rollfem::testing::TemporaryFolder {
 public:
  Machine() { file("proc/meminfo", "MemTotal: 9000000 kB\nMemAvailable: 4000000 kB\n"); }
  double available() const { return fem::available_bytes(path("proc"), path("cgroup")); }
};

fem::BodyOptions options_of(double cell_size, bool half) {
  fem::BodyOptions options;
  options.cell_size = cell_size;
  options.fine_half_length = 4.2;
  options.fine_half_width = 12.0;
  options.extent = 87.0;
  options.half = half;
  return options;
}

TEST(FemMemory, IsWhatTheKernelSays) {
  const Machine machine;
  EXPECT_EQ(machine.available(), 4000000.0 * 1024.0);
}

TEST(FemMemory, IsNoMoreThanACgroupOfVersionTwoLeaves) {
  const Machine machine;
  machine.file("proc/self/cgroup", "0::/user/job\n");
  machine.file("cgroup/user/job/memory.max", "max\n");
  machine.file("cgroup/user/job/memory.current", "500\n");
  EXPECT_EQ(machine.available(), 4000000.0 * 1024.0);
  machine.file("cgroup/user/memory.max", "2000000000\n");
  machine.file("cgroup/user/memory.current", "1500000000\n");
  machine.file("cgroup/user/memory.stat", "anon 700000000\ninactive_file 300000000\n");
  EXPECT_EQ(machine.available(), 800000000.0);
}

TEST(FemMemory, IsNoMoreThanACgroupOfVersionOneLeaves) {
  const Machine machine;
  machine.file("proc/self/cgroup", "4:cpu,cpuacct:/x\n3:memory:/docker/abc\n");
  // In a container the group itself is mounted as the root.
  machine.file("cgroup/memory/memory.limit_in_bytes", "3000000000\n");
  machine.file("cgroup/memory/memory.usage_in_bytes", "1000000000\n");
  EXPECT_EQ(machine.available(), 2000000000.0);
}

TEST(FemMemory, IsWhatTheEnvironmentSays) {
  setenv("ROLLFEM_MEMORY_GB", "1.5", 1);
  EXPECT_EQ(fem::available_bytes(), 1.5e9);
  setenv("ROLLFEM_MEMORY_GB", "plenty", 1);
  EXPECT_THROW(fem::available_bytes(), contact::InputError);
  unsetenv("ROLLFEM_MEMORY_GB");
}

TEST(FemMemory, ARunThatDoesNotFitSaysWhatWouldHelp) {
  fem::MemoryDemand demand;
  demand.unknowns_of_wheel = demand.unknowns_of_rail = 1e6;
  demand.factorisation = true;
  demand.body_fields = 1;
  setenv("ROLLFEM_MEMORY_GB", "10", 1);
  try {
    fem::refuse_beyond_memory(demand, 0.2, MPI_COMM_WORLD);
    ADD_FAILURE() << "not refused";
  } catch (const contact::SolveError& error) {
    const std::string text = error.what();
    for (const char* part : {"10 GB are available", "2 million unknowns", "cell_size",
                             "linear_solver = \"multigrid\"", "body_fields = \"none\"", "mpirun"})
      EXPECT_NE(text.find(part), std::string::npos) << part << ": " << text;
  }
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

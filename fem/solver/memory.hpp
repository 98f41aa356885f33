// How much memory a level of the finite-element model will need and how much there is, so that a
// run that does not fit says so instead of being killed.
#pragma once

#include <cstddef>
#include <mpi.h>
#include <string>

namespace rollfem::fem {

/// What memory depends on.
struct MemoryDemand {
  double unknowns_of_wheel = 0.0;
  double unknowns_of_rail = 0.0;
  bool factorisation = false;  ///< else multigrid
  bool algebraic = false;      ///< of which this kind, on an assembled matrix
  int body_fields = 0;         ///< load points that keep displacement and stress of both bodies
  bool half = false;           ///< half of each body is modelled; fields are mirrored
  int processes = 1;           ///< in all
};

/// Largest resident memory of one process, bytes. The constants are measured
/// (tests/cli/fem_memory.cpp).
double predicted_bytes(const MemoryDemand& demand);

/// What this machine still has for this process: MemAvailable of /proc/meminfo, what a cgroup (v1
/// or v2) leaves, or the environment variable ROLLFEM_MEMORY_GB (GB of 1e9 bytes) in place of both.
/// Infinite when none can be read. Throws contact::InputError for a value that is not a number.
double available_bytes();

/// The same from given places, for tests: a folder that stands for /proc and one for
/// /sys/fs/cgroup.
double available_bytes(const std::string& proc, const std::string& cgroup);

/// Throws contact::SolveError on every process when the processes of any machine need more than it
/// has; the text has the figures and what to do. Collective.
void refuse_beyond_memory(const MemoryDemand& demand, double cell_size, MPI_Comm communicator);

/// "needs about 2.5 GB of 21.3 GB"; collective.
std::string memory_note(const MemoryDemand& demand, MPI_Comm communicator);

/// Whether the processes of this machine find room; the same on every process. Collective.
bool fits_memory(const MemoryDemand& demand, MPI_Comm communicator);

}  // namespace rollfem::fem

// SPDX-License-Identifier: LGPL-2.1-or-later
// Memory that a level of the finite-element model needs, and the memory available, so that a
// run that does not fit reports it instead of being killed.
#pragma once

#include <array>
#include <mpi.h>
#include <string>

namespace rollfem::fem {

/// Parameters of the memory estimate.
struct MemoryDemand {
  std::array<double, 2> unknowns{};  ///< of wheel and rail; 0: rigid
  std::array<bool, 2> yields{};      ///< with part of the factor in single precision
  bool factorisation = false;        ///< otherwise multigrid
  bool algebraic = false;            ///< algebraic multigrid on an assembled matrix
  /// Bytes on every process for the factors of given coarse meshes; factors of boxes are small.
  double coarse_factors = 0.0;
  int body_fields = 0;  ///< load points that store displacement and stress of both bodies
  bool half = false;    ///< half of each body is modelled; fields are mirrored
  int processes = 1;    ///< total
};

/// Largest resident memory of one process, bytes. The constants are measured
/// (tests/cli/test_fem_run.py).
double predicted_bytes(const MemoryDemand& demand);

/// Throws contact::SolveError on every process when the processes of any machine need more memory
/// than available; the text has figures and remedy. Collective.
void refuse_beyond_memory(const MemoryDemand& demand, double cell_size, MPI_Comm communicator);

/// "needs about 2.5 GB of 21.3 GB"; collective.
std::string memory_note(const MemoryDemand& demand, MPI_Comm communicator);

/// Whether the processes fit into the memory of their machines; the same on every process.
/// Collective.
bool fits_memory(const MemoryDemand& demand, MPI_Comm communicator);

/// How many solves by multigrid of this many unknowns may run beside each other: 1 and as many as
/// memory takes.
std::size_t solves_in_memory(double unknowns);

/// Returns freed memory held by the C library to the system: after a set-up it is as much as the
/// memory in use.
void return_freed_memory();

}  // namespace rollfem::fem

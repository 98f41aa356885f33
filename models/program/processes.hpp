// The rank of this process in a parallel run, found without MPI: a run
// without finite elements must not load it.
#pragma once

namespace rollfem::modelling {

/// Rank and number of processes as mpirun tells them; 0 of 1 without mpirun.
struct Processes {
  int rank = 0;
  int count = 1;
  bool first() const { return rank == 0; }
};
Processes processes();

/// Ends this process of a parallel run after an error without waiting for the others, which may be
/// inside a collective call; mpirun then ends them. Never returns.
[[noreturn]] void leave(int status);

}  // namespace rollfem::modelling

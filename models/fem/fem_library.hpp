// SPDX-License-Identifier: LGPL-2.1-or-later
// The finite-element library, opened at run time: loading deal.II, Trilinos and PETSc takes longer
// than a whole half-space run.
#pragma once

#include "fem/elasticity/model.hpp"

#include <mutex>
#include <string>

namespace rollfem::modelling {

/// Opens the library; throws contact::InputError in a build without it, or when it is not found
/// beside the program. `asked_by`: the option or key that requests the model, for the message.
const fem::Entry& open_fem_library(const std::string& asked_by);

/// Finite elements run in one thread of a process at a time, because MPI, gmsh and METIS are not
/// thread-safe: other threads wait here while the lock lives. A thread may take it twice.
using FemLock = std::unique_lock<std::recursive_mutex>;
FemLock lock_fem();

// MPI, initialised only while parallel models run.

/// Starts the MPI of the finite-element library and finalises it on destruction.
class ParallelSession {
 public:
  /// `asked_by`: the option or key that requests a parallel model, for the message of a build
  /// without the library.
  ParallelSession(const std::string& asked_by, int argc, char** argv);
  ~ParallelSession();
  ParallelSession(const ParallelSession&) = delete;
  ParallelSession& operator=(const ParallelSession&) = delete;

  /// Collective: the text of the first process on every process.
  std::string from_first(const std::string& text) const { return entry_.from_first(text); }
  /// The one that lives, or null.
  static const ParallelSession* living();

 private:
  const fem::Entry& entry_;
};

/// Unless a session lives, starts one for the rest of the process, because MPI starts only once.
/// With the lock.
void need_session(const std::string& asked_by);

}  // namespace rollfem::modelling

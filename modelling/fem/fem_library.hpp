// SPDX-License-Identifier: LGPL-2.1-or-later
// The finite-element library, opened at run time: loading deal.II, Trilinos and PETSc takes longer
// than a whole half-space run.
#pragma once

#include "fem/elasticity/fem_model.hpp"

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

/// The library with its MPI, started by the first call. It lasts until the process ends, because
/// MPI starts only once. `asked_by`: as above.
const fem::Entry& parallel_session(const std::string& asked_by);

}  // namespace rollfem::modelling

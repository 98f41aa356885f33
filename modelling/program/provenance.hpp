// SPDX-License-Identifier: LGPL-2.1-or-later
// Provenance of a result: program, version, machine and time.
#pragma once

#include "contact/solve/model.hpp"
#include "result/write/output.hpp"

#include <filesystem>
#include <string>

namespace rollfem::modelling {

std::string version();
/// Commit it was built from: "unknown" outside of a git checkout; ends in "-dirty" when files were
/// changed.
std::string commit();

/// Provenance of a result computed now by this process. `command`: the whole call.
result::Provenance provenance_of(const contact::ModelRegistry& models, const std::string& command);

// Locations of the program's own parts, in the build folder and when installed.

/// Folder of the running program.
std::filesystem::path program_directory();

/// Folder of the library with this code if another program has loaded it, otherwise of the program.
std::filesystem::path code_directory();

/// Folder of the plotting program's Python package.
std::filesystem::path script_directory();

// The rank of this process in a parallel run, found without MPI: a run
// without finite elements must not load it.

/// Rank and number of processes as mpirun tells them; 0 of 1 without mpirun.
struct Processes {
  int rank = 0;
  int count = 1;
  int on_machine = 1;  ///< those that share this machine, where the launcher tells
  bool first() const { return rank == 0; }
};
Processes processes();

/// Ends this process of a parallel run after an error without waiting for the others, which may be
/// inside a collective call; mpirun then ends them. Never returns.
[[noreturn]] void leave(int status);

}  // namespace rollfem::modelling

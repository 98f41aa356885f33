// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `mesh`: the meshes of wheel and rail as files and a table of their quality; nothing
// is solved.
#pragma once

#include "contact/solve/model.hpp"

#include <string>
#include <vector>

namespace rollfem::app {

struct MeshRequest {
  std::string case_file;
  std::vector<std::string> changes;  ///< of keys, from --set
  std::string directory;             ///< empty: results/<case file without .toml>_mesh
  int argc = 0;                      ///< of main, for MPI
  char** argv = nullptr;
};

/// Writes wheel.msh, rail.msh (coarse), wheel.vtu, rail.vtu (refined) and prints the table. Throws
/// contact::InputError and then writes nothing.
void mesh(const MeshRequest& request, const contact::ModelRegistry& models);

}  // namespace rollfem::app

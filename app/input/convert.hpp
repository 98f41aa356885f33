// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `convert`: case files from a CONTACT input file.
#pragma once

#include "contact/solve/model.hpp"

#include <string>

namespace rollfem::app {

struct ConvertRequest {
  std::string file;
  std::string directory;  ///< empty: <name of the file>_cases
  bool partial = false;   ///< cases without an equivalent are left out
};

/// Writes the case files, says which cases of CONTACT each of them holds, and names on stderr what
/// has no equivalent. Throws contact::InputError, nothing being written then, where the file cannot
/// be read, a case file would be overwritten, or a case has no equivalent and `partial` is not
/// asked for.
void convert(const ConvertRequest& request, const contact::ModelRegistry& models);

}  // namespace rollfem::app

// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `convert`: case files from a CONTACT input file.
#pragma once

#include "contact/solve/model.hpp"

#include <string>

namespace rollfem::app {

struct ConvertRequest {
  std::string file;
  std::string directory;  ///< empty: <name of the file>_cases
  std::string cases;      ///< "1-5,8"; empty: all
  bool partial = false;   ///< accept that cases without an equivalent are left out
};

/// Writes the case files, prints which CONTACT cases each of them holds, and lists on stderr
/// features without equivalent. Throws contact::InputError and writes nothing if the file cannot be
/// read, a case file would be overwritten, or the physics of a case has no equivalent and `partial`
/// is false. Cases with too few elements across the patch are left out; if `partial` is false,
/// throws contact::SolveError once the others are written.
void convert(const ConvertRequest& request, const contact::ModelRegistry& models);

}  // namespace rollfem::app

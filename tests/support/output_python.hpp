// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs a Python script on a file: the independent reader of the output tests.
#pragma once

#include "support/temporary_folder.hpp"
#include "support/test.hpp"
#include <cstdio>

namespace rollfem::testing {

/// What the script printed, errors included. /usr/bin/python3 is Debian's, which has h5py and VTK.
inline std::string python(const std::string& script, const std::string& argument = "") {
  const TemporaryFolder folder;
  const std::string call =
      "/usr/bin/python3 " + folder.file("script.py", script) + " '" + argument + "' 2>&1";
  FILE* pipe = ::popen(call.c_str(), "r");
  if (!pipe) return "cannot run python";
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  ::pclose(pipe);
  return text;
}

inline bool python_can_import(const std::string& modules) {
  return python("import " + modules).empty();
}

/// The same on a file with this content.
inline std::string python_on(const std::string& script, const std::string& name,
                             const std::string& content) {
  const TemporaryFolder folder;
  return python(script, folder.file(name, content));
}

}  // namespace rollfem::testing

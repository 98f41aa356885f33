// Runs a Python script on a file: the independent reader of the output tests.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace rollfem::tests {

/// What the script printed, errors included. /usr/bin/python3 is Debian's, which has h5py and VTK.
inline std::string python(const std::string& script, const std::string& argument = "") {
  const auto file = std::filesystem::path(::testing::TempDir()) /
                    ("rollfem_script_" + std::to_string(::getpid()) + ".py");
  std::ofstream(file) << script;
  const std::string call = "/usr/bin/python3 " + file.string() + " '" + argument + "' 2>&1";
  FILE* pipe = ::popen(call.c_str(), "r");
  if (!pipe) return "cannot run python";
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  ::pclose(pipe);
  std::filesystem::remove(file);
  return text;
}

inline bool python_can_import(const std::string& modules) {
  return python("import " + modules).empty();
}

/// Writes a file for this process only; returns its path.
inline std::string write_temporary(const std::string& name, const std::string& content) {
  const auto path = std::filesystem::path(::testing::TempDir()) /
                    ("rollfem_" + std::to_string(::getpid()) + "_" + name);
  std::ofstream(path, std::ios::binary) << content;
  return path.string();
}

}  // namespace rollfem::tests

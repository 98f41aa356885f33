// Where the program finds its own parts, in the build folder and when installed.
#pragma once

#include <filesystem>

namespace rollfem::modelling {

/// Folder of the running program.
std::filesystem::path program_directory();

/// Folder of the library that this code is in where another program has loaded it, else of the
/// program.
std::filesystem::path code_directory();

/// Folder of the plotting program's Python package.
std::filesystem::path script_directory();

}  // namespace rollfem::modelling

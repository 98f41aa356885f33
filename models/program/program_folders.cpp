#include "models/program/program_folders.hpp"

#include <dlfcn.h>

namespace rollfem::modelling {

namespace fs = std::filesystem;

fs::path program_directory() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::current_path(error) : program.parent_path();
}

fs::path code_directory() {
  Dl_info found{};
  std::error_code error;
  if (dladdr(reinterpret_cast<const void*>(&code_directory), &found) == 0)
    return program_directory();
  const fs::path file = fs::canonical(found.dli_fname, error);
  // The name of a program may be one that was looked for on PATH.
  const bool library = !error && file.filename().string().find(".so") != std::string::npos;
  return library ? file.parent_path() : program_directory();
}

fs::path script_directory() {
  std::error_code error;
  const fs::path code = code_directory();
  // Libraries may lie in a folder of their architecture.
  for (const fs::path& prefix : {program_directory() / "..", code / "..", code / ".." / ".."}) {
    const fs::path installed = prefix / ROLLFEM_DATADIR / "rollfem_figures";
    if (fs::exists(installed, error)) return installed.lexically_normal();
  }
  return fs::path(ROLLFEM_SOURCE_DIR) / "postprocess" / "rollfem_figures";
}

}  // namespace rollfem::modelling

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/program/provenance.hpp"

#include "result/files/result_folder.hpp"

#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <iostream>

namespace rollfem::modelling {

result::Provenance provenance_of(const contact::ModelRegistry& models, const std::string& command) {
  result::Provenance made;
  made.version = version();
  made.commit = commit();
  made.host = result::host_name();
  made.started = result::utc_now();
  made.command = command;
  for (const contact::ModelInfo& model : models.all()) made.labels[model.name] = model.label;
  return made;
}

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
  // The program may have been found on PATH.
  const bool library = !error && file.filename().string().find(".so") != std::string::npos;
  return library ? file.parent_path() : program_directory();
}

fs::path script_directory() {
  std::error_code error;
  const fs::path code = code_directory();
  // The library folder may have a subfolder per architecture.
  for (const fs::path& prefix : {program_directory() / "..", code / "..", code / ".." / ".."}) {
    // In a build folder, with the compiled module.
    if (const fs::path built = prefix / "python" / "rollfem";
        fs::exists(built / "__main__.py", error))
      return built.lexically_normal();
    const fs::path packages = prefix / ROLLFEM_PACKAGE_DIR;
    // pip installs into site-packages, also where Debian's folder is dist-packages.
    for (const fs::path& folder : {packages, packages.parent_path() / "site-packages"}) {
      const fs::path installed = folder / "rollfem";
      if (fs::exists(installed / "__main__.py", error)) return installed.lexically_normal();
    }
  }
  return fs::path(ROLLFEM_SOURCE_DIR) / "postprocess" / "rollfem";
}

namespace {

int number_from(const char* const (&names)[3], int otherwise) {
  for (const char* name : names) {
    const char* text = std::getenv(name);
    if (text == nullptr || *text == '\0') continue;
    char* end = nullptr;
    const long value = std::strtol(text, &end, 10);
    if (*end == '\0' && value >= 0 && value < 1000000) return static_cast<int>(value);
  }
  return otherwise;
}

}  // namespace

Processes processes() {
  // Open MPI, PMIx launchers, and MPICH.
  Processes found;
  found.rank = number_from({"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"}, 0);
  found.count = number_from({"OMPI_COMM_WORLD_SIZE", "PMIX_SIZE", "PMI_SIZE"}, found.rank + 1);
  found.on_machine =
      number_from({"OMPI_COMM_WORLD_LOCAL_SIZE", "PMIX_LOCAL_SIZE", "MPI_LOCALNRANKS"}, 1);
  return found;
}

void leave(int status) {
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
  std::_Exit(status);
}

}  // namespace rollfem::modelling

#include "app/places.hpp"

namespace rollfem::app {

namespace fs = std::filesystem;

fs::path program_directory() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::current_path(error) : program.parent_path();
}

fs::path script_directory() {
  const fs::path installed = program_directory() / ".." / ROLLFEM_DATADIR / "rollfem_figures";
  std::error_code error;
  if (fs::exists(installed, error)) return installed.lexically_normal();
  return fs::path(ROLLFEM_SOURCE_DIR) / "postprocess" / "rollfem_figures";
}

}  // namespace rollfem::app

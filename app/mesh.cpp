#include "app/mesh.hpp"

#include "app/fem_library.hpp"
#include "app/files_together.hpp"
#include "app/processes.hpp"
#include "contact/abilities.hpp"
#include "contact/case_reader.hpp"
#include "contact/errors.hpp"
#include "fem/mesh_report.hpp"
#include "postprocess/vtu.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <vector>

namespace rollfem::app {

namespace fs = std::filesystem;

namespace {

using fem::MeshedBody;

/// The meshes that the case names are input: they are not written over.
void spare_input(const contact::Case& input, const fs::path& folder) {
  const fs::path case_folder = fs::path(input.file).parent_path();
  for (const std::string& file : {input.wheel.mesh, input.rail.mesh})
    for (const char* name : {"wheel.msh", "rail.msh"}) {
      std::error_code error;
      if (file.empty() || !fs::equivalent(case_folder / file, folder / name, error)) continue;
      throw contact::InputError(
          fmt::format("mesh: {} is the mesh that {} names and would be written over; do: name "
                      "another folder with -o",
                      (folder / name).string(), input.file));
    }
}

std::string table(const std::vector<MeshedBody>& bodies) {
  std::string text = fmt::format("{:<34}", "");
  for (const MeshedBody& body : bodies) text += fmt::format("{:>12}", body.name);
  const auto row = [&](const char* what, const auto& value) {
    text += fmt::format("\n{:<34}", what);
    for (const MeshedBody& body : bodies) text += fmt::format("{:>12.5g}", 1.0 * value(body));
  };
  const auto count = [&](const char* what, const auto& value) {
    text += fmt::format("\n{:<34}", what);
    for (const MeshedBody& body : bodies) text += fmt::format("{:>12}", value(body));
  };
  count("coarse cells", [](const MeshedBody& b) { return b.coarse_cells; });
  count("times halved at the patch", [](const MeshedBody& b) { return b.levels; });
  count("cells", [](const MeshedBody& b) { return b.cells; });
  count("unknowns", [](const MeshedBody& b) { return b.unknowns; });
  row("size of cells in the patch, mm", [](const MeshedBody& b) { return b.size_in_patch; });
  row("shortest edge, mm", [](const MeshedBody& b) { return b.shortest_edge; });
  row("longest edge, mm", [](const MeshedBody& b) { return b.longest_edge; });
  row("smallest scaled Jacobian (1: box)",
      [](const MeshedBody& b) { return b.smallest_scaled_jacobian; });
  row("largest aspect ratio", [](const MeshedBody& b) { return b.largest_aspect_ratio; });
  return text + "\n";
}

}  // namespace

void mesh(const MeshRequest& request) {
  const contact::Case input = contact::read_case(request.case_file);
  contact::check_able(input, "fem");
  const fs::path folder =
      !request.directory.empty()
          ? fs::path(request.directory)
          : fs::path("results") / (fs::path(request.case_file).stem().string() + "_mesh");
  spare_input(input, folder);

  const fem::Entry& entry = open_fem_library("mesh");
  int argc = request.argc;
  char** argv = request.argv;
  entry.start(argc, argv);
  const std::vector<MeshedBody> bodies = entry.mesh(input);
  if (processes().first()) {
    FilesTogether files("mesh", folder);
    for (const MeshedBody& body : bodies) {
      files.write(body.name + ".msh", body.msh);
      files.write(body.name + ".vtu", postprocess::body_vtu(body.refined));
    }
    files.commit();
    std::cout << input.title << "\n\n"
              << table(bodies) << "\nmeshes: " << folder.string()
              << " (.msh: coarse, as [wheel] mesh and [rail] mesh take it; .vtu: refined)\n";
  }
  entry.stop();
}

}  // namespace rollfem::app

// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `mesh`: the meshes of wheel and rail as files and a table of their quality; nothing
// is solved.
#include "app/frame/commands.hpp"
#include "base/errors.hpp"
#include "fem/elasticity/mesh_report.hpp"
#include "modelling/fem/fem_library.hpp"
#include "modelling/fem/fem_models.hpp"
#include "modelling/program/provenance.hpp"
#include "modelling/solving/case_scenes.hpp"
#include "result/files/files_together.hpp"
#include "result/write/vtu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <vector>

namespace rollfem::app {

namespace fs = std::filesystem;

namespace {

using fem::MeshedBody;

/// Refuses to overwrite the meshes that the case names as input.
void spare_input(const contact::Case& input, const fs::path& folder) {
  const fs::path case_folder = fs::path(input.file).parent_path();
  for (const std::string& file : {input.wheel.mesh, input.rail.mesh})
    for (const char* name : {"wheel.msh", "rail.msh"}) {
      std::error_code error;
      if (file.empty() || !fs::equivalent(case_folder / file, folder / name, error)) continue;
      throw contact::InputError(
          fmt::format("mesh: {} is the mesh named by {} and would be overwritten; do: name another "
                      "folder with -o",
                      (folder / name).string(), input.file));
    }
}

std::string table(const std::vector<MeshedBody>& bodies) {
  std::size_t width = 12;
  for (const MeshedBody& body : bodies) width = std::max(width, body.name.size() + 2);
  std::string text = fmt::format("{:<34}", "");
  for (const MeshedBody& body : bodies) text += fmt::format("{:>{}}", body.name, width);
  const auto row = [&](const char* what, const char* format, const auto& value) {
    text += fmt::format("\n{:<34}", what);
    for (const MeshedBody& body : bodies)
      text += fmt::format(fmt::runtime(format), value(body), width);
  };
  constexpr const char *count = "{:>{}}", *number = "{:>{}.5g}";
  row("coarse cells", count, [](const MeshedBody& b) { return b.coarse_cells; });
  row("times halved at the patch", count, [](const MeshedBody& b) { return b.levels; });
  row("cells", count, [](const MeshedBody& b) { return b.cells; });
  row("unknowns", count, [](const MeshedBody& b) { return b.unknowns; });
  row("size of cells in the patch, mm", number,
      [](const MeshedBody& b) { return b.size_in_patch; });
  row("shortest edge, mm", number, [](const MeshedBody& b) { return b.shortest_edge; });
  row("longest edge, mm", number, [](const MeshedBody& b) { return b.longest_edge; });
  row("smallest scaled Jacobian (1: box)", number,
      [](const MeshedBody& b) { return b.smallest_scaled_jacobian; });
  row("largest aspect ratio", number, [](const MeshedBody& b) { return b.largest_aspect_ratio; });
  return text + "\n";
}

void mesh(const CaseRequest& request) {
  const contact::Case input = request.read();
  const std::vector<contact::Scene> scenes =
      modelling::scenes_of(input, modelling::placed_wheels(input)).list;
  for (const contact::Scene& scene : scenes)
    request.call.models.check(scene, modelling::fem_model().name);
  const fs::path folder = request.folder("_mesh");
  spare_input(input, folder);

  const fem::Entry& entry = modelling::parallel_session("mesh");
  std::vector<MeshedBody> bodies;
  for (const contact::Scene& scene : scenes)
    for (MeshedBody& body : entry.mesh(scene)) {
      // With profiles every patch has its own bodies.
      if (scene.place) body.name = scene.place->key() + '_' + body.name;
      bodies.push_back(std::move(body));
    }
  if (modelling::processes().first()) {
    result::FilesTogether files(folder);
    for (const MeshedBody& body : bodies) {
      files.write(body.name + ".msh", body.msh);
      files.write(body.name + ".vtu", result::BodyVtu(body.refined).text());
    }
    files.commit();
    std::cout << input.title << "\n\n"
              << table(bodies) << "\nmeshes: " << folder.string()
              << " (.msh: coarse, as accepted by [wheel] mesh and [rail] mesh; .vtu: refined)\n";
  }
}

}  // namespace

void add_mesh(CLI::App& program, Call& call) {
  const auto request = std::make_shared<CaseRequest>(call);
  CLI::App* mesh = program.add_subcommand(
      "mesh", "write the finite-element meshes of a case and print their quality");
  mesh->add_option("case", request->case_file, "case file (.toml)")->required();
  mesh->add_option(
      "-o,--output", request->directory,
      "folder for wheel.msh, rail.msh, wheel.vtu, rail.vtu, with profiles left_1_1_wheel.msh and "
      "so on for each patch (default: results/<name of the case file>_mesh)");
  add_set_option(*mesh, request->changes);
  mesh->footer("example: rollfem mesh cases/thesis_a.toml");
  mesh->callback([request] { app::mesh(*request); });
}

}  // namespace rollfem::app

// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `stress`: stress and displacement below the surface from stored results.
#include "app/frame/commands.hpp"
#include "app/frame/screen.hpp"
#include "contact/base/errors.hpp"
#include "models/stress/stored_stress.hpp"
#include "postprocess/files/files_together.hpp"

#include <filesystem>
#include <iostream>

namespace fs = std::filesystem;

namespace rollfem::app {
namespace {

struct StressCommand : modelling::StressRequest {
  std::string directory;  ///< empty: <result folder>_stress
  bool json = false;      ///< print stress.json; files are then written only into `directory`
  bool figures = true;
};

/// results/thesis_a_stress for results/thesis_a/results.h5.
fs::path output_folder(const fs::path& results, const StressCommand& request) {
  if (!request.directory.empty()) return request.directory;
  std::error_code error;
  const fs::path parent = results.has_parent_path() ? results.parent_path() : ".";
  const fs::path folder = fs::weakly_canonical(fs::absolute(parent), error);
  return parent / ".." / (folder.filename().string() + "_stress");
}

/// Removes page and figures of an earlier call, because this call may not redraw them.
void remove_figures(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder / "stress.json", error)) return;
  fs::remove(folder / "stress.html", error);
  for (fs::directory_iterator entry(folder / "figures", error), end; !error && entry != end;
       entry.increment(error))
    for (const char* ours : {"depth_", "line_", "surface_", "plane_", "shakedown_map"})
      if (entry->path().extension() == ".svg" &&
          entry->path().filename().string().rfind(ours, 0) == 0)
        fs::remove(entry->path(), error);
}

void stress(const StressCommand& request, Call& call) {
  std::vector<std::string> warnings;
  const postprocess::StressReport report = modelling::stored_stress(request, call.models, warnings);
  if (request.json) {
    warn(warnings);
    print_result(stress_json(report));
    if (request.directory.empty()) return;
    warnings.clear();
  }
  const fs::path folder = output_folder(report.source, request).lexically_normal();
  postprocess::FilesTogether files(folder);
  files.write("stress.csv", stress_csv(report));
  files.write("stress.json", stress_json(report));
  remove_figures(folder);
  files.commit();
  warn(warnings);
  const bool drawn = request.figures && draw(call, folder / "stress.json",
                                             "stresses are written, but figures were not drawn");
  std::cout << stress_table(report) << "\nstresses: " << folder.string()
            << " (stress.csv, stress.json" << (drawn ? ", stress.html, figures" : "") << ")\n";
}

}  // namespace

void add_stress(CLI::App& program, Call& call) {
  const auto request = std::make_shared<StressCommand>();
  CLI::App* stress = program.add_subcommand(
      "stress",
      "stress and displacement at points, on lines and on planes from stored results, without "
      "solving again; largest stresses; shakedown map");
  stress->add_option("result", request->result, "result folder of rollfem run, or its results.h5")
      ->required();
  stress
      ->add_option("-m,--model", request->models,
                   "models of the result, separated by commas; default: " +
                       contact::listed(call.models.names(&contact::ModelInfo::has_stress)) +
                       ", if present")
      ->delimiter(',')
      ->allow_extra_args(false);
  stress->add_option("--patch", request->patch,
                     "with profiles: SIDE,POSITION,PATCH, e.g. left,1,1; default: the first");
  stress
      ->add_option("--point", request->points,
                   "load points, counted from 1, separated by commas; default: the last")
      ->delimiter(',')
      ->allow_extra_args(false);
  stress
      ->add_option("--creepage", request->creepages,
                   "load points with these longitudinal creepages, separated by commas")
      ->delimiter(',')
      ->allow_extra_args(false);
  stress->add_option(
      "--places", request->places,
      "TOML file with [[subsurface.point]], .line, .plane and .surface, as in a case file");
  stress->add_flag("--depth-profile", request->depth_profile,
                   "add vertical lines below the centre of the patch and below the most loaded "
                   "element; the default when no points are requested");
  stress->add_option("--depth", request->depth,
                     "depth of these lines in mm; default: three times the smaller semi-axis");
  stress->add_option("--yield-shear-stress", request->yield_shear_stress,
                     "shear yield stress k in MPa, for the shakedown map");
  stress->add_option("--yield-strength", request->yield_strength,
                     "yield strength in MPa, instead of k (k = strength / sqrt(3))");
  stress->add_option("-o,--output", request->directory,
                     "folder for stress.csv, stress.json and figures; default: the name of the "
                     "result folder with _stress");
  add_json_flag(*stress, request->json);
  stress->add_flag_callback(
      "--no-figures", [request] { request->figures = false; }, "write the tables only");
  stress->footer(
      "example: rollfem stress results/thesis_a --yield-strength 520 --places places.toml\n"
      "x along rolling, y lateral, z into the wheel: z > 0 in the wheel, z < 0 in the rail.");
  stress->callback([request, &call] { app::stress(*request, call); });
}

}  // namespace rollfem::app

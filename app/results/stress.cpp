// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/results/stress.hpp"

#include "app/frame/screen.hpp"
#include "models/program/provenance.hpp"
#include "models/stress/stored_stress.hpp"
#include "postprocess/files/files_together.hpp"
#include "postprocess/write/output.hpp"

#include <filesystem>
#include <iostream>

namespace fs = std::filesystem;

namespace rollfem::app {
namespace {

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

}  // namespace

void stress(const StressCommand& request, const contact::ModelRegistry& models, bool& undrawn) {
  std::vector<std::string> warnings;
  const postprocess::StressReport report = modelling::stored_stress(request, models, warnings);
  if (request.json) {
    for (const std::string& warning : warnings) std::cerr << "warning: " << warning << '\n';
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
  std::string problem;
  if (request.figures)
    problem = postprocess::make_report((folder / "stress.json").string(),
                                       modelling::script_directory().string());
  for (const std::string& warning : warnings) std::cerr << "warning: " << warning << '\n';
  if (!problem.empty())
    std::cerr << "warning: stresses are written, but figures were not drawn: " << problem << '\n';
  undrawn = !problem.empty();
  if (!request.quiet)
    std::cout << stress_table(report) << "\nstresses: " << folder.string()
              << " (stress.csv, stress.json"
              << (request.figures && problem.empty() ? ", stress.html, figures" : "") << ")\n";
}

}  // namespace rollfem::app

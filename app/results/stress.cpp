// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/results/stress.hpp"

#include "app/results/stress_choice.hpp"
#include "app/results/stress_places.hpp"
#include "contact/base/errors.hpp"
#include "contact/result/stress_measures.hpp"
#include "halfspace/stress/stress_maxima.hpp"
#include "models/program/provenance.hpp"
#include "postprocess/files/files_together.hpp"
#include "postprocess/read/results_reader.hpp"
#include "postprocess/stress/stress_report.hpp"
#include "postprocess/write/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <utility>

namespace fs = std::filesystem;

namespace rollfem::app {
namespace {

using contact::InputError;
using contact::ModelResult;
using contact::PointResult;
using postprocess::ResultsFile;
using postprocess::StoredModel;
using postprocess::StressOfModel;
using postprocess::StressSet;

/// Largest values at the nodes. Values between nodes are not larger: each measure is a convex
/// function of the stress, and the interpolated stress is a mean of the nodal stresses.
std::vector<contact::StressMaximum> largest_at_nodes(const ModelResult& model, std::size_t point) {
  std::vector<contact::StressMaximum> maxima;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const contact::BodyField body = model.body_at(point, b);
    for (const auto& found : postprocess::largest_stresses(body.name, body.points, body.stress))
      maxima.push_back(found);
  }
  return maxima;
}

/// Adds largest values found at the requested places but missed by the search, which skips depths
/// below one element and so misses some where elements are long. Ignores places nearer to the
/// surface than `least`, but not on it.
void add_largest_of_sets(const std::vector<StressSet>& sets, double least,
                         std::vector<contact::StressMaximum>& maxima) {
  for (const StressSet& set : sets)
    for (const auto& found : postprocess::largest_stresses(
             set.field.request.wheel ? "wheel" : "rail", set.field.points, set.field.stress, least))
      for (contact::StressMaximum& maximum : maxima)
        if (maximum.measure == found.measure && maximum.body == found.body &&
            found.value > maximum.value)
          maximum = found;
}

StressOfModel stress_of(const contact::Case& input, ModelResult model, std::size_t number,
                        const std::vector<NamedRequest>& asked, const StressRequest& request,
                        const contact::ModelRegistry& models) {
  const PointResult& point = model.points[number];
  std::vector<NamedRequest> requests = asked;
  if (request.depth_profile || asked.empty()) {
    const auto profiles = depth_profiles(model, number, request);
    requests.insert(requests.begin(), profiles.begin(), profiles.end());
  }
  StressOfModel found;
  found.point = number;
  const contact::ModelInfo* info = models.find(model.name);
  const bool bodies = in_bodies(model.name, models);
  if (info != nullptr && info->corrects_stress) {
    found.sets = hybrid_sets(input, model, number, requests, found.maxima);
    found.result = std::move(model);
    return found;
  }
  found.sets =
      bodies ? body_sets(model, number, requests) : halfspace_sets(input, model, number, requests);
  found.maxima = point.stress_maxima;
  if (found.maxima.empty())
    found.maxima = bodies ? largest_at_nodes(model, number)
                          : halfspace::stress_maxima(input, model.grid, point);
  const double element = std::max(model.grid.dx, model.grid.dy);
  add_largest_of_sets(found.sets, bodies ? 0.0 : 0.5 * element, found.maxima);
  found.result = std::move(model);
  return found;
}

/// Output folder: results/thesis_a_stress for results/thesis_a.
fs::path output_folder(const ResultsFile& file, const StressRequest& request) {
  if (!request.directory.empty()) return request.directory;
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(file.directory()), error);
  return fs::path(file.directory()) / ".." / (folder.filename().string() + "_stress");
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

void stress(const StressRequest& request, const contact::ModelRegistry& models) {
  const std::vector<NamedRequest> asked = named_requests(request);
  postprocess::StressReport report;
  report.yield_shear_stress = yield_shear_stress(request);

  const ResultsFile file(request.result);
  if (!file.sealed())
    std::cerr << "warning: " << file.path()
              << " has no checksum (written by an earlier version or another program), so damage "
                 "may go unnoticed; do: if in doubt, run the case again\n";
  report.source = file.path();
  report.title = file.input().title;
  report.point_named = !request.points.empty() || !request.creepages.empty();
  std::vector<std::string> left_out;
  for (const StoredModel& stored : chosen_models(file, request, models)) {
    const ModelResult whole = file.read(stored);
    for (const std::size_t point : chosen_points(whole, request)) {
      try {
        check_stored(stored, whole.points[point], point, request, models);
      } catch (const InputError& error) {
        if (left_out.empty() || left_out.back() != error.what())
          left_out.emplace_back(error.what());
        continue;
      }
      ModelResult model = whole;
      if (in_bodies(stored.name, models)) file.read_bodies(stored, point, model);
      report.models.push_back(
          stress_of(file.input(), std::move(model), point, asked, request, models));
    }
  }
  if (report.models.empty()) throw InputError(left_out.front());

  const fs::path folder = output_folder(file, request).lexically_normal();
  postprocess::FilesTogether files(folder);
  files.write("stress.csv", stress_csv(report));
  files.write("stress.json", stress_json(report));
  remove_figures(folder);
  files.commit();
  std::string problem;
  if (request.figures)
    problem = postprocess::make_report((folder / "stress.json").string(),
                                       modelling::script_directory().string());
  for (const std::string& why : left_out) std::cerr << "warning: left out: " << why << '\n';
  if (!problem.empty())
    std::cerr << "warning: stresses are written, but figures were not drawn: " << problem << '\n';
  if (!request.quiet)
    std::cout << stress_table(report) << "\nstresses: " << folder.string()
              << " (stress.csv, stress.json"
              << (request.figures && problem.empty() ? ", stress.html, figures" : "") << ")\n";
}

}  // namespace rollfem::app

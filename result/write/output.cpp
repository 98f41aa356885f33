// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/write/output.hpp"

#include "base/threads.hpp"
#include "case/reading/case_reader.hpp"
#include "result/files/result_folder.hpp"
#include "result/write/csv.hpp"
#include "result/write/vtu.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace rollfem::result {
namespace {

/// Files that are independent of each other: compressing them takes long.
using Jobs = std::vector<std::function<void()>>;

/// Writes the contact surface of every load point that stores it, their series, and the last one
/// under a separate name.
void write_contact(ResultFolder& folder, const contact::ModelResult& model,
                   const contact::OutputOptions& wanted, Jobs& jobs) {
  const std::string stem = "fields/" + model.key() + "_contact";
  const std::vector<double> all = series_times(model.points);
  std::vector<double> times;
  std::vector<std::vector<std::string>> files;
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < model.points.size(); ++k) {
    if (model.points[k].fields.traction.n.size() == 0) continue;
    if (!wanted.keeps_grid(k, model.points.size())) continue;
    files.push_back({fmt::format("{}_contact_{:04}.vtu", model.key(), k)});
    times.push_back(all[k]);
    kept.push_back(k);
  }
  if (kept.empty()) return;
  for (const std::size_t k : kept)
    jobs.emplace_back([&folder, &model, stem, k, last = kept.back()] {
      const std::string content = contact_vtu(model.grid, model.points[k]);
      folder.write(fmt::format("{}_{:04}.vtu", stem, k), content);
      if (k == last) folder.write(stem + ".vtu", content);
    });
  folder.write(stem + ".pvd", series_pvd(times, files));
}

/// The same for wheel and rail of every load point that stores them.
void write_body_files(ResultFolder& folder, const contact::ModelResult& model, Jobs& jobs) {
  const std::vector<std::size_t> kept = model.points_with_bodies();
  if (kept.empty()) return;
  std::vector<std::vector<std::string>> files(kept.size());
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const std::string stem = model.key() + "_" + model.bodies[b].name;
    for (std::size_t k = 0; k < kept.size(); ++k)
      files[k].push_back(fmt::format("{}_{:04}.vtu", stem, kept[k]));
    jobs.emplace_back([&folder, &model, kept, b, stem = "fields/" + stem] {
      const BodyVtu body(model.bodies[b]);
      for (const std::size_t k : kept) {
        const std::string content = body.text(&model.points[k].bodies[b]);
        folder.write(fmt::format("{}_{:04}.vtu", stem, k), content);
        if (k == kept.back()) folder.write(stem + ".vtu", content);
      }
    });
  }
  const std::vector<double> all = series_times(model.points);
  std::vector<double> times;
  for (const std::size_t k : kept) times.push_back(all[k]);
  folder.write("fields/" + model.key() + "_bodies.pvd", series_pvd(times, files));
}

}  // namespace

void write_results(const std::string& directory, const RunRecord& run) {
  check_record(run);
  ResultFolder folder(directory);
  const auto asks = [&](const char* path) {
    const auto& paths = run.input.output.paths;
    return std::count(paths.begin(), paths.end(), path) > 0;
  };
  folder.write("case.toml", contact::text_in_folder(run.input, directory));
  folder.write("summary.json", summary_json(run));
  const std::pair<const char*, std::string> tables[] = {
      {"creep_curve.csv", creep_curve_csv(run)},
      {"path_x.csv", asks("x") ? path_csv(run, Path::x) : ""},
      {"path_y.csv", asks("y") ? path_csv(run, Path::y) : ""},
      {"subsurface.csv", subsurface_csv(run)},
      {"contacts.csv", contacts_csv(run)},
      {"wheelset.csv", wheelset_csv(run)},
      {"wheelset_rigid.csv", run.rigid_row.empty() ? "" : rigid_wheelset_csv(run.rigid_row)},
      {"patches.csv", patches_csv(run)},
      {"pass_work.csv", pass_work_csv(run)}};
  for (const auto& [name, text] : tables)
    if (!text.empty()) folder.write(name, text);
  Jobs jobs{[&] { folder.write("results.h5", results_hdf5(run)); }};
  if (run.input.output.fields)
    for (const contact::ModelResult& model : run.models) {
      write_contact(folder, model, run.input.output, jobs);
      write_body_files(folder, model, jobs);
    }
  contact::for_each_index(jobs.size(), [&](std::size_t k) { jobs[k](); });
  folder.commit();
}

}  // namespace rollfem::result

#include "postprocess/output.hpp"

#include "postprocess/csv.hpp"
#include "postprocess/record_check.hpp"
#include "postprocess/result_folder.hpp"
#include "postprocess/results_hdf5.hpp"
#include "postprocess/summary_json.hpp"
#include "postprocess/vtu.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace rollfem::postprocess {
namespace {

/// The surface of every load point, the series of them, and the last one under a name of its own.
void write_contact(ResultFolder& folder, const contact::ModelResult& model) {
  const std::string stem = model.key() + "_contact";
  std::vector<std::string> files;
  for (std::size_t k = 0; k < model.points.size(); ++k) {
    if (model.points[k].fields.traction.n.size() == 0) return;
    files.push_back(fmt::format("{}_{:04}.vtu", stem, k));
    const std::string content = contact_vtu(model.grid, model.points[k]);
    folder.write("fields/" + files.back(), content);
    if (k + 1 == model.points.size()) folder.write("fields/" + stem + ".vtu", content);
  }
  if (!files.empty())
    folder.write("fields/" + stem + ".pvd", series_pvd(series_times(model.points), files));
}

void write_fields(ResultFolder& folder, const contact::ModelResult& model) {
  for (const contact::BodyField& body : model.bodies)
    folder.write("fields/" + model.key() + "_" + body.name + ".vtu", body_vtu(body));
  write_contact(folder, model);
}

}  // namespace

void write_results(const std::string& directory, const RunRecord& run) {
  check_record(run);
  ResultFolder folder(directory);
  folder.write("case.toml", run.input.text);
  folder.write("summary.json", summary_json(run));
  folder.write("creep_curve.csv", creep_curve_csv(run));
  const auto& paths = run.input.output.paths;
  if (std::count(paths.begin(), paths.end(), "x"))
    folder.write("path_x.csv", path_csv(run, Path::x));
  if (std::count(paths.begin(), paths.end(), "y"))
    folder.write("path_y.csv", path_csv(run, Path::y));
  const std::string below = subsurface_csv(run);
  if (!below.empty()) folder.write("subsurface.csv", below);
  const std::string contacts = contacts_csv(run);
  if (!contacts.empty()) folder.write("contacts.csv", contacts);
  if (run.input.output.fields)
    for (const contact::ModelResult& model : run.models) write_fields(folder, model);
  folder.write("results.h5", results_hdf5(run));
  folder.commit();
}

}  // namespace rollfem::postprocess

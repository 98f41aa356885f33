// SPDX-License-Identifier: LGPL-2.1-or-later
// Stresses as the files that their command writes, and writing and drawing.
#include "bindings/python/caller.hpp"
#include "models/registry.hpp"
#include "models/stress/stored_stress.hpp"
#include "postprocess/files/files_together.hpp"
#include "postprocess/write/output.hpp"

#include <map>
#include <pybind11/stl.h>

namespace rollfem::python {

namespace {

/// What a command writes: contents of files by their names, the text it prints, its warnings.
struct Files {
  std::map<std::string, std::string> contents;
  std::string text;
  std::vector<std::string> warnings;
};

/// (contents by file name, text for the terminal, warnings)
py::tuple tuple_of(const Files& files) {
  return py::make_tuple(files.contents, files.text, files.warnings);
}

py::tuple stress_of(const modelling::StressRequest& request) {
  return tuple_of(without_gil(py::none(), [&](const Progress&) {
    Files found;
    const postprocess::StressReport report =
        modelling::stored_stress(request, known_models(), found.warnings);
    found.contents = {{"stress.csv", postprocess::stress_csv(report)},
                      {"stress.json", postprocess::stress_json(report)}};
    found.text = postprocess::stress_table(report);
    return found;
  }));
}

/// Files of one folder, whole or not at all; those of other commands stay.
void write_files(const std::string& folder, const std::map<std::string, std::string>& contents) {
  postprocess::write_together(folder, contents);
}

/// Figures and page of what rollfem has written; why they were not drawn, empty where they were.
std::string draw(const std::string& path) {
  const FreeGil free;
  return postprocess::make_report(path, figures_directory());
}

}  // namespace

const contact::ModelRegistry& known_models() {
  static const contact::ModelRegistry models = modelling::built_in_models();
  return models;
}

void define_commands(py::module_& module) {
  module.def("stress",
             [](const std::string& result, const std::vector<std::string>& models,
                const std::string& patch, const std::vector<int>& points, const std::string& places,
                bool depth_profile, std::optional<double> depth,
                std::optional<double> yield_shear_stress, std::optional<double> yield_strength) {
               return stress_of({result,
                                 models,
                                 patch,
                                 points,
                                 {},
                                 places,
                                 depth_profile,
                                 depth,
                                 yield_shear_stress,
                                 yield_strength});
             });
  module.def("write_files", &write_files);
  module.def("draw", &draw);
}

}  // namespace rollfem::python

// SPDX-License-Identifier: LGPL-2.1-or-later
// Writing and drawing.
#include "bindings/python/caller.hpp"
#include "models/registry.hpp"
#include "result/files/files_together.hpp"
#include "result/write/output.hpp"

#include <map>
#include <pybind11/stl.h>

namespace rollfem::python {

namespace {

/// Files of one folder, whole or not at all; those of other commands stay.
void write_files(const std::string& folder, const std::map<std::string, std::string>& contents) {
  result::write_together(folder, contents);
}

/// Figures and page of what rollfem has written; why they were not drawn, empty where they were.
std::string draw(const std::string& path) {
  const FreeGil free;
  return result::make_report(path, figures_directory());
}

}  // namespace

const contact::ModelRegistry& known_models() {
  static const contact::ModelRegistry models = modelling::built_in_models();
  return models;
}

void define_commands(py::module_& module) {
  module.def("write_files", &write_files);
  module.def("draw", &draw);
}

}  // namespace rollfem::python

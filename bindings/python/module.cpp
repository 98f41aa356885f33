// SPDX-License-Identifier: LGPL-2.1-or-later
// rollfem._core: the C++ base of the Python package rollfem/. Cases and results are opaque here;
// solving lets other Python threads run and checks for Ctrl-C at every iteration.
#include "base/pi.hpp"
#include "base/threads.hpp"
#include "bindings/python/caller.hpp"
#include "case/checks/case_checks.hpp"
#include "case/checks/plausibility.hpp"
#include "case/keys/case_keys.hpp"
#include "case/reading/case_reader.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "modelling/registry.hpp"
#include "profiles/profiles.hpp"
#include "result/files/files_together.hpp"
#include "result/write/output.hpp"
#include "result/write/report.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>
#include <pybind11/stl.h>
#include <tuple>

namespace rollfem::python {

namespace {

/// `go_on`: models that have no result are listed instead of ending the call.
Solved solved(const Case& input, const std::vector<std::string>& models, py::object callback,
              bool go_on) {
  std::vector<Missing> missing;
  const auto result = without_gil(std::move(callback), [&](const Progress& progress) {
    return std::make_shared<Result>(solve(input, models, progress, go_on ? &missing : nullptr));
  });
  return {result, missing_rows(missing)};
}

/// Python's Ctrl-C handler may not interrupt here; writing is complete or does not happen in any
/// case.
std::string written(const Result& result, const std::string& folder, bool report) {
  const FreeGil free;
  return write(folder, result, report);
}

/// Figures and page of what rollfem has written; why they were not drawn, empty where they were.
std::string draw(const std::string& path) {
  const FreeGil free;
  return result::make_report(path, figures_directory());
}

/// A case of values whose text is made: its lines and columns say nothing.
Case case_of_values(const std::string& text, const std::string& name) {
  try {
    return parse_case(text, name);
  } catch (const contact::CaseError& error) {
    throw InputError({name}, error.text());
  }
}

/// All [(section, key, unit)] of the case file.
std::vector<std::tuple<std::string, std::string, std::string>> keys() {
  static_cast<void>(known_models());  // whose keys are among them
  std::vector<std::tuple<std::string, std::string, std::string>> found;
  for (const contact::Key& key : contact::case_keys())
    found.emplace_back(key.section, key.name, key.unit);
  return found;
}

/// Sets an exception of the Python package.
void raise(const char* kind, const std::string& text) {
  PyErr_SetString(py::module_::import("rollfem.errors").attr(kind).ptr(), text.c_str());
}

void define_progress(py::module_& module) {
  py::class_<ProgressEvent>(module, "Progress", R"(Progress report of a running model.)")
      .def_readonly("model", &ProgressEvent::model)
      .def_readonly("stage", &ProgressEvent::stage, "'normal', 'rolling', 'shift', 'mesh', ...")
      .def_readwrite("point", &ProgressEvent::point,
                     "load point (of a sweep: combination), counted from 1; 0: none")
      .def_readwrite("points", &ProgressEvent::points, "number of load points or combinations")
      .def_property_readonly(
          "fraction",
          [](const ProgressEvent& event) {
            const int done = event.finished ? event.point : std::max(event.point - 1, 0);
            return event.points > 0 ? static_cast<double>(done) / event.points : 0.0;
          },
          "of `points` that this stage has done, 0 to 1")
      .def_readonly("creepage", &ProgressEvent::creepage,
                    "longitudinal creepage of the point; None without frictional rolling")
      .def_readonly("iteration", &ProgressEvent::iteration)
      .def_readonly("residual", &ProgressEvent::residual, "relative residual; 0: none")
      .def_readonly("finished", &ProgressEvent::finished, "whether the stage has finished")
      .def_readonly("note", &ProgressEvent::note)
      .def("__repr__", [](const ProgressEvent& event) {
        return "<rollfem.Progress " + event.model + ": " + event.stage + ", point " +
               std::to_string(event.point) + " of " + std::to_string(event.points) +
               ", iteration " + std::to_string(event.iteration) + ">";
      });
}

void define_cases(py::module_& module) {
  py::class_<Case>(module, "Case")
      .def_readonly("file", &Case::file)
      .def_readonly("title", &Case::title)
      .def_readonly("text", &Case::text)
      .def_readonly("models", &Case::models)
      .def_property_readonly("load_points",
                             [](const Case& input) { return input.rolling.creepages.size(); })
      .def_readonly("friction_coefficient", &Case::friction_coefficient)
      .def_property_readonly("has_profiles", &Case::has_profiles)
      .def_property_readonly(
          "has_meshes",
          [](const Case& input) { return !input.wheel.mesh.empty() || !input.rail.mesh.empty(); })
      .def("curvatures_of_ellipse",
           [](const Case& input, double a, double b, double force) {
             const double pressure = 1.5 * force / (contact::pi * a * b);
             const auto [along, across] = halfspace::hertz_curvatures(
                 {a, b, pressure, 0.0, force},
                 contact::combine(input.wheel.material, input.rail.material).contact_modulus);
             return std::pair(along, across);
           })
      .def_property_readonly("doubts",
                             [](const Case& input) { return contact::implausible_values(input); })
      .def_property_readonly("neglected", &profiles::neglected_in_files)
      .def("describe", [](const Case& input) { return rollfem::describe(input); })
      .def("text_in_folder", &contact::text_in_folder);
}

}  // namespace

const contact::ModelRegistry& known_models() {
  static const contact::ModelRegistry models = modelling::built_in_models();
  return models;
}

}  // namespace rollfem::python

PYBIND11_MODULE(_core, module) {
  using namespace rollfem;
  namespace py = pybind11;
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const contact::OutputError& error) {
      python::raise("OutputError", error.what());
    } catch (const FileError& error) {
      python::raise("FileError", error.what());
    } catch (const InputError& error) {
      python::raise("InputError", error.what());
    } catch (const SolveError& error) {
      python::raise("SolveError", error.what());
    } catch (const std::filesystem::filesystem_error& error) {
      python::raise("FileError", error.path1().string() + ": " + error.code().message());
    }
  });
  python::define_progress(module);
  // Signatures of what takes and gives cases and results name these classes.
  python::define_cases(module);
  python::define_results(module);
  python::define_tables(module);
  python::define_computations(module);
  python::define_stress(module);
  python::define_track(module);
  module.def("read_case", [](const std::string& file, const std::vector<std::string>& changes) {
    return contact::read_case(file, modelling::known_names(python::known_models()), changes);
  });
  module.def("parse_case", &parse_case);
  module.def("case_of_values", &python::case_of_values);
  // Files of one folder, whole or not at all; those of other commands stay.
  module.def("write_files", [](const std::string& folder, const py::dict& contents) {
    result::write_together(folder, contents.cast<std::map<std::string, std::string>>());
  });
  module.def("draw", &python::draw);
  module.def("models", &models);
  module.attr("most_threads") = contact::most_threads;
  module.def("threads", [] { return python::wanted_threads().load(); });
  module.def("use_threads", [](int number) { python::wanted_threads() = number; });
  module.def("solve", &python::solved);
  module.def("write", &python::written);
  module.def("keys", &python::keys);
  module.def("figures_directory", &figures_directory);
  module.def("version", &version);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// rollfem._core: the C++ base of the Python package rollfem/. Cases and results are opaque here;
// solving lets other Python threads run and checks for Ctrl-C at every iteration.
#include "contact/case/checks/plausibility.hpp"
#include "contact/case/keys/case_keys.hpp"
#include "python/bindings.hpp"
#include "python/blas_threads.hpp"

#include <optional>
#include <pybind11/stl.h>

namespace rollfem::python {

namespace {

/// A Python exception on its way through the solver. Not derived from std::exception, which a model
/// might handle as its own.
struct Ended {};

/// Calls back into Python and stores an exception raised there.
class Caller {
 public:
  explicit Caller(py::object callback) : callback_(std::move(callback)) {}

  Progress progress() {
    return [this](const ProgressEvent& event) { tell(event); };
  }
  /// Rethrows the stored exception. Requires the GIL.
  void rethrow() {
    if (raised_) throw std::move(*raised_);
  }

 private:
  void tell(const ProgressEvent& event) {
    const py::gil_scoped_acquire gil;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!callback_.is_none()) callback_(event);
    } catch (py::error_already_set& error) {
      raised_.emplace(std::move(error));
      throw Ended();
    }
  }

  py::object callback_;
  std::optional<py::error_already_set> raised_;
};

Shared solved(const Case& input, const std::vector<std::string>& models, py::object callback) {
  Caller caller(std::move(callback));
  try {
    const py::gil_scoped_release free;
    const OneBlasThread one_thread;
    return std::make_shared<const Result>(solve(input, models, caller.progress()));
  } catch (const Ended&) {
    caller.rethrow();
    throw;
  }
}

/// Python's Ctrl-C handler may not interrupt here; writing is complete or does not happen in any
/// case.
std::string written(const Shared& result, const std::string& folder, bool report) {
  const py::gil_scoped_release free;
  return write(folder, *result, report);
}

/// All [(section, key)] of the case file.
std::vector<std::pair<std::string, std::string>> keys() {
  std::vector<std::pair<std::string, std::string>> found;
  for (const contact::Key& key : contact::case_keys()) found.emplace_back(key.section, key.name);
  return found;
}

void define_progress(py::module_& module) {
  py::class_<ProgressEvent>(module, "Progress", R"(Progress report of a running model.)")
      .def_readonly("model", &ProgressEvent::model)
      .def_readonly("stage", &ProgressEvent::stage, "'normal', 'rolling', 'shift', 'mesh', ...")
      .def_readonly("point", &ProgressEvent::point, "load point, counted from 1; 0: none")
      .def_readonly("points", &ProgressEvent::points, "number of load points")
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

}  // namespace

}  // namespace rollfem::python

PYBIND11_MODULE(_core, module) {
  using namespace rollfem;
  namespace py = pybind11;
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
  py::register_exception<SolveError>(module, "SolveError", PyExc_RuntimeError);
  python::define_progress(module);
  python::define_tables(module);
  py::class_<Case>(module, "Case")
      .def_readonly("title", &Case::title)
      .def_readonly("text", &Case::text)
      .def_readonly("models", &Case::models)
      .def_property_readonly("load_points",
                             [](const Case& input) { return input.rolling.creepages.size(); })
      .def_property_readonly("doubts",
                             [](const Case& input) { return contact::implausible_values(input); })
      .def("describe", [](const Case& input) { return describe(input); });
  py::class_<Result, std::shared_ptr<Result>>(module, "Result");
  module.def("read_case", &read_case);
  module.def("parse_case", &parse_case);
  module.def("models", &models);
  module.def("solve", [](const Case& input, const std::vector<std::string>& names,
                         const py::object& callback) {
    return std::const_pointer_cast<Result>(python::solved(input, names, callback));
  });
  module.def("models_of",
             [](const std::shared_ptr<Result>& result) { return python::models_of(result); });
  module.def("write", [](const std::shared_ptr<Result>& result, const std::string& folder,
                         bool report) { return python::written(result, folder, report); });
  module.def("stress_measures", &python::stress_measures);
  module.def("keys", &python::keys);
  module.def("quantities", &python::quantities);
  module.def("fields", &python::fields);
  module.def("figures_directory", &figures_directory);
  module.def("version", &version);
}

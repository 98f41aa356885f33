// Results as Python dictionaries with descriptions of their quantities. Arrays are views of the
// result itself: nothing is copied, and each keeps the whole result alive.
#pragma once

#include "rollfem/rollfem.hpp"
#include <memory>
#include <pybind11/pybind11.h>

namespace rollfem::python {

using Shared = std::shared_ptr<const Result>;

/// One dictionary for each model and patch, in the order of the run.
pybind11::list models_of(const Shared& result);

/// {name: (title, symbol, unit, meaning, percent_of)}, in the order of the files.
pybind11::dict quantities();
/// {name: (unit, description, sign)}
pybind11::dict fields();

}  // namespace rollfem::python

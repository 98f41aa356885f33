// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of the module rollfem._core beside module.cpp.
#pragma once

#include "base/members.hpp"
#include "contact/solve/model.hpp"

#include "rollfem/rollfem.hpp"
#include <functional>
#include <memory>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace rollfem::python {

namespace py = pybind11;
using Shared = std::shared_ptr<Result>;

/// (model, reason, failed) of models without a result.
using MissingRows = std::vector<std::tuple<std::string, std::string, bool>>;
using Solved = std::pair<Shared, MissingRows>;
inline MissingRows missing_rows(const std::vector<Missing>& missing) {
  MissingRows rows;
  for (const Missing& one : missing) rows.emplace_back(one.model, one.reason, one.failed);
  return rows;
}

/// The models of the package.
const contact::ModelRegistry& known_models();

/// A struct of results by the names that files have for its members.
template <class Whole>
py::dict dict_of(const Whole& whole) {
  py::dict found;
  contact::for_members<Whole>([&](const auto& each) {
    if constexpr (std::decay_t<decltype(each)>::kept != contact::Kept::within)
      found[each.name] = std::invoke(each.part, whole);
  });
  return found;
}

/// The class Result, its contents, and what they are.
void define_results(py::module_& module);
/// The class CreepTable, on which rollfem.Table is made, and `fill_table`.
void define_tables(py::module_& module);
/// The classes Scene, Level, Computing and Computation, by which studies and comparisons solve.
void define_computations(py::module_& module);
/// Stresses below the surface of stored load points.
void define_stress(py::module_& module);
/// Profiles, contact points and the rigid wheelset.
void define_track(py::module_& module);

}  // namespace rollfem::python

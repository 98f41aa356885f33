// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `compare`: several models on one or several cases, side by side.
#pragma once

#include "app/frame/command_frame.hpp"

#include <string>
#include <vector>

namespace rollfem::app {

/// Without `models` those that the registry has for it; without `directory` results/compare_<case>,
/// results/compare for several. `resume` keeps the cases that are done and takes up one that is
/// not.
struct CompareRequest : ComputingRequest {
  std::vector<std::string> case_files;
  std::string reference;  ///< model; empty: the first that solves the elastic problem
};

/// Every case in DIR/<case> as `run` leaves it, then DIR/compare.json, .csv and .html. A model that
/// cannot take a case is left out with a sentence; one that fails does not stop the others. Throws
/// contact::InputError before anything is computed, contact::SolveError at the end when a model
/// failed.
void compare(const CompareRequest& request, const contact::ModelRegistry& models);

}  // namespace rollfem::app

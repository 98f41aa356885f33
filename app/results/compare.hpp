// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `compare`: several models on one or several cases, side by side.
#pragma once

#include "app/frame/command_frame.hpp"

#include <string>
#include <vector>

namespace rollfem::app {

/// Empty `models`: the registry's default for `compare`. Empty `directory`: results/compare_<case>,
/// or results/compare for several cases. `resume` keeps finished cases and continues an unfinished
/// one.
struct CompareRequest : ComputingRequest {
  std::vector<std::string> case_files;
  std::string reference;  ///< model; empty: the first that solves the elastic problem
};

/// Writes every case to DIR/<case> as `run` does, then DIR/compare.json, .csv and .html. A model
/// that cannot take a case is left out with a sentence; one that fails does not stop the others.
/// Throws contact::InputError before the computation, contact::SolveError at the end if a model
/// failed.
void compare(const CompareRequest& request, const contact::ModelRegistry& models);

}  // namespace rollfem::app

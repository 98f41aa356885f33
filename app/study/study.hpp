// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `study`: one case on successively finer grids, cells, degrees or domains; with
// profiles every patch, at loads and creepages determined once and then fixed.
#pragma once

#include "app/frame/command_frame.hpp"

#include <string>
#include <vector>

namespace rollfem::app {

/// Empty `models`: the first one that solves the elastic problem; "all": every model that can take
/// the case. Empty `directory`: results/<case>_study. `resume` continues from finished levels.
struct StudyRequest : ComputingRequest {
  std::string case_file;
  std::vector<std::string> vary;  ///< grid, cell, degree, domain; empty: the model's default
  bool together = false;          ///< refine all of `vary` at once, not one at a time
  int levels = 0;                 ///< 0: the model's default
  /// exact, finest, extrapolated, QUANTITY=VALUE, with several patches PLACE.QUANTITY=VALUE
  std::vector<std::string> references;
};

/// Writes DIR/study.json, .csv and .html; with profiles every patch has its series. Throws
/// contact::InputError before the computation, contact::SolveError at the end if a level failed.
void study(StudyRequest request, const contact::ModelRegistry& models);

}  // namespace rollfem::app

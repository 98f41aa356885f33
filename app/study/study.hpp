// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `study`: one case on successively finer grids, cells, degrees or domains; with
// profiles every patch, at loads and creepages determined once and then fixed.
#pragma once

#include "app/frame/command_frame.hpp"

#include <string>
#include <vector>

namespace rollfem::app {

/// Without `models` the first that solves the elastic problem; "all": every model that can take the
/// case. Without `directory` results/<case>_study. `resume` takes up finished levels.
struct StudyRequest : ComputingRequest {
  std::string case_file;
  std::vector<std::string> vary;  ///< grid, cell, degree, domain; empty: as the model has it
  bool together = false;          ///< refine all of `vary` at once, not one at a time
  int levels = 0;                 ///< 0: as the model has it
  /// exact, finest, extrapolated, QUANTITY=VALUE, with several patches PLACE.QUANTITY=VALUE
  std::vector<std::string> references;
};

/// Writes DIR/study.json, .csv and .html; with profiles every patch has its series. Throws
/// contact::InputError before anything is computed, contact::SolveError at the end when a level
/// failed.
void study(StudyRequest request, const contact::ModelRegistry& models);

}  // namespace rollfem::app

// SPDX-License-Identifier: LGPL-2.1-or-later
// Solves the models of a case on all its scenes.
#pragma once

#include "contact/base/progress.hpp"
#include "contact/base/share.hpp"
#include "contact/case/case.hpp"
#include "contact/result/result.hpp"
#include "contact/solve/model.hpp"
#include "models/choice/budget.hpp"
#include "models/fem/fem_library.hpp"
#include "models/solving/case_scenes.hpp"
#include "postprocess/write/output.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rollfem::modelling {

/// A model that has no result for a case, and why in one sentence.
struct Missing {
  std::string model;
  std::string reason;
  bool failed = false;  ///< it tried; else the case is none that it can take
};

struct Solved {
  std::vector<contact::ModelResult> results;
  std::vector<postprocess::PlacedPair> pairs;
  std::vector<Missing> missing;  ///< with Solving::go_on
};

struct Solving {
  const contact::ModelRegistry* models = nullptr;
  const ParallelSession* session = nullptr;  ///< where a model is parallel
  /// Starts the session before a parallel model is run that may not have been needed. May be empty.
  std::function<void()> need_session = {};
  Placed placed;  ///< wheels that stand on their rails already; null: `solve` places them
  contact::Progress progress;
  contact::Checkpoint* checkpoint = nullptr;  ///< may be null
  Budget* budget = nullptr;  ///< what a choice may spend where no accuracy is named; null: its own
  contact::Share share;      ///< positions of the wheelset that this call solves
  bool first = true;  ///< the first process of a parallel run: it alone runs what is not parallel
  bool together = true;  ///< this is the only process
  /// A model that cannot take the case, or fails, is listed and the others go on; otherwise what it
  /// throws ends the call.
  bool go_on = false;
};

/// Runs the models of `input.models` on every scene of the case. Throws contact::InputError and
/// contact::SolveError, which name model and patch. A failure of one of several processes is
/// thrown whatever `go_on` says: the others may be inside a collective call.
Solved solve(const contact::Case& input, const Solving& how);

/// One model on one scene, or on a case with radii: what `solve` does for each. A parallel model is
/// called by every process, the others on the first alone. Throws as `solve` does.
contact::ModelResult solve_scene(const std::string& model, const contact::Scene& scene,
                                 const std::vector<std::string>& notes, const Solving& how);

}  // namespace rollfem::modelling

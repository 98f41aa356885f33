// SPDX-License-Identifier: LGPL-2.1-or-later
// Solves the models of a case on all its scenes.
#pragma once

#include "base/progress.hpp"
#include "contact/solve/model.hpp"
#include "contact/solve/run_part.hpp"
#include "modelling/fem/fem_library.hpp"
#include "modelling/solving/case_scenes.hpp"
#include "result/result.hpp"
#include "result/write/output.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rollfem::modelling {

struct Solving {
  const contact::ModelRegistry* models = nullptr;
  const fem::Entry* session = nullptr;  ///< set if a model is parallel
  /// Starts the session before the first run of a parallel model that is only possibly needed. May
  /// be empty.
  std::function<void()> need_session = {};
  Placed placed;  ///< wheels in position; null: `solve` places them
  contact::Progress progress;
  contact::Checkpoint* checkpoint = nullptr;  ///< may be null
  contact::RunPart own;                       ///< positions of the wheelset that this call solves
  bool first = true;     ///< first process of a parallel run, which alone runs serial models
  bool together = true;  ///< this is the only process
  /// True: a model that cannot take the case, or fails, is listed as missing. False: its exception
  /// ends the call.
  bool go_on = false;
};

/// Runs the models of `record.input` on every scene of the case and adds their results, and what
/// there is to say of them, to the record. Returns the models without a result (Solving::go_on).
/// Throws contact::InputError and contact::SolveError, which name model and patch. With several
/// processes a failure is thrown even with `go_on`, because the others may be inside a collective
/// call.
std::vector<result::MissingModel> solve(result::RunRecord& record, const Solving& how);

/// Runs one model on a scene as it is, with progress and checkpoint of its patch. Throws
/// contact::InputError and contact::SolveError.
contact::ModelResult run_model(const std::string& name, const contact::Scene& scene,
                               const Solving& how);

/// One model, not auto, on one scene or on a case with radii: one step of `solve`. Every process
/// calls it for a parallel model, only the first for the others. Throws as `solve` does.
contact::ModelResult solve_scene(const std::string& model, const contact::Scene& scene,
                                 const std::vector<contact::Note>& notes, const Solving& how);

}  // namespace rollfem::modelling

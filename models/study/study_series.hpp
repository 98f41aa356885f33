// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs a refinement study: every model of every place on its levels.
#pragma once

#include "contact/case/case.hpp"
#include "models/solving/case_scenes.hpp"
#include "models/solving/solving.hpp"
#include "models/study/study_wishes.hpp"
#include "postprocess/files/checkpoint_folder.hpp"
#include "postprocess/study/study.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rollfem::modelling {

/// State shared by all series of a study.
struct StudyRun {
  Solving how;
  postprocess::CheckpointFolder* kept = nullptr;  ///< of the first process; may be null
  std::vector<std::string> notes;                 ///< of the scenes
  std::function<void(const std::string&)> say;
};

/// The record before any level is solved. Throws contact::InputError for references that the case
/// does not have.
postprocess::StudyRecord begin_study(const StudyWishes& wishes, const contact::Case& input,
                                     const Scenes& scenes, postprocess::Provenance provenance);

/// Adds the series of `models` (models_of). Levels that fail are part of their series. Every
/// process of a parallel run calls it.
void solve_levels(const StudyWishes& wishes, const std::vector<std::string>& models,
                  const Scenes& scenes, const StudyRun& run, postprocess::StudyRecord& record);

/// Adds what `auto` would choose, and drops places without series. Returns the failures of all
/// series in one text; throws contact::SolveError when no level at all was solved.
std::string finish_study(const Scenes& scenes, const Solving& how,
                         postprocess::StudyRecord& record);

}  // namespace rollfem::modelling

// SPDX-License-Identifier: LGPL-2.1-or-later
// The request of a study: checked before anything is computed, and turned into models, levels and
// references.
#pragma once

#include "contact/case/case.hpp"
#include "contact/solve/model.hpp"
#include "models/solving/case_scenes.hpp"
#include "models/solving/solving.hpp"
#include "postprocess/files/checkpoint_folder.hpp"
#include "postprocess/study/study.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rollfem::modelling {

/// The levels of one model, coarsest first.
struct LevelPlan {
  postprocess::StudySeries series;  ///< without levels; `vary` is empty if nothing is refined
  std::vector<contact::RefinedInput> levels;
};

/// Without `models` the first that solves the elastic problem; "all": every model that can take the
/// case.
struct StudyWishes {
  std::vector<std::string> models;
  bool all() const { return models == std::vector<std::string>{"all"}; }
  std::vector<std::string> vary;  ///< grid, cell, degree, domain; empty: the model's default
  bool together = false;          ///< refine all of `vary` at once, not one at a time
  int levels = 0;                 ///< 0: the model's default
  /// exact, finest, extrapolated, QUANTITY=VALUE, with several patches PLACE.QUANTITY=VALUE
  std::vector<std::string> references;
};

/// Checks that need no case, and variations that its bodies do not allow. Throws
/// contact::InputError.
void check_wishes(const StudyWishes& wishes, const contact::Case& input,
                  const contact::ModelRegistry& known);

/// The models named in the call, unchecked; "all" means every model.
std::vector<std::string> named_models(const StudyWishes& wishes,
                                      const contact::ModelRegistry& known);

/// The models among these that accept every scene. Throws contact::InputError for a named model
/// that does not, and if no model can refine anything in --vary.
std::vector<std::string> models_of(const StudyWishes& wishes, const Scenes& scenes,
                                   const contact::ModelRegistry& known);

/// Sets rule and given values from --reference. Needs the places with their creepages and exact
/// values. Throws contact::InputError.
void read_references(const StudyWishes& wishes, postprocess::StudyRecord& record);

/// Words allowed in --vary.
std::vector<std::string> varied_words(const contact::ModelRegistry& models);

/// The models that can refine `word`.
std::vector<std::string> models_that_vary(const contact::ModelRegistry& models,
                                          const std::string& word);

/// Whether the model can refine `word`.
bool can_vary(const contact::ModelInfo& model, const std::string& word);

/// The plans of one model: one for each word in `vary` that it can refine, or a single one for all
/// of them if `together`. Empty `vary`: the model's default refinement. `levels` = 0: the default
/// number. A model with nothing to refine has one level. Throws contact::InputError if a starting
/// value is missing.
std::vector<LevelPlan> level_plans(const contact::ModelInput& input,
                                   const contact::ModelInfo& model,
                                   const std::vector<std::string>& vary, bool together, int levels);

// Runs a refinement study: every model of every place on its levels.

/// How the levels of a study are solved.
struct StudyRun {
  Solving how;
  postprocess::CheckpointFolder* kept = nullptr;  ///< of the first process; may be null
  std::function<void(const std::string&)> say = [](const std::string&) {};
};

class Study {
 public:
  /// Places the wheels of a case with profiles. Throws contact::InputError for wishes that the case
  /// does not meet.
  Study(StudyWishes wishes, const contact::Case& input, const contact::ModelRegistry& known,
        postprocess::Provenance provenance, const contact::Progress& progress);

  /// Adds the series of all models. Levels that fail are part of their series. Every process of a
  /// parallel run calls it.
  void solve(const StudyRun& run);
  /// Drops places without series. Returns the failures of all series in one text; throws
  /// contact::SolveError when no level at all was solved.
  std::string finish();

  const postprocess::StudyRecord& record() const { return record_; }

 private:
  StudyWishes wishes_;
  Scenes scenes_;
  std::vector<std::string> models_;
  postprocess::StudyRecord record_;
};

}  // namespace rollfem::modelling

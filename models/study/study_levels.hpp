// SPDX-License-Identifier: LGPL-2.1-or-later
// The levels of a refinement study as cases.
#pragma once

#include "contact/solve/model.hpp"

#include <string>
#include <vector>

namespace rollfem::modelling {

/// The levels of one model, coarsest first.
struct LevelPlan {
  std::string model;
  std::string vary;       ///< "grid", "grid and domain"; empty: one level, nothing to refine
  std::string parameter;  ///< heading of the labels, "elements across"
  double ratio = 0.0;     ///< ratio of cell sizes between levels; 0: not meaningful
  std::vector<contact::RefinedInput> levels;
};

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

}  // namespace rollfem::modelling

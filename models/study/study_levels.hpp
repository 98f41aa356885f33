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
  double ratio = 0.0;     ///< of cells from level to level; 0: has no meaning
  std::vector<contact::RefinedInput> levels;
};

/// What the models can refine, as --vary takes it.
std::vector<std::string> varied_words(const contact::ModelRegistry& models);

/// The models that have it.
std::vector<std::string> models_that_vary(const contact::ModelRegistry& models,
                                          const std::string& word);

/// Whether the model has it.
bool can_vary(const contact::ModelInfo& model, const std::string& word);

/// The plans of one model: one for each of `vary` that the model has, or one for all of them
/// `together`; without `vary` what refines it naturally. `levels` = 0: as many as that has. A model
/// without anything of that to refine has one level. Throws contact::InputError when a starting
/// value is missing.
std::vector<LevelPlan> level_plans(const contact::ModelInput& input,
                                   const contact::ModelInfo& model,
                                   const std::vector<std::string>& vary, bool together, int levels);

}  // namespace rollfem::modelling

// What a refinement study varies: the cases of its levels.
#pragma once

#include "contact/case/case.hpp"

#include <string>
#include <vector>

namespace rollfem::app {

/// The levels of one model, coarsest first.
struct LevelPlan {
  std::string model;
  std::string vary;       ///< "grid", "grid and domain"; empty: one level, nothing to refine
  std::string parameter;  ///< heading of the labels, "elements across"
  double ratio = 0.0;     ///< of cells from level to level; 0: has no meaning
  struct Level {
    std::string label;
    double parameter = 0.0;
    contact::Case input;
  };
  std::vector<Level> levels;
};

/// What can be refined: grid, cell, degree, domain.
const std::vector<std::string>& varied_words();

/// The plans of one model: one for each of `vary` that the model has, or one for all of them
/// `together`; without `vary` what refines it naturally. `levels` = 0: 5 grids, 3 cells or domains.
/// A model without anything of that to refine has one level. Throws contact::InputError when a
/// starting value is missing.
std::vector<LevelPlan> level_plans(const contact::Case& input, const std::string& model,
                                   const std::vector<std::string>& vary, bool together, int levels);

/// Whether the model has it.
bool can_vary(const std::string& model, const std::string& word);

}  // namespace rollfem::app

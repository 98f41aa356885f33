// SPDX-License-Identifier: LGPL-2.1-or-later
// What a study is asked for, checked before anything is computed and turned into models and
// references.
#pragma once

#include "contact/case/case.hpp"
#include "contact/solve/model.hpp"
#include "models/solving/case_scenes.hpp"
#include "postprocess/study/study.hpp"

#include <string>
#include <vector>

namespace rollfem::modelling {

/// Without `models` the first that solves the elastic problem; "all": every model that can take the
/// case.
struct StudyWishes {
  std::vector<std::string> models;
  std::vector<std::string> vary;  ///< grid, cell, degree, domain; empty: as the model has it
  bool together = false;          ///< refine all of `vary` at once, not one at a time
  int levels = 0;                 ///< 0: as the model has it
  /// exact, finest, extrapolated, QUANTITY=VALUE, with several patches PLACE.QUANTITY=VALUE
  std::vector<std::string> references;
};

/// What the case need not be known for, and what its bodies cannot vary. Throws
/// contact::InputError.
void check_wishes(const StudyWishes& wishes, const contact::Case& input,
                  const contact::ModelRegistry& known);

/// The models that the call names, before any is looked at: "all" are all there are.
std::vector<std::string> named_models(const StudyWishes& wishes,
                                      const contact::ModelRegistry& known);

/// Of these those that can take every scene. Throws contact::InputError for one that was named and
/// cannot, and when none has something of --vary.
std::vector<std::string> models_of(const StudyWishes& wishes, const Scenes& scenes,
                                   const contact::ModelRegistry& known);

/// Sets rule and given values from --reference. The places are there, with their creepages and
/// exact values. Throws contact::InputError.
void read_references(const StudyWishes& wishes, postprocess::StudyRecord& record);

}  // namespace rollfem::modelling

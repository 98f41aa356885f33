// SPDX-License-Identifier: LGPL-2.1-or-later
// The models of the program and their descriptions.
#pragma once

#include "contact/case/case_reader.hpp"
#include "contact/solve/model.hpp"

#include <string>
#include <vector>

namespace rollfem::modelling {

/// Those of halfspace/ and fem. In a build without finite elements fem is known, but not built.
contact::ModelRegistry built_in_models();

/// What case files may name.
contact::ModelWords model_words(const contact::ModelRegistry& models);

/// Every name once, in order. Throws contact::InputError for one that is no model.
std::vector<std::string> checked_names(const contact::ModelRegistry& models,
                                       const std::vector<std::string>& names,
                                       const std::string& option);

/// Of `names` those that this build has.
std::vector<std::string> built_of(const contact::ModelRegistry& models,
                                  std::vector<std::string> names);

/// Throws contact::InputError for a model that this build does not have. `asked_by`: what named
/// them, "--model" or "a.toml: models".
void check_built(const contact::ModelRegistry& models, const std::vector<std::string>& names,
                 const std::string& asked_by);

/// Whether one of them runs on all processes.
bool any_parallel(const contact::ModelRegistry& models, const std::vector<std::string>& names);

/// docs/models.md: every model with its sentence, and what each can take.
std::string models_markdown(const contact::ModelRegistry& models);

}  // namespace rollfem::modelling

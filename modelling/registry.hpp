// SPDX-License-Identifier: LGPL-2.1-or-later
// The models of the program and their descriptions.
#pragma once

#include "case/reading/case_reader.hpp"
#include "contact/solve/model.hpp"

#include <string>
#include <vector>

namespace rollfem::modelling {

/// All models. A build without finite elements knows fem, but cannot run it.
contact::ModelRegistry built_in_models();

/// Names allowed in case files.
contact::KnownNames known_names(const contact::ModelRegistry& models);

/// Removes duplicates, keeping the order. Throws contact::InputError for an unknown name.
std::vector<std::string> checked_names(const contact::ModelRegistry& models,
                                       const std::vector<std::string>& names,
                                       const std::string& option);

/// The subset of `names` that this build has.
std::vector<std::string> built_of(const contact::ModelRegistry& models,
                                  std::vector<std::string> names);

/// Throws contact::InputError for a model that this build does not have. `asked_by`: the option or
/// key that names them, "--model" or "a.toml: models".
void check_built(const contact::ModelRegistry& models, const std::vector<std::string>& names,
                 const std::string& asked_by);

/// Whether at least one of them runs on all processes.
bool any_parallel(const contact::ModelRegistry& models, const std::vector<std::string>& names);

/// Text of docs/models.md: every model with its description and its abilities.
std::string models_markdown(const contact::ModelRegistry& models);

}  // namespace rollfem::modelling

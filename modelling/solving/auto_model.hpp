// SPDX-License-Identifier: LGPL-2.1-or-later
// `auto`: the cheapest of half-space, hybrid and finite elements that meets the accuracy of the
// case, for all its contacts (choice/choice.hpp).
#pragma once

#include "contact/solve/model.hpp"
#include "modelling/choice/choice.hpp"
#include "modelling/solving/solving.hpp"

#include <string>
#include <vector>

namespace rollfem::modelling {

/// Entry of the registry: a description without a solver of its own.
contact::ModelInfo auto_model();

/// Whether one of the names is auto.
bool any_choice(const contact::ModelRegistry& models, const std::vector<std::string>& names);

/// Throws contact::InputError if auto is combined with other models; `asked_by`: "--model".
void check_alone(const contact::ModelRegistry& models, const std::vector<std::string>& names,
                 const std::string& asked_by);

/// For commands that compare models: throws contact::InputError for auto.
void refuse_choice(const contact::ModelRegistry& models, const std::vector<std::string>& names,
                   const std::string& command);

/// The results of the chosen model, in the order of the scenes, with its name. Collective in a
/// parallel run.
Chosen solve_by_choice(const std::vector<contact::Scene>& scenes, const Solving& how);

}  // namespace rollfem::modelling

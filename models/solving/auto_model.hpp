// SPDX-License-Identifier: LGPL-2.1-or-later
// `auto`: the cheapest of half-space, hybrid and finite elements that meets the accuracy of the
// case (choice/choice.hpp).
#pragma once

#include "contact/solve/model.hpp"
#include "models/choice/choice.hpp"
#include "models/solving/solving.hpp"

#include <string>
#include <vector>

namespace rollfem::modelling {

/// For the registry: known and told of, but without a run of its own.
contact::ModelInfo auto_model();

/// Whether one of them is auto.
bool any_choice(const contact::ModelRegistry& models, const std::vector<std::string>& names);

/// auto stands alone. Throws contact::InputError; `asked_by`: "--model".
void check_alone(const contact::ModelRegistry& models, const std::vector<std::string>& names,
                 const std::string& asked_by);

/// For commands that have models laid beside each other: throws contact::InputError for auto.
void refuse_choice(const contact::ModelRegistry& models, const std::vector<std::string>& names,
                   const std::string& command);

/// What is expected of the models of a scene before anything is solved. Throws contact::InputError
/// and contact::SolveError where it has no patch.
std::vector<Forecast> forecasts_of(const contact::Scene& scene,
                                   const contact::ModelRegistry& models);

/// The accuracy that auto looks for: of the scene, or 1 %.
double accuracy_of(const contact::AccuracyRequest& asked);

/// What choices for these scenes may spend where they name no accuracy.
Budget budget_of(const std::vector<contact::Scene>& scenes, const contact::ModelRegistry& models);

/// The result of the model taken, with its name. Every process of a parallel run calls it.
contact::ModelResult solve_by_choice(const contact::Scene& scene, const contact::Progress& progress,
                                     contact::Checkpoint* checkpoint, const Solving& how);

}  // namespace rollfem::modelling

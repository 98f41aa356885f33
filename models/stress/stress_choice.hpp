// SPDX-License-Identifier: LGPL-2.1-or-later
// Selects the models and load points of a stored result for `rollfem stress`.
#pragma once

#include "contact/solve/model.hpp"
#include "models/stress/stress_request.hpp"
#include "postprocess/read/results_reader.hpp"

#include <cstddef>
#include <vector>

namespace rollfem::modelling {

/// The requested models of the requested patch. Defaults: the models with stress, the first patch.
/// Throws contact::InputError.
std::vector<postprocess::StoredModel> chosen_models(const postprocess::ResultsFile& file,
                                                    const StressRequest& request,
                                                    const contact::ModelRegistry& models);

/// Numbers of the requested load points without duplicates; default: the last. Throws
/// contact::InputError.
std::vector<std::size_t> chosen_points(const contact::ModelResult& model,
                                       const StressRequest& request);

/// Whether stresses come from the stored bodies of wheel and rail instead of sums over the contact
/// elements.
bool in_bodies(const std::string& model, const contact::ModelRegistry& models);

/// Throws contact::InputError if the stored data do not give stresses at load point `number`.
void check_stored(const postprocess::StoredModel& stored, const contact::PointResult& point,
                  std::size_t number, const StressRequest& request,
                  const contact::ModelRegistry& models);

}  // namespace rollfem::modelling

// SPDX-License-Identifier: LGPL-2.1-or-later
// Selects the models and load points of a stored result for `rollfem stress`.
#pragma once

#include "contact/solve/model.hpp"
#include "models/stress/stress_request.hpp"
#include "postprocess/read/results_reader.hpp"

#include <cstddef>
#include <vector>

namespace rollfem::modelling {

/// The models that are asked for, of the patch that is asked for; else those with stress, of the
/// first patch, whichever are there. Throws contact::InputError.
std::vector<postprocess::StoredModel> chosen_models(const postprocess::ResultsFile& file,
                                                    const StressRequest& request,
                                                    const contact::ModelRegistry& models);

/// Numbers of the load points that are asked for, each once, else of the last. Throws
/// contact::InputError.
std::vector<std::size_t> chosen_points(const contact::ModelResult& model,
                                       const StressRequest& request);

/// Whether stresses are those of wheel and rail as stored, not the sum over the contact elements.
bool in_bodies(const std::string& model, const contact::ModelRegistry& models);

/// Throws contact::InputError where stresses at load point `number` cannot be had from what is
/// stored.
void check_stored(const postprocess::StoredModel& stored, const contact::PointResult& point,
                  std::size_t number, const StressRequest& request,
                  const contact::ModelRegistry& models);

}  // namespace rollfem::modelling

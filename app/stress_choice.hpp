// Which models of a stored result, and which of their load points, `rollfem stress` looks at.
#pragma once

#include "app/stress_request.hpp"
#include "postprocess/read/results_reader.hpp"

#include <cstddef>
#include <vector>

namespace rollfem::app {

/// The models that are asked for, of the patch that is asked for; else half-space and finite
/// elements of the first patch, whichever are there. Throws contact::InputError.
std::vector<postprocess::StoredModel> chosen_models(const postprocess::ResultsFile& file,
                                                    const StressRequest& request);

/// Number of the load point that is asked for, else of the last. Throws contact::InputError.
std::size_t chosen_point(const contact::ModelResult& model, const StressRequest& request);

/// Throws contact::InputError where stresses at load point `number` cannot be had from what is
/// stored.
void check_stored(const postprocess::StoredModel& stored, const contact::PointResult& point,
                  std::size_t number, const StressRequest& request);

}  // namespace rollfem::app

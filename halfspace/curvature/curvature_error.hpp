// SPDX-License-Identifier: LGPL-2.1-or-later
// The model error of the half-space, estimated by solving the contact once more on bodies with
// their true curvature (curved_compliance.hpp), across rolling on their common surface.
#pragma once

#include "contact/base/progress.hpp"
#include "contact/solve/contact_run.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::halfspace {

/// Per load point: quantity -> how much the bodies of true curvature would change its value, in its
/// unit, with the sign. Both solutions are on the same grid, so that what that is off by is in
/// neither. To the first order of patch size over radius, and of what is of second order the common
/// surface alone.
using ModelErrors = std::vector<std::map<std::string, double>>;

/// `plain`: the half-space's solution of the scene on a grid of some 32 across or more; finer ones
/// change little. None where the patch reaches the border of that grid. Throws
/// contact::InputError where bodies are not known, contact::SolveError.
std::optional<ModelErrors> model_errors(const contact::Scene& scene,
                                        const contact::LevelResult& plain,
                                        const contact::Progress& progress);

/// On coarser grids elements that come into contact at the leading edge move forces by as much as
/// curved bodies do.
inline constexpr int elements_of_model_error = 32;

/// Sets PointResult::model_error (absolute values) and the source of the half-space's result of the
/// scene, from solutions on so many elements across; where there are none the source says why.
/// Throws contact::InputError where bodies are not known.
void add_model_error(const contact::Scene& scene, const contact::Progress& progress,
                     contact::ModelResult& result, int elements_across = elements_of_model_error);

}  // namespace rollfem::halfspace

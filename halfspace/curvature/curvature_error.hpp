// SPDX-License-Identifier: LGPL-2.1-or-later
// The model error of the half-space, estimated by solving the contact once more on bodies with
// their true curvature (curved_compliance.hpp), across rolling on their common surface.
#pragma once

#include "base/progress.hpp"
#include "contact/solve/contact_run.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::halfspace {

/// Per load point: quantity -> signed change of its value by the true curvature of the bodies, in
/// its unit. Both solutions use the same grid, so that its error cancels. First order in patch size
/// over radius; of the second-order effects only the common surface is included.
using ModelErrors = std::vector<std::map<std::string, double>>;

/// `plain`: the half-space's solution of the scene on a grid of about 32 elements across or more;
/// finer ones change little. Empty if the patch reaches the border of that grid. Throws
/// contact::InputError for unknown bodies, and contact::SolveError.
std::optional<ModelErrors> model_errors(const contact::Scene& scene,
                                        const contact::LevelResult& plain,
                                        const contact::Progress& progress);

/// On coarser grids, elements that come into contact at the leading edge change forces as much as
/// curved bodies do.
inline constexpr int elements_of_model_error = 32;

/// Sets PointResult::model_error (absolute values) and the source of the half-space's result of the
/// scene, from solutions with `elements_across`; without a solution the source states the reason.
/// Throws contact::InputError for unknown bodies.
void add_model_error(const contact::Scene& scene, const contact::Progress& progress,
                     contact::ModelResult& result, int elements_across = elements_of_model_error);

}  // namespace rollfem::halfspace

// SPDX-License-Identifier: LGPL-2.1-or-later
// One resolution of the model "halfspace": the contact run on the half-space's elasticity. Every
// level starts from the next coarser one, which provides the first guess and the error estimate.
#pragma once

#include "contact/base/checkpoint.hpp"
#include "contact/solve/contact_run.hpp"
#include "halfspace/model/halfspace_model.hpp"

#include <memory>
#include <string>

namespace rollfem::halfspace {

/// Solutions for a prescribed force must be more accurate than the search.
inline constexpr contact::ContactAccuracy accuracy_of_force_search{1e-8, {1e-7, 600, 5, true}};

/// Solves all load points with cells of dx by dy, on a larger grid when the patch reaches its
/// border. `area`: of this scene. `coarser` may be null. `stage_prefix` precedes the stage names of
/// the progress events. Load points are restored from the `checkpoint` (may be null) and stored
/// there.
contact::LevelResult solve_level(const contact::Scene& scene, const PatchSearch& area, double dx,
                                 double dy, const contact::LevelResult* coarser,
                                 const std::string& stage_prefix, const contact::Progress& progress,
                                 contact::Checkpoint* checkpoint = nullptr,
                                 const GridElasticity& elasticity = {});

}  // namespace rollfem::halfspace

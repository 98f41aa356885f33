// SPDX-License-Identifier: LGPL-2.1-or-later
// The model "hybrid": the half-space on a fine contact grid plus a smooth correction for wheel and
// rail as curved, finite bodies. It lies between the half-space without this correction and finite
// elements, whose contact grid is as coarse as their cells.
#pragma once

#include "base/checkpoint.hpp"
#include "contact/solve/model.hpp"
#include "hybrid/smooth_map.hpp"

#include <functional>

namespace rollfem::hybrid {

/// Finds the correction for the bodies of a scene by finite elements
/// (hybrid/correction/smooth_parts.hpp).
using FindParts = std::function<SmoothParts(const contact::Scene&, const contact::Progress&)>;

/// As run_halfspace, on the common surface of the bodies. Error estimates cover the discretisation
/// error of the grid and a tenth of the change by the correction. Throws contact::InputError where
/// a body is not given by its surface, and contact::SolveError.
contact::ModelResult run_hybrid(const contact::Scene& scene, const contact::Progress& progress,
                                contact::Checkpoint* checkpoint, const FindParts& find);

}  // namespace rollfem::hybrid

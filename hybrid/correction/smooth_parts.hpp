// SPDX-License-Identifier: LGPL-2.1-or-later
// The corrections of wheel and rail to their half-spaces by finite elements: each body minus its
// flattened twin on the same mesh (flat_twin.hpp), under tractions of a few polynomials over the
// patch. Discretisation errors cancel up to the curvature, so that coarse cells suffice. The twin
// of a true section or of a user's mesh is a box with the same cells under the patch.
#pragma once

#include "base/progress.hpp"
#include "hybrid/smooth_map.hpp"
#include "scene/scene.hpp"

namespace rollfem::hybrid {

/// Correction of the scene's correction scene (hybrid/correction_scene.hpp), computed by
/// the calling process alone because the bodies are small. Throws contact::InputError for scenes
/// without bodies (undeformed distances) and for stresses in bodies other than boxes, and
/// contact::SolveError.
SmoothParts find_smooth_parts(const contact::Scene& scene, const contact::Progress& progress);

/// The same with the given number of cells in the smaller semi-axis of the patch instead of three.
SmoothParts find_smooth_parts_with(double cells_in_semi_axis, const contact::Scene& scene,
                                   const contact::Progress& progress);

}  // namespace rollfem::hybrid

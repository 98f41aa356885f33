// SPDX-License-Identifier: LGPL-2.1-or-later
// Kind of mesh of wheel and rail with true profiles, and extent of their gentle part beside the
// patch: needed by other modules before finite elements are chosen.
#pragma once

#include "scene/scene.hpp"

namespace rollfem::halfspace {

/// Whether the scene has a patch of true profiles and its bodies are the true sections of wheel and
/// rail according to [fem] mesh, not boxes under the surface.
bool has_true_sections(const contact::Scene& scene);

/// Least extent of a box to each side, in larger half sizes of the patch, regardless of the
/// steepness of the profile.
constexpr double least_box_reach = 2.5;

/// Extent of the profiles of elastic bodies to both sides of y = `middle` before they end or exceed
/// 56 degrees, mm; infinite without profiles.
double gentle_reach(const contact::Scene& scene, double middle);

/// Whether a profile becomes steep beside the patch within the least extent of a box.
bool is_steep(const contact::Scene& scene);

}  // namespace rollfem::halfspace

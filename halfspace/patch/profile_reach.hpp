// SPDX-License-Identifier: LGPL-2.1-or-later
// Extent of the gentle part of true profiles beside the patch: needed by other modules before
// finite elements are chosen.
#pragma once

#include "scene/scene.hpp"

namespace rollfem::halfspace {

/// Least extent of a box to each side, in larger half sizes of the patch, regardless of the
/// steepness of the profile.
constexpr double least_box_reach = 2.5;

/// Extent of the profiles of elastic bodies to both sides of y = `middle` before they end or exceed
/// 56 degrees, mm; infinite without profiles.
double gentle_reach(const contact::Scene& scene, double middle);

/// Whether a profile becomes steep beside the patch within the least extent of a box.
bool is_steep(const contact::Scene& scene);

}  // namespace rollfem::halfspace

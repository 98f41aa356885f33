// SPDX-License-Identifier: LGPL-2.1-or-later
// The scene for which the smooth parts of wheel and rail (smooth_map.hpp) are computed:
// the bodies of a scene under a rounded load. Scenes that differ little in load, or only in
// creepages, friction and grids, share it and hence the smooth parts.
#pragma once

#include "scene/scene.hpp"

#include <string>

namespace rollfem::hybrid {

/// The bodies of the scene with one load point: the next power of `correction_load_ratio` above the
/// largest load, so that all loads up to it share its smooth parts, and creepages that only tell
/// whether y = 0 is a symmetry plane. The largest load itself is used if the patch of that power
/// does not fit the bodies or their given extent, or is of another kind. A correction scene is its
/// own correction scene.
contact::Scene correction_scene(const contact::Scene& scene);

/// Ratio of loads from one correction scene to the next.
extern const double correction_load_ratio;

/// Everything that determines smooth parts, except the program version, as text: bodies, materials,
/// the box of the patch, the keys of [fem] that lay out bodies. Lengths to ten digits.
std::string correction_key(const contact::Scene& correction);

/// One-line description of the bodies, for lists.
std::string correction_words(const contact::Scene& correction);

}  // namespace rollfem::hybrid

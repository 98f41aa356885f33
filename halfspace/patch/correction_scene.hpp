// SPDX-License-Identifier: LGPL-2.1-or-later
// The scene for which the smooth parts of wheel and rail (elasticity/smooth_map.hpp) are computed:
// the bodies of a scene under a rounded load. Scenes that differ little in load, or only in
// creepages, friction and grids, share it and hence the smooth parts.
#pragma once

#include "contact/scene/scene.hpp"

#include <string>

namespace rollfem::halfspace {

/// The bodies of the scene with one load point: the next power of `correction_load_ratio` above
/// the largest load, so that all loads up to it can do with its smooth parts, and creepages that
/// say no more than whether y = 0 is a symmetry plane. Where the patch of that load does not fit
/// the bodies or a given extent of them, or is of another kind, the largest load itself. The scene
/// of a correction scene is itself.
contact::Scene correction_scene(const contact::Scene& scene);

/// Loads from one correction scene to the next.
extern const double correction_load_ratio;

/// Everything that smooth parts depend on but the program, as text: bodies, materials, the box of
/// the patch, the keys of [fem] that lay out bodies. Lengths to ten digits.
std::string correction_key(const contact::Scene& correction);

/// The bodies in a line, for lists.
std::string correction_words(const contact::Scene& correction);

// What a contact grid of half-spaces lies on: the plane of the patch or the common surface.

/// The scene as the contact grid of the model lies on it. Throws contact::InputError where the
/// common surface is asked for and not known.
contact::ChartedGeometry halfspace_geometry(const contact::Scene& scene);

}  // namespace rollfem::halfspace

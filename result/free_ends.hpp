// SPDX-License-Identifier: LGPL-2.1-or-later
// Ends of bodies inside a patch (ProfileSource::free_ends): the patch ends there, its pressure
// grows without bound on finer grids, and a half-space has material beside them, where the body has
// none.
#pragma once

#include "result/patch_size.hpp"
#include "result/result.hpp"
#include "scene/scene.hpp"

#include <vector>

namespace rollfem::contact {

/// Ends up to which a load point has pressure.
struct LoadedEnds {
  std::vector<FreeEnd> ends;
  double share = 0.0;  ///< of the load, within half the patch's length from these ends
};
LoadedEnds loaded_ends(const Scene& scene, const ContactGrid& grid, const PointResult& point);

/// Pressure, tractions and work of a pass of a point with loaded ends have no limit on finer grids.
void explain_singular_values(const Scene& scene, const ContactGrid& grid, PointResult& point);

/// Cuts the subelement patch size at the ends of the bodies. An end up to `beyond` mm outside the
/// patch is its border too: an element belongs to the body if its middle does, so the last one may
/// end half an element before or behind the body.
void cut_at_ends(const Scene& scene, PatchSize& size, double beyond = 0.0);

/// The middle of a patch of profiles, and its width between ends.
void place_patch(const Scene& scene, const ContactGrid& grid, PointResult& point);

}  // namespace rollfem::contact

// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks that a solved grid holds all of a contact: wheel and rail must not overlap beyond it, nor
// press on each other up to where another contact of the wheel begins.
#pragma once

#include "contact/result/result.hpp"
#include "halfspace/patch/patch_search.hpp"

#include <vector>

namespace rollfem::halfspace {

/// Elements kept free around the patch; second-order upwind looks two columns upstream.
inline constexpr int free_elements = 3;

/// The grid, with more rows where the bodies would overlap beyond it under one of the load points
/// of the scene, solved as `points`; `area`: the search that has found the patch. Throws
/// contact::SolveError where the patch is not this contact's alone.
contact::ContactGrid grid_of_all_patches(const contact::Scene& scene,
                                         const contact::ChartedGeometry& geometry,
                                         const PatchSearch& area, const contact::ContactGrid& grid,
                                         const std::vector<contact::PointResult>& points);

}  // namespace rollfem::halfspace

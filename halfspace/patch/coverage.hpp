// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks that a solved grid contains the whole contact: wheel and rail must not overlap beyond it,
// and pressure must not reach another contact of the wheel.
#pragma once

#include "halfspace/patch/patch_search.hpp"
#include "result/result.hpp"

#include <array>
#include <optional>
#include <vector>

namespace rollfem::halfspace {

/// Free elements around the patch; the second-order upwind difference uses two columns upstream.
inline constexpr int free_elements = 3;

/// Range of the grid's lateral coordinate, mm: first and last position beyond the grid where the
/// bodies would overlap under this load point, with each element of the patch as a point load on
/// the half-space. Empty for bodies without profiles; `area`: the search that found the patch.
std::optional<std::array<double, 2>> touched_beyond(const contact::Scene& scene,
                                                    const contact::ChartedGeometry& geometry,
                                                    const PatchSearch& area,
                                                    const contact::ContactGrid& grid,
                                                    const contact::PointResult& point,
                                                    const contact::NormalLoad& load);

/// The grid, extended by rows where the bodies would overlap beyond it under one of the scene's
/// load points, solved as `points`. Throws
/// contact::ConformalContact if another contact takes part in the patch.
contact::ContactGrid grid_of_all_patches(const contact::Scene& scene,
                                         const contact::ChartedGeometry& geometry,
                                         const PatchSearch& area, const contact::ContactGrid& grid,
                                         const std::vector<contact::PointResult>& points);

}  // namespace rollfem::halfspace

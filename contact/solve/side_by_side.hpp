// SPDX-License-Identifier: LGPL-2.1-or-later
// Load points of a creep curve on several threads. On half-spaces a steady load point starts from
// the coarser level and not from another load point, so each is the same as if solved alone.
#pragma once

#include "contact/solve/contact_run.hpp"

#include <optional>

namespace rollfem::contact {

/// Memory of a thread's elasticity and fields, as measured on half-spaces.
inline constexpr double bytes_per_element = 1300.0;

/// The same result as that of ContactRun::solve; none when a patch reaches the border of the grid.
/// Throws what the first load point throws that fails.
std::optional<LevelResult> solve_points(const Scene& scene, const ChartedGeometry& geometry,
                                        const RunOptions& options, const Progress& progress,
                                        PointStore* store, const ContactGrid& grid,
                                        const MakeElasticity& make);

}  // namespace rollfem::contact

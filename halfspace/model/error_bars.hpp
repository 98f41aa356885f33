// SPDX-License-Identifier: LGPL-2.1-or-later
// Error bars of the model halfspace: largest expected distance of each number of a load point from
// its value on an infinitely fine grid, from the changes between grids of h, 2h and 4h and from
// features of the solution. Their reliability: docs/accuracy.md, "Bars of the half-space".
#pragma once

#include "halfspace/model/wave_errors.hpp"

namespace rollfem::halfspace {

/// Fills `error_estimate` and `richardson` of load point k of the scene, solved on `grid`, from the
/// same load point on cells of twice and four times the size (null: missing), for every quantity
/// that is not prescribed. A creepage found for a force has a bar. `waves`: of the same load point;
/// null where elements follow the profiles.
void set_error_bars(const contact::Scene& scene, std::size_t k, const contact::ContactGrid& grid,
                    const contact::PointResult& coarse, const contact::PointResult* coarsest,
                    contact::PointResult& fine, const WaveErrors* waves = nullptr);

/// The same for the stresses at the requested points ("subsurface_stress", for the worst component
/// of all), and for the largest stresses ("max_von_mises_wheel"), except those that either grid has
/// marked as near the surface.
void set_stress_bars(const contact::ContactGrid& grid, const contact::PointResult& coarse,
                     const contact::PointResult* coarsest, contact::PointResult& fine);

/// Marks the largest stresses above this depth, mm, as NoBar::near_surface: those at the end of the
/// layer of one element length, which is excluded from the search and may contain larger ones.
void mark_near_surface(double depth, contact::PointResult& point);

}  // namespace rollfem::halfspace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Error bars of the model halfspace: how far each number of a load point may be from that of an
// infinitely fine grid, from the changes between grids of h, 2h and 4h and from the solution where
// the number is formed. Their reliability: docs/accuracy.md, "Bars of the half-space".
#pragma once

#include "contact/result/result.hpp"
#include "halfspace/model/wave_errors.hpp"

#include <cstddef>

namespace rollfem::halfspace {

/// Fills `error_estimate` and `richardson` of load point k of the scene, solved on `grid`, from the
/// same on cells of twice and four times the size (null: there is none): of every quantity that is
/// no given one. A creepage has a bar where it is found for a force. `waves`: of the same load
/// point; null where elements follow the profiles.
void set_error_bars(const contact::Scene& scene, std::size_t k, const contact::ContactGrid& grid,
                    const contact::PointResult& coarse, const contact::PointResult* coarsest,
                    contact::PointResult& fine, const WaveErrors* waves = nullptr);

/// The same of the stresses at the points that are asked for ("subsurface_stress", of the worst
/// component of all), and of the largest stresses ("max_von_mises_wheel") where they lie below the
/// layer next to the surface, as deep as an element is long, in which they are not looked for: in
/// that layer or at its end there may be larger ones, and they have no bar.
void set_stress_bars(const contact::ContactGrid& grid, const contact::PointResult& coarse,
                     const contact::PointResult* coarsest, contact::PointResult& fine);

}  // namespace rollfem::halfspace

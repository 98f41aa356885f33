// SPDX-License-Identifier: LGPL-2.1-or-later
// Largest stresses of wheel and rail as half-spaces, with their positions.
#pragma once

#include "halfspace/stress/subsurface.hpp"
#include "result/result.hpp"

#include <functional>
#include <vector>

namespace rollfem::halfspace {

/// Adds the difference between a body and its half-space to a state; may be empty.
using StateBeyond = std::function<void(Body, const SubsurfacePoint&, SubsurfaceState&)>;

/// Maxima of the measures in stress_measures.hpp for both bodies under the tractions of a solved
/// point: searched on layers of the contact grid's lattice from the surface to 1.5 times the
/// smaller semi-axis, below the surface also between the lattice points. On the surface, values are
/// at element centres; depths below one element are excluded because the steps of the tractions
/// dominate there.
std::vector<contact::StressMaximum> stress_maxima(const contact::Scene& scene,
                                                  const contact::ContactGrid& grid,
                                                  const contact::PointResult& point,
                                                  const StateBeyond& beyond = {});

}  // namespace rollfem::halfspace

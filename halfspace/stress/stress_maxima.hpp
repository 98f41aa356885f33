// SPDX-License-Identifier: LGPL-2.1-or-later
// Largest stresses of wheel and rail as half-spaces, with their places.
#pragma once

#include "contact/result/result.hpp"
#include "halfspace/stress/subsurface.hpp"

#include <functional>
#include <vector>

namespace rollfem::halfspace {

/// What a body has beyond the state of its half-space, added to it; may be empty.
using StateBeyond = std::function<void(Body, const SubsurfacePoint&, SubsurfaceState&)>;

/// Of both bodies under the tractions of a solved point, the measures of stress_measures.hpp:
/// looked for on layers of the contact grid's lattice from the surface to 1.5 times the smaller
/// semi-axis, then between the lattice points. At the surface the value is that at the middle of an
/// element; depths of less than an element are left out, where the steps of the traction show.
std::vector<contact::StressMaximum> stress_maxima(const contact::Scene& scene,
                                                  const contact::ContactGrid& grid,
                                                  const contact::PointResult& point,
                                                  const StateBeyond& beyond = {});

}  // namespace rollfem::halfspace

// SPDX-License-Identifier: LGPL-2.1-or-later
// A rail on springs without mass: it gives way until the springs carry the force of the wheel.
#pragma once

#include "track/motion/placed_scenes.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace rollfem::track {

/// To the right and down: mm of a rail besides its displacement in the case, N on it.
using RailVector = std::array<double, 2>;

/// A wheel at one position on its rail.
struct WheelOnRail {
  std::vector<PlacedScene> placed;
  std::vector<contact::Scene> balanced;  ///< as balanced_position gives them
};

/// The wheel of a case at this position (1, 2, ...) on a rail that has given way; `here`: case_at.
WheelOnRail on_moved_rail(const contact::Case& here, const SearchScene& search, int position,
                          const RailVector& moved);

/// Where the springs k d = F(d) + F_0 of Track::rail_stiffness hold the rail under the force F of
/// its wheel. Throws contact::SolveError when there is no such place within 100 mm.
RailVector settled_rail(const contact::Case& here, RailVector start,
                        const std::function<RailVector(const RailVector&)>& force);

/// The force on the rail by contacts of these normal and lateral forces, N.
void add_force_on_rail(const contact::ContactPlace& place, double normal, double lateral,
                       RailVector& force);

/// The wheel on the rail where it settles in steady rolling, with friction by the half-space with
/// 24 elements across.
WheelOnRail on_springs(const contact::Case& here, const SearchScene& search, int position,
                       RailVector& moved);

/// For the notes of a result.
std::string springs_text(const RailVector& moved);

}  // namespace rollfem::track

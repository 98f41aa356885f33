// SPDX-License-Identifier: LGPL-2.1-or-later
// Balance of one position of the wheelset: the loads of its patches and its rotation.
#pragma once

#include "track/motion/placed_scenes.hpp"

#include <vector>

namespace rollfem::track {

/// The loaded scenes of all wheels at one position; throws as balance().
std::vector<contact::Scene> balanced_position(const contact::Case& input,
                                              const std::vector<PlacedScene>& scenes);

}  // namespace rollfem::track

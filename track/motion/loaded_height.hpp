// SPDX-License-Identifier: LGPL-2.1-or-later
// The height of a wheel under its load. Contacts are found at first touch with the rail; from there
// the wheel sinks vertically, and distances of several patches in one plane change by microns in
// addition to the approach along the plane's normal (docs/track.md).
#pragma once

#include "track/motion/placed_scenes.hpp"

#include <vector>

namespace rollfem::track {

/// Moves the undeformed distances of one wheel's contacts at one position to the loaded height, for
/// contacts in which several humps overlap the rail; a single patch keeps the distances of first
/// touch. (For a single patch the lateral displacement, microns, is equivalent to a lateral shift
/// of that size.) The height comes from the half-space under the largest load, without friction.
void stand_under_load(const contact::Case& input, std::vector<PlacedScene>& wheel);

}  // namespace rollfem::track

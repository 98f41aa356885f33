// SPDX-License-Identifier: LGPL-2.1-or-later
// The height at which a wheel stands under its load. Contacts are found where it first touches the
// rail; from there it sinks vertically, and distances of several patches in one plane change by
// microns beside the approach along the plane's normal (docs/track.md).
#pragma once

#include "track/motion/placed_scenes.hpp"

#include <vector>

namespace rollfem::track {

/// Takes the distances of the contacts of one wheel at one position to that height, of those of
/// which several humps overlap the rail: a patch alone keeps the distances of first touch. (To it
/// the way sideways, microns, is that much of another lateral shift.) The height is that of the
/// half-space under the largest load, without friction.
void stand_under_load(const contact::Case& input, std::vector<PlacedScene>& wheel);

}  // namespace rollfem::track

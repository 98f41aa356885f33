// SPDX-License-Identifier: LGPL-2.1-or-later
// What the sharing of a wheel's load between contacts leaves out: a flange bends away from the rail
// under its load, which half-spaces and wedges do not (docs/theory.md#around-a-corner).
#pragma once

#include "case/case.hpp"
#include "result/note.hpp"
#include "scene/scene.hpp"

#include <vector>

namespace rollfem::track {

/// Normal forces of a wheel's contacts without friction, N.
struct BentShares {
  double bending = 0.0;  ///< mm, along the axle at the highest loaded place of the flange
  std::vector<double> stiff, bent;  ///< as half-spaces; with the bending
};

/// First load point. `scenes`: the contacts of one wheel that share a vertical force. A lateral
/// force F at a height H over the tread bends the flange at a height h by F h H/(E (18.4 mm)^3):
/// finite elements of the sections of S1002 and of a worn wheel, flanges some 30 mm thick, at 13 to
/// 28 mm (benchmarks/sections.py). The changes of the shares are within a third of those of the
/// sections. Empty where the bending is below a micrometre. Throws contact::SolveError.
BentShares shares_with_bending(const contact::Case& input,
                               const std::vector<contact::Scene>& scenes);

/// One note for each wheel whose shares bending changes by half a percent of the load or more.
std::vector<contact::Note> bending_notes(const contact::Case& input,
                                         const std::vector<contact::Scene>& scenes);

}  // namespace rollfem::track

// SPDX-License-Identifier: LGPL-2.1-or-later
// FASTSIM, Kalker's algorithm for the simplified theory on Hertz's ellipse (Kalker 1982, Vehicle
// System Dynamics 11, 1-13), and the model "fastsim".
#pragma once

#include "theories/brush.hpp"
#include "theories/elliptic_patch.hpp"

namespace rollfem::theories {

using contact::FastsimElements;
using contact::Flexibilities;
using FastsimOptions = contact::FastsimOptions;

/// FastsimElements::grid: those of a box of `count` over 2 a whose middles lie in the strip, with
/// the spin where CONTACT takes it.
StripElements grid_elements(const BrushStrip& strip, double semi_axis_x, int count);

/// Forces and areas of one load point of the case; the extra rigid slip of the case is included.
BrushTotals fastsim(const EllipticPatch& patch, const contact::Creepage& creepage,
                    const FastsimOptions& options = {});

/// The same with brushes of other flexibilities than the linear theory's.
BrushTotals fastsim(const EllipticPatch& patch, const contact::Creepage& creepage,
                    const BrushFlexibilities& flexibilities, const FastsimOptions& options);

/// The model "fastsim": forces by `options`, fields on the case's contact grid. The recorded
/// traction bound is that of the theory, whose parabola exceeds mu p_n by a third in the middle.
/// error_estimate is that of the resolution alone, not of the theory (10 to 15 % in the forces).
contact::ModelResult run_fastsim(const contact::Scene& scene, const contact::Progress& progress,
                                 const FastsimOptions& options = {});

}  // namespace rollfem::theories

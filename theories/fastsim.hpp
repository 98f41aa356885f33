// SPDX-License-Identifier: LGPL-2.1-or-later
// FASTSIM, Kalker's algorithm for the simplified theory on Hertz's ellipse (Kalker 1982, Vehicle
// System Dynamics 11, 1-13), and FaStrip, which takes its adhesion area from strip theory (Sichani,
// Enblom and Berg 2016, Vehicle System Dynamics 54, 748-764): the models "fastsim" and "fastrip".
#pragma once

#include "theories/brush.hpp"
#include "theories/elliptic_patch.hpp"

namespace rollfem::theories {

using contact::FastsimElements;
using contact::Flexibilities;
using FastsimOptions = contact::FastsimOptions;

/// FastsimElements::grid: elements of a box with `count` over 2 a whose centres lie in the strip,
/// with the spin taken at CONTACT's position.
StripElements grid_elements(const BrushStrip& strip, double semi_axis_x, int count);

/// Forces and areas of one load point of the case; the extra rigid slip of the case is included.
BrushTotals fastsim(const EllipticPatch& patch, const contact::Creepage& creepage,
                    const FastsimOptions& options = {});

/// The same with given flexibilities instead of the linear theory's.
BrushTotals fastsim(const EllipticPatch& patch, const contact::Creepage& creepage,
                    const BrushFlexibilities& flexibilities, const FastsimOptions& options);

/// The model "fastsim": forces by the options of the scene, fields on the case's contact grid. The
/// recorded traction bound is the parabola of the theory, which exceeds mu p_n by a third in the
/// middle. error_estimate covers the resolution only, not the theory (10 to 15 % in the forces).
contact::ModelResult run_fastsim(const contact::Scene& scene, const contact::Progress& progress);

/// The model "fastrip", on the same strips and elements, under Hertz's pressure. In the
/// adhesion area tractions are those of strip theory; in the slip area they have the bound's size
/// and the direction that FASTSIM gives them, and slip is FASTSIM's, with one flexibility: with
/// three, tractions in full sliding are not opposite to the slip.
contact::ModelResult run_fastrip(const contact::Scene& scene, const contact::Progress& progress);

contact::ModelInfo fastsim_model();
contact::ModelInfo fastrip_model();

}  // namespace rollfem::theories

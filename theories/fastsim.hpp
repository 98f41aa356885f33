// SPDX-License-Identifier: LGPL-2.1-or-later
// FASTSIM, Kalker's algorithm for the simplified theory on Hertz's ellipse (Kalker 1982, Vehicle
// System Dynamics 11, 1-13), and FaStrip, which takes its adhesion area from strip theory (Sichani,
// Enblom and Berg 2016, Vehicle System Dynamics 54, 748-764): the models "fastsim" and "fastrip".
#pragma once

#include "theories/brush.hpp"
#include "theories/elliptic_patch.hpp"

#include <array>

namespace rollfem::theories {

/// Flexibilities of the brushes of FASTSIM.
enum class Flexibilities {
  three,  ///< L1, L2, L3: one for each creepage
  one,    ///< Kalker's weighted mean, as in the paper of 1982
};

/// Position of the elements in FASTSIM's strips.
enum class FastsimElements {
  chord,  ///< every strip divided into equal elements: forces of order 2 for the parabolic bound
          ///< without spin, 1.5 for the elliptic one, 1 with spin, which turns the slip
  grid,   ///< elements of the bounding box whose centres lie in the ellipse, the first reached by a
          ///< whole step, the spin a sixth of a step upstream, as in CONTACT: order one
};

struct FastsimOptions {
  BoundShape bound = BoundShape::parabolic;  ///< 4/3 mu p0 (1 - r^2), or mu p0 sqrt(1 - r^2)
  Flexibilities flexibilities = Flexibilities::three;
  FastsimElements elements = FastsimElements::chord;
  int strips = 100;          ///< across the patch
  int strip_elements = 100;  ///< along each strip, for `grid` along the longest
  /// k_0, alpha_inf, beta of the initial slope, which is reduced by 1/k (Spiryagin, Polach and
  /// Cole).
  std::array<double, 3> slope_reduction{1.0, 1.0, 1.0};
};

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

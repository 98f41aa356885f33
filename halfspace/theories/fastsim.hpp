// FASTSIM, Kalker's algorithm for the simplified theory on Hertz's ellipse (Kalker 1982, Vehicle
// System Dynamics 11, 1-13), and the model "fastsim".
#pragma once

#include "halfspace/theories/brush.hpp"
#include "halfspace/theories/elliptic_patch.hpp"

namespace rollfem::halfspace {

enum class Flexibilities {
  one,    ///< Kalker's weighted mean, as in the paper of 1982
  three,  ///< L1, L2, L3
};

/// Where the elements of the strips lie.
enum class FastsimElements {
  chord,  ///< every strip divided into equal elements: forces of order 2 for the parabolic bound
          ///< without spin, 1.5 for the elliptic one, 1 with spin, which turns the slip
  grid,   ///< elements of the bounding box whose centres lie in the ellipse, the first reached by a
          ///< whole step, as in CONTACT: order one
};

struct FastsimOptions {
  BoundShape bound = BoundShape::parabolic;  ///< 4/3 mu p0 (1 - r^2), or mu p0 sqrt(1 - r^2)
  Flexibilities flexibilities = Flexibilities::three;
  FastsimElements elements = FastsimElements::chord;
  int strips = 100;          ///< across the patch
  int strip_elements = 100;  ///< along each strip, for `grid` along the longest
};

/// Forces and areas of one load point of the case; the extra rigid slip of the case is included.
BrushTotals fastsim(const contact::Case& input, const EllipticPatch& patch,
                    const contact::Creepage& creepage, const FastsimOptions& options = {});

/// The model "fastsim": forces by `options`, fields on the case's contact grid. The recorded
/// traction bound is that of the theory, whose parabola exceeds mu p_n by a third in the middle.
/// error_estimate is that of the resolution alone, not of the theory (10 to 15 % in the forces).
contact::ModelResult run_fastsim(const contact::Case& input, const contact::Progress& progress,
                                 const FastsimOptions& options = {});

}  // namespace rollfem::halfspace

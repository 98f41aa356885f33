// SPDX-License-Identifier: LGPL-2.1-or-later
// The shakedown limit of an elliptic contact, between those of circle and
// line (postprocess/stress/shakedown.hpp): the largest shear on planes
// parallel to the surface below a sliding Hertz ellipse.
#pragma once

#include <vector>

namespace rollfem::postprocess {

/// |xz| in the plane y = 0 below an ellipse under the pressure p0 sqrt(1 - (x/a)^2 - (y/b)^2) and
/// friction times this pressure along x. Integrates the point loads of Boussinesq and Cerruti
/// (Johnson 1985, sections 3.2 and 3.6), whose xz does not depend on Poisson's ratio.
class EllipseShear {
 public:
  /// `ratio`: b/a, semi-axis across over semi-axis along rolling; clamped to 0.1 to 50.
  explicit EllipseShear(double ratio);
  double ratio() const { return ratio_; }
  /// Largest |xz| over p0 including the surface, to 5e-3.
  double largest(double friction) const;
  /// p0/k above which the material yields at every passage.
  double shakedown_limit(double friction) const { return 1.0 / largest(friction); }

 private:
  double ratio_;
  std::vector<double> of_pressure_, of_traction_;  ///< xz at common places
};

}  // namespace rollfem::postprocess

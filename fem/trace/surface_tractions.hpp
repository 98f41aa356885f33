// SPDX-License-Identifier: LGPL-2.1-or-later
// Tractions anywhere on the contact surface, interpolated from the contact elements, with
// the edge of the patch resolved below the element size.
#pragma once

#include "contact/base/grid.hpp"

#include <array>

namespace rollfem::fem {

/// Near the edge of a smooth contact pressure squared falls linearly to zero. It is extrapolated
/// linearly to the unloaded elements beside the patch and interpolated between the elements by
/// cubic convolution (Keys 1981); there is no contact where it is negative. The ratio of tangential
/// traction to pressure is bilinear over the surrounding loaded elements, which preserves the
/// traction bound.
class SurfaceTractions {
 public:
  /// `traction`: MPa, on the wheel.
  SurfaceTractions(const contact::ContactGrid& grid, const contact::SurfaceField& traction);
  /// {x, y, n} in MPa at (s, t) = (x, y) of the grid, zero outside of the patch.
  std::array<double, 3> at(double s, double t) const;

 private:
  double pressure_at(double s, double t) const;

  contact::ContactGrid grid_;
  contact::SurfaceField traction_;
  contact::Field squared_;  ///< p^2, extrapolated to negative values
};

}  // namespace rollfem::fem

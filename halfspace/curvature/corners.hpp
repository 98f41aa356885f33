// Gradients and means of element values, taken at the corners shared by four elements, and the
// transposes of both: first-order operators built from them are symmetric on the grid.
#pragma once

#include "contact/base/grid.hpp"

namespace rollfem::halfspace {

/// One value per element or inner corner, first index along x.
using Plane = Eigen::ArrayXXd;

struct Corners {
  double dx = 0.0;  ///< mm
  double dy = 0.0;

  /// d/dx, d/dy and mean at the corners; one value less each way.
  Plane along_x(const Plane& u) const;
  Plane along_y(const Plane& u) const;
  static Plane mean(const Plane& u);
  // The transposes, from corners to elements.
  Plane from_x(const Plane& m) const;
  Plane from_y(const Plane& m) const;
  static Plane from_mean(const Plane& m);
};

}  // namespace rollfem::halfspace

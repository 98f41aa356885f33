// The output of a compliance.
#pragma once

#include "contact/base/grid.hpp"

namespace rollfem::contact {

/// What tractions do to two bodies that roll over each other.
struct Response {
  SurfaceField displacement;
  /// Slip beyond the upwind difference of the displacement: on a streamline of radius R a
  /// displacement u_r towards the centre shortens the material by u_r / R along x; where the
  /// surface is tilted across, the turning frame also brings a lateral part. Empty where
  /// streamlines are straight.
  TangentialField curvature_slip;
};

}  // namespace rollfem::contact

// Slip due to the curvature of the wheel's streamlines.
#pragma once

#include "contact/base/grid.hpp"
#include "contact/scene/contact_surface.hpp"

namespace rollfem::contact {

/// On a streamline of radius R(y) a displacement u_r towards the axle brings the slip u_r / R along
/// x, since it shortens the circle; on a surface tilted across -sin u_x / R laterally, as the
/// lateral tangent turns. Together with the difference along the streamline it gives the surface
/// strain, so that a rigid displacement slips nowhere.
class CurvatureSlip {
 public:
  /// On the elements of a grid along y.
  CurvatureSlip(const ContactSurface& surface, const ContactGrid& grid);
  /// The surface at each element: climb and stretch, rolling radius in mm, angle of the axle in rad
  /// (ContactSurface).
  CurvatureSlip(const PatchShape& shape, const Field& rolling_radius, double axle_tilt);

  /// Under displacements of the wheel along x, the lateral tangent and the normal, mm.
  TangentialField operator()(const SurfaceField& displacement) const;

 private:
  /// Of normal and lateral tangent along the way to the axle, over the radius, 1/mm.
  Field normal_, lateral_;
};

}  // namespace rollfem::contact

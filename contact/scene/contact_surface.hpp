// The common surface of wheel and rail across a curved patch: the mean of both profiles, which are
// circles or the sections of a PatchGeometry. Local normals and tangents, undeformed distance and
// rigid slip of the true shapes (docs/theory.md, "Curved contact").
#pragma once

#include "contact/base/grid.hpp"
#include "contact/base/profile_drop.hpp"
#include "contact/case/case.hpp"
#include "contact/result/result.hpp"

#include <memory>

namespace rollfem::contact {

/// The contact grid is laid in the projection of this surface on z = 0: an element dx by dy at y
/// covers dx * dy * stretch of the surface. Its normal points into the wheel.
struct ContactSurface {
  double rolling_radius = infinity;           ///< mm, R0 of the wheel at y = 0
  double wheel_transverse_radius = infinity;  ///< mm, > 0 convex
  double rail_transverse_radius = infinity;   ///< mm, > 0 convex
  /// True profiles: the transverse radii then say nothing.
  std::shared_ptr<const PatchGeometry> profiles = nullptr;

  /// dz/dy of the common surface; the normal is (0, -climb, 1) / sqrt(1 + climb^2).
  double climb(double y) const;
  /// Height z of the common surface, mm.
  double height(double y) const;
  /// Of the wheel's surface at x = 0 from its axle, mm.
  double local_rolling_radius(double y) const;
  /// Angle of the axle against the y axis in the plane x = 0, rad; 0 without profiles.
  double axle_tilt() const;
  /// Both bodies have a surface at y that the case knows (circles are known everywhere).
  bool known(double y) const;
};

ContactSurface contact_surface(const Case& input);

/// How far inwards of z = 0 the surface of the wheel or the rail is at (x, y), mm: below 0 beside
/// the middle of a concave body. Infinite where the wheel does not reach x, or y of its profile.
double surface_drop(const ContactSurface& surface, bool wheel, double x, double y);

/// Means over the contact elements (equal along x): `stretch` = true area / (dx dy) and `climb`.
PatchShape patch_shape(const ContactSurface& surface, const ContactGrid& grid);

/// Distance from rail to wheel along the normal of the common surface, mm, 0 at the origin where
/// the bodies just touch: both true circles across, and the wheel's circle of the local rolling
/// radius along x; with profiles the rail's section and the surface of revolution about the true
/// axle, also a yawed one. Infinite where the normal does not meet the wheel.
double undeformed_distance(const ContactSurface& surface, double x, double y);

/// Rigid slip on the common surface from the velocities of wheel and rail, V = 1: the wheel turns
/// with omega R0 = 1 - xi about its axle, so that a point at radius R(y) slips by 1 - omega R(y)
/// along x; eta and spin bring (-phi y, eta + phi x), whose lateral part is projected on the local
/// tangent. What it leaves out with circles: the lateral part -omega x climb of the material's way
/// down to the rail, a local spin, on the local tangent.
///
/// With profiles `phi` is the whole spin at the origin, of which the tilted axle makes
/// omega dR/dy(0) by itself; that part is in R(y) already and not added twice:
/// s_x = 1 - omega R(y) - (phi - omega dR/dy(0)) y,
/// s_y = (eta + phi x - omega cos(tilt) x climb) / sqrt(1 + climb^2).
TangentialField rigid_slip(const ContactSurface& surface, const Creepage& creepage,
                           const ContactGrid& grid);

}  // namespace rollfem::contact

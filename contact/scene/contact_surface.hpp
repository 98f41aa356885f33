// SPDX-License-Identifier: LGPL-2.1-or-later
// The common surface of wheel and rail across a curved patch: the mean of both profiles, which are
// circles or the sections of a PatchGeometry. Local normals and tangents, and undeformed distance
// of the true shapes (docs/theory.md, "Curved contact").
#pragma once

#include "contact/base/grid.hpp"
#include "contact/base/profile_drop.hpp"
#include "contact/case/case.hpp"
#include "contact/scene/patch_geometry.hpp"

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
  /// How far the surface follows the mean of both profiles, whose heights and slopes it has times
  /// this: 1 all the way, 0 is the plane z = 0. Distances stay those of the bodies themselves.
  double follows = 1.0;
  /// Parts of the transverse radii up to which the bodies are round.
  double wheel_round_to = usual_round_to;
  double rail_round_to = usual_round_to;

  /// Of true profiles.
  static ContactSurface of(std::shared_ptr<const PatchGeometry> patch);

  /// dz/dy of the common surface; the normal is (0, -climb, 1) / sqrt(1 + climb^2).
  double climb(double y) const;
  /// Height z of the common surface, mm.
  double height(double y) const;
  /// Of the wheel's surface at x = 0 from its axle, mm.
  double local_rolling_radius(double y) const;
  /// How far the circles of wheel and rail have dropped at y; without profiles.
  ProfileDrop wheel_drop(double y) const;
  ProfileDrop rail_drop(double y) const;
  /// Angle of the axle against the y axis in the plane x = 0, rad; 0 without profiles.
  double axle_tilt() const;
  /// Both bodies have a surface at y that the case knows (circles are known everywhere).
  bool known(double y) const;
};

/// Arc length per length along y, of a surface with dz/dy = climb.
double stretch_of(double climb);

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

}  // namespace rollfem::contact

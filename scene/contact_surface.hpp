// SPDX-License-Identifier: LGPL-2.1-or-later
// The common surface of wheel and rail across a curved patch: the mean of both profiles, which are
// circles or the sections of a PatchGeometry. Local normals and tangents, and undeformed distance
// of the true shapes (docs/theory.md, "Curved contact").
#pragma once

#include "base/grid.hpp"
#include "base/profile_drop.hpp"
#include "case/case.hpp"
#include "scene/patch_geometry.hpp"

#include <cmath>
#include <memory>

namespace rollfem::contact {

/// The contact grid lies in the projection of this surface on z = 0: an element dx by dy at y
/// covers dx * dy * stretch of the surface. Its normal points into the wheel.
struct ContactSurface {
  double rolling_radius = infinity;           ///< mm, R0 of the wheel at y = 0
  double wheel_transverse_radius = infinity;  ///< mm, > 0 convex
  double rail_transverse_radius = infinity;   ///< mm, > 0 convex
  /// True profiles: the transverse radii are then ignored.
  std::shared_ptr<const PatchGeometry> profiles = nullptr;
  /// Factor on the heights and slopes of the mean of both profiles: 1 follows them fully, 0 is the
  /// plane z = 0. Distances are always those of the bodies.
  double follows = 1.0;
  /// Fractions of the transverse radii up to which the bodies are circular.
  double wheel_round_to = usual_round_to;
  double rail_round_to = usual_round_to;
  /// mm, about the rail's own axle: inf straight, > 0 a roller below the wheel, < 0 a ring around
  /// it; with true profiles nominal.
  double rail_rolling_radius = infinity;

  /// For true profiles.
  static ContactSurface of(std::shared_ptr<const PatchGeometry> patch);

  /// dz/dy of the common surface; the normal is (0, -climb, 1) / sqrt(1 + climb^2).
  double climb(double y) const;
  /// Height z of the common surface, mm.
  double height(double y) const;
  /// Distance of the wheel's surface at x = 0 from its axle, mm.
  double local_rolling_radius(double y) const;
  /// The same of the rail, with the sign of its rolling radius; infinite for a straight rail.
  double local_rail_radius(double y) const;
  /// Drop of the circles of wheel and rail at y; without profiles.
  ProfileDrop wheel_drop(double y) const;
  ProfileDrop rail_drop(double y) const;
  /// Radius of the rolling of both bodies on each other, mm: 1/R = 1/R_wheel + 1/R_rail.
  double relative_rolling_radius() const;
  bool rail_is_roller() const { return std::isfinite(rail_rolling_radius); }
  /// Angle of the axle against the y axis in the plane x = 0, rad; 0 without profiles.
  double axle_tilt() const;
  double rail_tilt() const;  ///< the same of a roller
  /// Whether the surfaces of both bodies are known at y (circles are known everywhere).
  bool known(double y) const;
};

/// Arc length per length along y, of a surface with dz/dy = climb.
double stretch_of(double climb);

/// Depth of the surface of the wheel or the rail from z = 0 into the body at (x, y), mm: negative
/// beside the middle of a concave body. Infinite where x is outside the wheel, or y outside its
/// profile.
double surface_drop(const ContactSurface& surface, bool wheel, double x, double y);

/// Means over the contact elements (equal along x): `stretch` = true area / (dx dy) and `climb`.
PatchShape patch_shape(const ContactSurface& surface, const ContactGrid& grid);

/// Distance from rail to wheel along the normal of the common surface, mm, 0 at the origin where
/// the bodies just touch: both true circles across, and the wheel's circle of the local rolling
/// radius along x; with profiles the rail's section and the surface of revolution about the true
/// axle, also a yawed one. Infinite where the normal does not meet the wheel.
double undeformed_distance(const ContactSurface& surface, double x, double y);

}  // namespace rollfem::contact

// SPDX-License-Identifier: LGPL-2.1-or-later
// The chart of a body with a true profile, the counterpart of SurfaceShape for the section of a
// PatchGeometry. A wheel's section is revolved about its axle, which may be tilted in the plane x =
// 0; for a yawed axle its trace at the contact is used (the yaw itself, below 25 mrad, is in
// undeformed distance and slip). Internal to fem/.
#pragma once

#include "contact/scene/contact_surface.hpp"
#include "fem/mesh/surface_shape.hpp"

#include <deal.II/base/derivative_form.h>
#include <deal.II/base/point.h>

#include <memory>

namespace rollfem::fem {

class ProfileShape {
 public:
  ProfileShape(std::shared_ptr<const contact::PatchGeometry> geometry, bool is_wheel);

  const std::shared_ptr<const contact::PatchGeometry>& geometry() const { return geometry_; }

  /// Range in which the surface is a known height over t not steeper than `steepest` (dz/dy, 75
  /// degrees: cells below it, whose sides are along z, have a scaled Jacobian of 0.26). Outside,
  /// the chart continues along the tangent (one to one, but no longer the true surface).
  double lower() const { return lower_; }
  double upper() const { return upper_; }
  static constexpr double steepest = 3.73;

  /// Height z of the surface at s = 0, mm, and its slope dz/dt.
  struct Height {
    double value;
    double slope;
  };
  Height height(double t) const;
  /// Distance of the surface from the axle, mm; infinite for a rail.
  double radius(double t) const;

  dealii::Point<3> place(double s, double t, double depth) const;
  dealii::Point<3> coordinates(const dealii::Point<3>& place) const;
  dealii::DerivativeForm<1, 3, 3> gradient(const dealii::Point<3>& chart) const;
  /// Unit vectors at a surface with dz/dy = `climb` at s = 0, rotated with the wheel.
  SurfaceFrame frame(double s, double t, double climb) const;

  /// A point of the wheel's section (y, z at x = 0) after rotation by `angle` about the axle.
  dealii::Point<3> turned_about_axle(double y, double z, double angle) const;
  /// The inverse: angle, y, z.
  dealii::Point<3> turned_to_section(const dealii::Point<3>& place) const;
  dealii::Point<3> axle_point() const { return {0.0, axle_y_, axle_z_}; }
  dealii::Tensor<1, 3> axle_direction() const;
  bool is_wheel() const { return is_wheel_; }

 private:
  /// From the axle to (y, z) in the plane x = 0, towards the material's outside.
  double distance_from_axle(double y, double z) const;

  std::shared_ptr<const contact::PatchGeometry> geometry_;
  bool is_wheel_;
  double axle_y_ = 0.0, axle_z_ = 0.0;
  double cosine_ = 1.0, sine_ = 0.0;  ///< of the axle's tilt
  double lower_ = 0.0, upper_ = 0.0;
};

/// The surface that wheel and rail of the patch share.
contact::ContactSurface profile_contact(const ProfileShape& shape);

}  // namespace rollfem::fem

// SPDX-License-Identifier: LGPL-2.1-or-later
// The surface of a body: chart coordinates and places in space.
#pragma once

#include "contact/base/profile_drop.hpp"
#include "contact/scene/contact_surface.hpp"

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <memory>

namespace rollfem::fem {

/// Unit vectors of a surface: along rolling, lateral, normal into the wheel, for both bodies.
using SurfaceFrame = std::array<dealii::Tensor<1, 3>, 3>;

/// A chart of another surface than those of wheel and rail, for bodies that are built by hand (a
/// disc in a hole). All three are given; what they mean is what SurfaceShape says.
struct ChartFunctions {
  std::function<dealii::Point<3>(const dealii::Point<3>& chart)> place;
  std::function<dealii::Point<3>(const dealii::Point<3>& place)> coordinates;
  std::function<SurfaceFrame(double s, double t)> frame;
};

class ProfileShape;

/// Surface coordinates (s, t) = (arc length on the surface along rolling, lateral coordinate y) and
/// depth d below the surface (along z on the rail, towards the axle on the wheel) -> place in
/// space. s points along +x, the contact reference point is (0, 0, 0). For the wheel the material
/// is above (z > 0), for the rail below.
struct SurfaceShape {
  bool is_wheel = false;
  double rolling_radius = contact::infinity;     ///< wheel only
  double transverse_radius = contact::infinity;  ///< > 0 convex, < 0 concave
  /// When given, these are the chart; the radii then say nothing of it.
  std::shared_ptr<const ChartFunctions> functions = nullptr;
  /// When given, the chart of a true profile about an axle that may be tilted; the transverse
  /// radius then says nothing, the rolling radius is that of t = 0.
  std::shared_ptr<const ProfileShape> profile = nullptr;
  double round_to = contact::usual_round_to;  ///< part of the transverse radius
  /// How far the circle across has dropped at t.
  contact::ProfileDrop drop_at(double t) const;
  dealii::Point<3> place(double s, double t, double depth) const;
  /// Inverse of place(): (s, t, depth).
  dealii::Point<3> coordinates(const dealii::Point<3>& place) const;
  /// On the surface at (s, t).
  SurfaceFrame frame(double s, double t) const;
  /// The same at a surface that climbs across by dz/dy = `climb` instead of the body's own slope
  /// (of chart functions: their own frame).
  SurfaceFrame tilted_frame(double s, double t, double climb) const;
  /// Radius of the circle on which the wheel's surface runs at lateral coordinate t, mm.
  double streamline_radius(double t) const;
  /// A wheel of finite radius: its streamlines are circles.
  bool is_revolved() const;
  /// Where the surface can be meshed between; infinite but for profiles.
  double lower_t() const;
  double upper_t() const;
};

/// Wheel or rail of a patch with true profiles.
SurfaceShape profile_surface(std::shared_ptr<const contact::PatchGeometry> geometry, bool is_wheel);

}  // namespace rollfem::fem

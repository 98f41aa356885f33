// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheel or rail of a curved contact in coordinates that follow the common
// surface, in which the body is a half-space up to its curvature: positions
// below the surface and directions of tractions there.
#pragma once

#include "scene/geometry.hpp"

#include <array>

namespace rollfem::contact {

class BelowSurface {
 public:
  /// `geometry` is charted by arc length (Chart::arc) and must outlive this object. A yaw of the
  /// axle is neglected.
  BelowSurface(const ChartedGeometry& geometry, bool wheel);

  /// The coordinates are useless where the normals have converged by more than this
  /// (Coordinates::spread).
  static constexpr double least_spread = 0.3;

  /// x along the streamline, y along the common surface across, both mm, as in the contact grid;
  /// depth along the common surface's normal below the body's own surface, < 0 outside.
  struct Coordinates {
    double x = 0.0;
    double y = 0.0;
    double depth = 0.0;
    /// Spread of the normals: ratio of lateral lengths at depth to those on the surface; 0 without
    /// a foot point.
    double spread = 1.0;
    /// Unit vectors along rolling, across and along the normal into the wheel.
    std::array<Vector3, 3> axes{};
  };
  Coordinates coordinates(const Vector3& place) const;
  Vector3 place(double x, double y, double depth) const;

  /// The point at (x, y) of the patch frame and `depth` mm below the surface, along z in the rail,
  /// towards the axle in the wheel. Infinite where x is outside the wheel.
  Vector3 below(double x, double y, double depth) const;

 private:
  CurveValue own(double y) const;
  double bend(double y) const;
  double arc_of(double y) const;
  Vector3 turned_about_axle(const Vector3& in_section, double angle) const;
  Vector3 turned_direction(const Vector3& in_section, double angle) const;

  const ChartedGeometry& geometry_;
  const ContactSurface& surface_;
  bool wheel_;
  bool turns_;  ///< a wheel of finite radius: its streamlines are circles about the axle
  Axle axle_;
  Vector3 down_{};  ///< from the axle to the contact
};

}  // namespace rollfem::contact

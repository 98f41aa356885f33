// SPDX-License-Identifier: LGPL-2.1-or-later
// The wheel seen along the rail. A straight rail is the same at every x, so wheel and rail touch
// where the rail touches the outline of the wheel seen along x: for every point of the wheel's
// profile, the point of its circle whose normal has no x component. With yaw that point lies ahead
// of or behind the axle; without yaw the outline is the profile itself.
#pragma once

#include "contact/scene/patch_geometry.hpp"
#include "profiles/profile_curve.hpp"

#include <vector>

namespace rollfem::track {

/// A point of the outline in the side frame.
struct OutlinePoint {
  double x = 0.0;          ///< mm, ahead of the axle's middle
  double y = 0.0;          ///< mm
  double z = 0.0;          ///< mm
  double profile_y = 0.0;  ///< mm, wheel profile coordinate
  double radius = 0.0;     ///< mm, of its circle
};

/// Points of a wheel's profile, dense enough for an outline at any pose.
struct WheelPoints {
  std::vector<profiles::ProfilePoint> points;
  std::size_t start = 0;  ///< the first one from the place on the tread on
};
/// `tread_y`: of a place on the tread, from where the outline is followed to both sides.
WheelPoints wheel_points(const profiles::ProfileCurve& wheel, double tread_y);

class Silhouette {
 public:
  /// `wheel` in profile coordinates; `axle` with axial coordinate = profile y (placement.hpp).
  /// Throws std::invalid_argument when no part of the profile is visible.
  Silhouette(const WheelPoints& wheel, double rolling_radius, const contact::Axle& axle);

  /// z over y; covers the part not steeper than a height curve allows.
  const contact::HeightCurve& curve() const { return curve_; }
  /// The point of the outline at this y of the side frame.
  OutlinePoint at(double y) const;

 private:
  contact::HeightCurve curve_;
  std::vector<double> x_;          ///< mm, at the knots of the curve
  std::vector<double> profile_y_;  ///< mm, of the wheel's profile
  contact::Axle axle_;
};

}  // namespace rollfem::track

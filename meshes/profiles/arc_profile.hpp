// The simplest transverse profile: one circular arc or a straight line, touching y = 0 at its
// middle. Wheel and rail of the thesis cases are made of it.
#pragma once

#include <limits>

namespace rollfem::meshes {

/// Profile of radius R in mm: R > 0 convex (falls away from the other body on both sides of y = 0),
/// R < 0 concave, infinite: straight.
class ArcProfile {
 public:
  /// Throws contact::InputError when the radius is zero or not a number.
  explicit ArcProfile(double radius = std::numeric_limits<double>::infinity());

  double radius() const { return radius_; }

  /// How far the surface lies away from the tangent at y = 0, mm: R - sqrt(R^2 - y^2), positive for
  /// a convex profile. Throws contact::InputError for |y| >= |R|: the arc ends there.
  double drop(double y) const;

  /// d drop / dy.
  double slope(double y) const;

  /// 1/R, 1/mm.
  double curvature() const;

 private:
  double checked_root(double y) const;

  double radius_;
};

}  // namespace rollfem::meshes

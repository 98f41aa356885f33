// How far circles fall away from their middle, without cancellation.
#pragma once

namespace rollfem::contact {

/// Depth at which a profile has dropped below its middle at lateral coordinate y (mm, towards the
/// body's inside), and its slope: a circle arc of `transverse_radius`, continued by its tangent
/// beyond 0.7 of that radius, where nothing touches any more and a steeper surface would only spoil
/// the cells.
struct ProfileDrop {
  double value = 0.0;
  double slope = 0.0;
};
ProfileDrop profile_drop(double transverse_radius, double y);

/// R - sqrt(R^2 - x^2) for |x| < R; 0 for an infinite radius.
double circle_drop(double radius, double x);

}  // namespace rollfem::contact

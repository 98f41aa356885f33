// SPDX-License-Identifier: LGPL-2.1-or-later
// The drop of a circle below its tangent, without cancellation.
#pragma once

namespace rollfem::contact {

/// Default fraction of its radius up to which a profile is a circle: 44.4 degrees.
inline constexpr double usual_round_to = 0.7;

/// Drop of a profile below its middle at lateral coordinate y (mm, towards the body's inside), and
/// its slope: a circle arc of `transverse_radius`, continued by its tangent beyond `round_to` of
/// that radius, where there is usually no contact and a steeper surface would only distort the
/// cells.
struct ProfileDrop {
  double value = 0.0;
  double slope = 0.0;
};
ProfileDrop profile_drop(double transverse_radius, double y, double round_to = usual_round_to);

/// R - sqrt(R^2 - x^2) for |x| < R; 0 for an infinite radius.
double circle_drop(double radius, double x);

}  // namespace rollfem::contact

// SPDX-License-Identifier: LGPL-2.1-or-later
// A curve through or near points of a profile: first a cubic smoothing spline in the chord
// length, for y and z alike (C. H. Reinsch, Numer. Math. 10, 1967; P. J. Green, B. W.
// Silverman, Nonparametric Regression, 1994, ch. 2), then a smoothing that assumes arcs and
// slow transitions (smooth_curvature), and a natural cubic spline through the
// result.
#pragma once

#include "profiles/profile_curve.hpp"

#include <vector>

namespace rollfem::profiles {

/// Effect of smoothing on the points.
struct SmoothingReport {
  double rms = 0.0;      ///< mm, of the distances of the points from the curve, across it
  double largest = 0.0;  ///< mm
  double scatter = 0.0;  ///< mm, of the points across the profile, from their third differences
};

/// Scatter from which on points need smoothing, mm: a wave of this height and 2 mm of length in a
/// profile changes the pressure between steel bodies by some 200 MPa.
inline constexpr double least_scatter = 0.001;

/// A value of `smoothing` for this scatter, mm.
double smoothing_for(double scatter);

/// Standard deviation of points from a smooth curve, across it, mm.
double scatter_of(const PointRow& points);

/// The first smoothing minimises the sum of squared distances + lambda * integral of (w |r''|)^2
/// with lambda such that the rms distance is `scatter` (mm), the standard deviation of the points
/// across the profile; w is the local radius of curvature, from a pass with w = 1. This pass only
/// locates the profile; the returned curve passes through the points of smooth_curvature. scatter
/// 0: natural cubic spline through all points. O(points). Throws std::invalid_argument when a
/// straight line is closer to the points than `scatter`.
ProfileCurve smoothing_spline(const PointRow& points, double scatter,
                              SmoothingReport* report = nullptr);

}  // namespace rollfem::profiles

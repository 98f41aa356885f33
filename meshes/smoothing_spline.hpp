// A curve through or near points of a profile: a cubic smoothing spline in the chord length, for y
// and z alike (C. H. Reinsch, Numer. Math. 10, 1967; P. J. Green, B. W. Silverman, Nonparametric
// Regression, 1994, ch. 2), whose penalty weighs the second derivative by how curved the profile
// is.
#pragma once

#include "meshes/profile_curve.hpp"

#include <vector>

namespace rollfem::meshes {

/// What smoothing did to the points.
struct SmoothingReport {
  double rms = 0.0;      ///< mm, of the distances between the points and their places on the curve
  double largest = 0.0;  ///< mm
  double scatter = 0.0;  ///< mm, of the points across the profile, from their third differences
};

/// Minimises the sum of squared distances + lambda * integral of (w |r''|)^2 with lambda such that
/// the rms distance is `tolerance` (mm); 0: natural cubic spline through all points. The weight w
/// is the local radius of curvature, from a first pass with w = 1: what is penalised is curvature
/// in relation to that around, so that a flange of radius 12 and a tread of 300 are smoothed alike.
/// O(points). Throws std::invalid_argument when the tolerance cannot be reached (a straight line is
/// nearer).
ProfileCurve smoothing_spline(const std::vector<double>& y, const std::vector<double>& z,
                              double tolerance, SmoothingReport* report = nullptr);

}  // namespace rollfem::meshes

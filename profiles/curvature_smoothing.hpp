// SPDX-License-Identifier: LGPL-2.1-or-later
// Moves points near a profile across it until its curvature changes little and at few points: wheel
// and rail profiles consist of arcs and slow transitions between joints.
#pragma once

#include "profiles/profile_curve.hpp"

#include <vector>

namespace rollfem::profiles {

/// Means over stretches of a row of points of values that are linear between them.
class StretchMeans {
 public:
  /// `step`: mm between the points.
  StretchMeans(const std::vector<double>& step, const std::vector<double>& values);
  /// Mean up to `window` (mm) to both sides of a place, widened to whole steps.
  double about(double place, double window) const;
  double place(std::size_t k) const { return place_[k]; }  ///< mm from the first point on

 private:
  std::vector<double> place_, integral_;
};

/// Points on the most likely curve when `points` are normally scattered across it with the standard
/// deviation `scatter` (mm; twice is assumed, so as not to follow noise) and its curvature (in
/// relation to the curvature around where that is sharper than 1 / (100 mm)) changes by normally
/// distributed amounts between one point and the next, with a variance estimated for each: nearly
/// zero within an arc, large where arcs meet (sparse Bayesian learning: M. E. Tipping, J. Machine
/// Learning Research 1, 2001; the common factor of all variances maximises the likelihood).
/// `start`: points of a first smoothing, which give the position and spacing. At least four points,
/// no duplicates in `start`. O(points).
PointRow smooth_curvature(const PointRow& points, const PointRow& start, double scatter);

/// Signed normal distances (mm) of points from the corresponding points of a smooth row.
std::vector<double> distances_across(const PointRow& points, const PointRow& smooth);

}  // namespace rollfem::profiles

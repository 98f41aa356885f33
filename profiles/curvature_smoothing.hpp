// SPDX-License-Identifier: LGPL-2.1-or-later
// Moves points near a profile across it until its curvature changes little and at few places: wheel
// and rail profiles consist of arcs and slow transitions between joints.
#pragma once

#include <vector>

namespace rollfem::profiles {

/// Points along a profile, mm.
struct PointRow {
  std::vector<double> y, z;
};

/// Points on the most likely curve when `points` are normally scattered across it with the standard
/// deviation `scatter` (mm; twice is
/// assumed, so as not to follow noise) and its curvature (in relation to the curvature around where
/// that is sharper than 1 / (100 mm)) changes by normal amounts between one point and the next, of
/// a variance that is found for each: nearly nothing within an arc, much where arcs meet (sparse
/// Bayesian learning: M. E. Tipping, J. Machine Learning Research 1, 2001; what all variances have
/// in common maximises the likelihood). `start`: points of a first smoothing that say where the
/// profile is and how its points are spaced. Four points at least, none twice in `start`.
/// O(points).
PointRow smooth_curvature(const PointRow& points, const PointRow& start, double scatter);

/// Distances (mm, signed) of points from those of a smooth row beside them, across it.
std::vector<double> distances_across(const PointRow& points, const PointRow& smooth);

}  // namespace rollfem::profiles

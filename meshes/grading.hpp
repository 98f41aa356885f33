// SPDX-License-Identifier: LGPL-2.1-or-later
// Step sizes of a graded mesh line.
#pragma once

#include <vector>

namespace rollfem::meshes {

/// Steps from 0 outwards that add up to `extent` (at least the length of the equal steps): equal
/// steps of size `first` until `fine` is covered, then growing by the factor `growth`.
std::vector<double> outward_steps(double first, double fine, double extent, double growth = 1.5);

/// Points -..., 0, ...+ with the steps in both directions.
std::vector<double> points_both_ways(const std::vector<double>& outward);

}  // namespace rollfem::meshes

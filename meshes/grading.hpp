// SPDX-License-Identifier: LGPL-2.1-or-later
// Step sizes of a graded mesh line.
#pragma once

#include <vector>

namespace rollfem::meshes {

/// Steps from 0 outwards that together make `extent` (never less than what the equal ones need):
/// equal ones of size `first` until `fine` is covered, then growing by the factor `growth`.
std::vector<double> outward_steps(double first, double fine, double extent, double growth = 1.5);

/// Points -..., 0, ...+ of the steps taken both ways.
std::vector<double> points_both_ways(const std::vector<double>& outward);

}  // namespace rollfem::meshes

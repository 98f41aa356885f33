// SPDX-License-Identifier: LGPL-2.1-or-later
// Indicators of grid errors in a solution: its largest value compared with the neighbours, the
// roughness of its rows of elements, the elements along its front, and the number of elements
// across.
#pragma once

#include "result/result.hpp"

#include <vector>

namespace rollfem::halfspace {

/// The largest value of a field compared with its neighbours.
struct Peak {
  double fall = 0.0;                ///< difference to the closer neighbour along rolling
  double sag_x = 0.0, sag_y = 0.0;  ///< above the mean of both, along and across
};
Peak peak_of(const contact::ContactGrid& grid, const contact::Field& field);

/// Roughness of the sums of a field over the rows of the grid: the root of the sum of squares of
/// their fourth differences, relative to those of uncorrelated errors.
double roughness_of_rows(const contact::ContactGrid& grid, const contact::Field& field);

/// Area of the elements along the border between adhesion and slip, mm^2.
double area_of_front(const contact::ContactGrid& grid,
                     const std::vector<contact::ElementState>& state);

/// Across the smaller side of the patch; at least 1.
double elements_across(const contact::ContactGrid& grid, const contact::PointResult& point);

}  // namespace rollfem::halfspace

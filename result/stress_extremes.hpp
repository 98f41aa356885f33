// SPDX-License-Identifier: LGPL-2.1-or-later
// Largest stresses that are not the largest value of one stress state: the tangential traction, and
// the range of xz along rolling.
#pragma once

#include "result/result.hpp"
#include "result/stress_measures.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

namespace rollfem::contact {

/// Orthogonal shear stress on the surface: the largest tangential traction.
inline constexpr const char* surface_shear = "orthogonal_shear_surface";
/// Largest range of xz of a particle below the surface as it passes the contact along x.
inline constexpr const char* xz_range = "xz_range";

/// Whether a measure (stress_measures.hpp) is searched below the surface alone: the orthogonal
/// shear stress, as rolling fatigue needs it.
inline bool only_below(const StressMeasure& measure) {
  return measure.value == orthogonal_shear;
}

/// The largest tangential traction of a load point as orthogonal shear stress on the surface of a
/// body, at the middle of its element.
StressMaximum largest_surface_shear(const std::string& body, const ContactGrid& grid,
                                    const PointResult& point);

/// A lattice of points below the surface of a body: places of rolling lines (x fastest, `columns`
/// each, then across, `rows`), layer after layer.
struct RollingLines {
  int columns = 0;
  int rows = 0;
  std::vector<std::array<double, 3>> places;  ///< mm
};

/// Largest range of xz along one of the lines: between columns, rows and layers by parabolas
/// through the neighbours. The place is that of the largest xz on the line.
StressMaximum largest_xz_range(const std::string& body, const RollingLines& lines,
                               const std::vector<double>& xz);

/// The one that sets depths below a patch, mm; a line contact has no other.
inline double smaller_semi_axis(const ContactGrid& grid, const PointResult& point) {
  return grid.is_line() ? point.semi_axis_x : std::min(point.semi_axis_x, point.semi_axis_y);
}

/// Depth of the first layer of rolling lines, mm, and their number, in bodies whose stress is known
/// everywhere.
inline double rolling_step(const PointResult& point) {
  return 0.1 * std::min(point.semi_axis_x, point.semi_axis_y);
}
inline constexpr int rolling_layers = 15;

/// Lines along the patch of a load point and as far beyond it, between one and `layers` steps of
/// depth below the surface; `place` returns the point at x, y and depth in mm.
RollingLines rolling_lines(
    const PointResult& point, double step, int layers,
    const std::function<std::array<double, 3>(double, double, double)>& place);

}  // namespace rollfem::contact

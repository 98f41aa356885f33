// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/stress_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rollfem::contact {

namespace {

/// The top of the parabola through three values one step apart, whose middle one is the largest:
/// its value, and its place from the middle in steps.
struct Top {
  double value, shift;
};

Top top_of(double before, double middle, double after) {
  const double bend = before - 2.0 * middle + after;
  const double slope = 0.5 * (after - before);
  if (!(bend < 0.0)) return {middle, 0.0};
  return {middle - 0.5 * slope * slope / bend, -slope / bend};
}

/// The largest value of a line, between its points.
Top largest_of(const std::vector<double>& line) {
  const auto k = std::max_element(line.begin(), line.end()) - line.begin();
  const auto at = static_cast<std::size_t>(k);
  if (at == 0 || at + 1 >= line.size()) return {line[at], static_cast<double>(k)};
  const Top top = top_of(line[at - 1], line[at], line[at + 1]);
  return {top.value, static_cast<double>(k) + top.shift};
}

}  // namespace

StressMaximum largest_surface_shear(const std::string& body, const ContactGrid& grid,
                                    const PointResult& point) {
  StressMaximum found{body, surface_shear, 0.0, {}};
  const SurfaceField& traction = point.fields.traction;
  for (int k = 0; k < traction.x.size() && k < traction.y.size(); ++k) {
    const double value = std::hypot(traction.x[k], traction.y[k]);
    if (value > found.value)
      found = {body, surface_shear, value, {grid.x(k % grid.nx), grid.y(k / grid.nx), 0.0}};
  }
  return found;
}

StressMaximum largest_xz_range(const std::string& body, const RollingLines& lines,
                               const std::vector<double>& xz) {
  const auto columns = static_cast<std::size_t>(lines.columns);
  StressMaximum found{body, xz_range, 0.0, {}};
  std::vector<double> ranges;
  std::size_t best = 0;
  for (std::size_t first = 0; columns > 0 && first < xz.size(); first += columns) {
    const std::vector<double> line(xz.begin() + static_cast<std::ptrdiff_t>(first),
                                   xz.begin() + static_cast<std::ptrdiff_t>(first + columns));
    std::vector<double> reversed;
    for (const double value : line) reversed.push_back(-value);
    const Top largest = largest_of(line);
    ranges.push_back(largest.value + largest_of(reversed).value);
    if (ranges.back() <= found.value) continue;
    found.value = ranges.back();
    best = ranges.size() - 1;
    found.place = lines.places[first + static_cast<std::size_t>(std::lround(largest.shift))];
  }
  // Along y, then along z, if there are neighbours on both sides.
  const auto rows = static_cast<std::size_t>(lines.rows);
  const auto refine = [&](std::size_t apart, std::size_t direction) {
    const Top top = top_of(ranges[best - apart], ranges[best], ranges[best + apart]);
    found.value += top.value - ranges[best];
    found.place[direction] += top.shift * (lines.places[(best + apart) * columns][direction] -
                                           lines.places[best * columns][direction]);
  };
  if (best % rows > 0 && best % rows + 1 < rows) refine(1, 1);
  if (best >= rows && best + rows < ranges.size()) refine(rows, 2);
  return found;
}

RollingLines rolling_lines(
    const PointResult& point, double step, int layers,
    const std::function<std::array<double, 3>(double, double, double)>& place) {
  constexpr int half = 24, across = 4;  // columns to each side, over twice the patch; rows likewise
  RollingLines lines{2 * half + 1, 2 * across + 1, {}};
  const double x0 = point.patch_x_middle.value_or(0.0), y0 = point.patch_y_middle.value_or(0.0);
  for (int k = 1; k <= layers; ++k)
    for (int j = -across; j <= across; ++j)
      for (int i = -half; i <= half; ++i)
        lines.places.push_back(place(x0 + i * 2.0 * point.semi_axis_x / half,
                                     y0 + j * point.semi_axis_y / across, k * step));
  return lines;
}

}  // namespace rollfem::contact

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/model/grid_signs.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;
using contact::PointResult;

Peak peak_of(const ContactGrid& grid, const Field& field) {
  Eigen::Index at = 0;
  const double largest = field.maxCoeff(&at);
  const int i = static_cast<int>(at) % grid.nx, j = static_cast<int>(at) / grid.nx;
  const auto value = [&](int column, int row) {
    const bool inside = column >= 0 && row >= 0 && column < grid.nx && row < grid.ny;
    return inside ? field[grid.index(column, row)] : 0.0;
  };
  return {largest - std::max(value(i - 1, j), value(i + 1, j)),
          largest - 0.5 * (value(i - 1, j) + value(i + 1, j)),
          grid.is_line() ? 0.0 : largest - 0.5 * (value(i, j - 1) + value(i, j + 1))};
}

double roughness_of_rows(const ContactGrid& grid, const Field& field) {
  if (grid.is_line()) return 0.0;           // one row
  constexpr double of_uncorrelated = 70.0;  // 1 + 16 + 36 + 16 + 1
  const auto row = [&](int j) {
    return j < 0 || j >= grid.ny ? 0.0 : field.segment(grid.index(0, j), grid.nx).sum();
  };
  double squares = 0.0;
  for (int j = 0; j < grid.ny; ++j) {
    const double rough =
        row(j - 2) - 4.0 * row(j - 1) + 6.0 * row(j) - 4.0 * row(j + 1) + row(j + 2);
    squares += rough * rough;
  }
  return std::sqrt(squares / of_uncorrelated) * grid.element_area();
}

double area_of_front(const ContactGrid& grid, const std::vector<contact::ElementState>& state) {
  if (state.size() != static_cast<std::size_t>(grid.size())) return 0.0;
  const auto parted = [&](int one, int other) {
    const contact::ElementState a = state[static_cast<std::size_t>(one)];
    const contact::ElementState b = state[static_cast<std::size_t>(other)];
    return a != b && a != contact::ElementState::exterior && b != contact::ElementState::exterior;
  };
  int count = 0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      if (i + 1 < grid.nx && parted(grid.index(i, j), grid.index(i + 1, j))) ++count;
      if (j + 1 < grid.ny && parted(grid.index(i, j), grid.index(i, j + 1))) ++count;
    }
  return count * grid.element_area();
}

double elements_across(const ContactGrid& grid, const PointResult& point) {
  const double along = 2.0 * point.semi_axis_x / grid.dx;
  return std::max(1.0, grid.is_line() ? along : std::min(along, 2.0 * point.semi_axis_y / grid.dy));
}

}  // namespace rollfem::halfspace

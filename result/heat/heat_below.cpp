// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/heat/heat_below.hpp"

#include "base/pi.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::contact {

HeatBelow::HeatBelow(const ContactGrid& grid, const HeatedBody& body, double speed,
                     const Field& surface)
    : grid_(grid), body_(body), speed_(speed), flow_(surface.array() - body.temperature) {
  const Field own = warming(0.0, grid.nx);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = grid.nx - 1; i >= 0; --i) {
      double& flow = flow_[grid.index(i, j)];
      for (int ahead = 1; i + ahead < grid.nx; ++ahead)
        flow -= own[ahead] * flow_[grid.index(i + ahead, j)];
      flow /= own[0];
    }
}

Field HeatBelow::warming(double depth, Eigen::Index count) const {
  const double conductivity = body_.effusivity * std::sqrt(body_.diffusivity);
  // By a flow since the material was so many elements ahead: that of erfc.
  const auto since = [&](double elements) {
    const double length = 2.0 * std::sqrt(body_.diffusivity * elements * grid_.dx / speed_);
    if (!(length > 0.0)) return 0.0;
    const double u = depth / length;
    return length * (std::exp(-u * u) / std::sqrt(pi) - u * std::erfc(u)) / conductivity;
  };
  Field through(count);
  double last = 0.0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const double next = since(static_cast<double>(k) + 0.5);
    through[k] = next - last;
    last = next;
  }
  return through;
}

std::vector<double> HeatBelow::rise(const std::vector<std::array<double, 3>>& places) const {
  const int nx = grid_.nx, ny = grid_.ny;
  Field by_flow;
  double of_depth = -1.0;
  // In the middle of a column, perhaps one behind the grid.
  const auto in_column = [&](int i, int j) {
    const int from = std::max(i, 0);
    if (from >= nx) return 0.0;
    return by_flow.segment(from - i, nx - from).dot(flow_.segment(grid_.index(from, j), nx - from));
  };
  std::vector<double> found(places.size(), 0.0);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto& [x, y, depth] = places[k];
    const double column = (x - grid_.x_first) / grid_.dx, row = (y - grid_.y_first) / grid_.dy;
    const bool beside = ny > 1 && (row < -0.5 || row > ny - 0.5);
    if (beside || !(column >= -nx && column < nx)) continue;
    if (depth != of_depth) by_flow = warming(of_depth = depth, 2 * nx + 1);
    const int i = static_cast<int>(std::floor(column));
    const double inside = std::clamp(row, 0.0, ny - 1.0);
    const int j = static_cast<int>(inside);
    for (const auto& [across, there] : {std::pair(1.0 - (inside - j), j), {inside - j, j + 1}})
      for (const auto& [along, here] : {std::pair(1.0 - (column - i), i), {column - i, i + 1}})
        if (across * along > 0.0) found[k] += across * along * in_column(here, there);
  }
  return found;
}

}  // namespace rollfem::contact

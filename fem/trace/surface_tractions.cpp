// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/trace/surface_tractions.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rollfem::fem {

namespace {

/// Cubic convolution: weights of four equally spaced values around a position that is `f` of a step
/// behind the second. Exact for parabolas.
std::array<double, 4> cubic_weights(double f) {
  return {0.5 * f * (-1.0 + f * (2.0 - f)), 1.0 + f * f * (-2.5 + 1.5 * f),
          0.5 * f * (1.0 + f * (4.0 - 3.0 * f)), 0.5 * f * f * (f - 1.0)};
}

/// The element before a position, and how far it is from there to the next.
struct Between {
  int element;
  double share;
};

Between between(double at, double first, double step) {
  const double elements = (at - first) / step;
  const double floor = std::floor(elements);
  return {static_cast<int>(floor), elements - floor};
}

/// One more ring of elements around the known ones, at most `largest` there.
void continue_outwards(const contact::ContactGrid& grid, contact::Field& values,
                       std::vector<char>& known, double largest) {
  const contact::Field old = values;
  const std::vector<char> was_known = known;
  const auto inside = [&](int i, int j) { return i >= 0 && i < grid.nx && j >= 0 && j < grid.ny; };
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      if (was_known[grid.index(i, j)]) continue;
      double sum = 0.0;
      int count = 0;
      for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        if (!inside(i + di, j + dj) || !was_known[grid.index(i + di, j + dj)]) continue;
        const double near = old[grid.index(i + di, j + dj)];
        const double far =
            inside(i + 2 * di, j + 2 * dj) ? old[grid.index(i + 2 * di, j + 2 * dj)] : 0.0;
        sum += std::min(2.0 * near - far, largest);
        ++count;
      }
      if (count == 0) continue;
      values[grid.index(i, j)] = sum / count;
      known[grid.index(i, j)] = 1;
    }
}

}  // namespace

SurfaceTractions::SurfaceTractions(const contact::ContactGrid& grid,
                                   const contact::SurfaceField& traction)
    : grid_(grid), traction_(traction), squared_(traction.n.cwiseAbs2()) {
  const double scale = squared_.size() > 0 ? squared_.maxCoeff() : 0.0;
  std::vector<char> known(static_cast<std::size_t>(grid.size()));
  for (int k = 0; k < grid.size(); ++k) known[k] = traction.n[k] > 0.0;
  // The second ring gives the corners between a row and a column.
  for (int ring = 0; ring < 2; ++ring) continue_outwards(grid, squared_, known, -1e-6 * scale);
  for (int k = 0; k < grid.size(); ++k)
    if (!known[k]) squared_[k] = -0.05 * scale;
}

double SurfaceTractions::pressure_at(double s, double t) const {
  const Between x = between(s, grid_.x_first, grid_.dx);
  const Between y = between(t, grid_.y_first, grid_.dy);
  const auto weights_x = cubic_weights(x.share);
  const auto weights_y = cubic_weights(y.share);
  double squared = 0.0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const int column = std::clamp(x.element - 1 + i, 0, grid_.nx - 1);
      const int row = std::clamp(y.element - 1 + j, 0, grid_.ny - 1);
      squared += weights_x[i] * weights_y[j] * squared_[grid_.index(column, row)];
    }
  return std::sqrt(std::max(squared, 0.0));
}

std::array<double, 3> SurfaceTractions::at(double s, double t) const {
  if (s < grid_.x(0) || s > grid_.x(grid_.nx - 1) || t < grid_.y(0) || t > grid_.y(grid_.ny - 1))
    return {};
  const Between x = between(s, grid_.x_first, grid_.dx);
  const Between y = between(t, grid_.y_first, grid_.dy);
  double loaded = 0.0, ratio_x = 0.0, ratio_y = 0.0;
  for (int dj = 0; dj < 2; ++dj)
    for (int di = 0; di < 2; ++di) {
      const int k = grid_.index(std::min(x.element + di, grid_.nx - 1),
                                std::min(y.element + dj, grid_.ny - 1));
      if (traction_.n[k] <= 0.0) continue;
      const double weight =
          (di == 1 ? x.share : 1.0 - x.share) * (dj == 1 ? y.share : 1.0 - y.share);
      loaded += weight;
      ratio_x += weight * traction_.x[k] / traction_.n[k];
      ratio_y += weight * traction_.y[k] / traction_.n[k];
    }
  if (loaded <= 0.0) return {};
  const double pressure = pressure_at(s, t);
  return {pressure * ratio_x / loaded, pressure * ratio_y / loaded, pressure};
}

}  // namespace rollfem::fem

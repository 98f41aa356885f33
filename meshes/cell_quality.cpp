// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meshes/cell_quality.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::meshes {

namespace {

using Vector = std::array<double, 3>;

Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double length(const Vector& a) {
  return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

double determinant(const Vector& a, const Vector& b, const Vector& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Neighbours of each corner, right-handed.
constexpr int neighbours[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                  {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
/// Opposite faces.
constexpr int faces[3][2][4] = {
    {{0, 3, 7, 4}, {1, 2, 6, 5}}, {{0, 1, 5, 4}, {3, 2, 6, 7}}, {{0, 1, 2, 3}, {4, 5, 6, 7}}};

}  // namespace

CellQuality cell_quality(const std::array<Vector, 8>& corners) {
  CellQuality quality;
  quality.shortest_edge = length(difference(corners[1], corners[0]));
  for (int k = 0; k < 8; ++k) {
    Vector edge[3];
    double product = 1.0;
    for (int d = 0; d < 3; ++d) {
      edge[d] = difference(corners[neighbours[k][d]], corners[k]);
      const double size = length(edge[d]);
      product *= size;
      quality.shortest_edge = std::min(quality.shortest_edge, size);
      quality.longest_edge = std::max(quality.longest_edge, size);
    }
    const double jacobian = determinant(edge[0], edge[1], edge[2]);
    quality.scaled_jacobian =
        std::min(quality.scaled_jacobian, product > 0 ? jacobian / product : 0.0);
  }
  double shortest = 0.0, longest = 0.0;
  for (const auto& pair : faces) {
    Vector way{};
    for (int k = 0; k < 4; ++k)
      for (int d = 0; d < 3; ++d)
        way[d] += 0.25 * (corners[pair[1][k]][d] - corners[pair[0][k]][d]);
    const double size = length(way);
    shortest = longest == 0.0 ? size : std::min(shortest, size);
    longest = std::max(longest, size);
  }
  quality.aspect_ratio = shortest > 0 ? longest / shortest : HUGE_VAL;
  return quality;
}

}  // namespace rollfem::meshes

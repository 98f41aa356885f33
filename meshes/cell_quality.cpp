// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meshes/cell_quality.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace rollfem::meshes {

namespace {

/// Neighbours of each corner, right-handed.
constexpr int neighbours[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                  {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
/// Opposite faces.
constexpr int faces[3][2][4] = {
    {{0, 3, 7, 4}, {1, 2, 6, 5}}, {{0, 1, 5, 4}, {3, 2, 6, 7}}, {{0, 1, 2, 3}, {4, 5, 6, 7}}};

}  // namespace

CellQuality cell_quality(const std::array<std::array<double, 3>, 8>& corners) {
  const auto at = [&](int k) { return Eigen::Map<const Eigen::Vector3d>(corners[k].data()); };
  CellQuality quality;
  quality.shortest_edge = (at(1) - at(0)).norm();
  for (int k = 0; k < 8; ++k) {
    Eigen::Matrix3d edges;
    double product = 1.0;
    for (int d = 0; d < 3; ++d) {
      edges.col(d) = at(neighbours[k][d]) - at(k);
      const double size = edges.col(d).norm();
      product *= size;
      quality.shortest_edge = std::min(quality.shortest_edge, size);
      quality.longest_edge = std::max(quality.longest_edge, size);
    }
    quality.scaled_jacobian =
        std::min(quality.scaled_jacobian, product > 0 ? edges.determinant() / product : 0.0);
  }
  double shortest = 0.0, longest = 0.0;
  for (const auto& pair : faces) {
    Eigen::Vector3d way = Eigen::Vector3d::Zero();
    for (int k = 0; k < 4; ++k) way += 0.25 * (at(pair[1][k]) - at(pair[0][k]));
    const double size = way.norm();
    shortest = longest == 0.0 ? size : std::min(shortest, size);
    longest = std::max(longest, size);
  }
  quality.aspect_ratio = shortest > 0 ? longest / shortest : HUGE_VAL;
  return quality;
}

}  // namespace rollfem::meshes

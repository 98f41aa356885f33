// SPDX-License-Identifier: LGPL-2.1-or-later
// Small hexahedral meshes for the tests.
#pragma once

#include "meshes/hex_mesh.hpp"
#include "meshes/msh_file.hpp"

#include "support/temporary_folder.hpp"
#include "support/test.hpp"

namespace rollfem::testing {

using Point = std::array<double, 3>;

/// A block of cells between the coordinates given, z from the first (below) to the last: the top is
/// `contact` when `contact_above`, else the bottom; all other sides are `fixed`, or `symmetry` at
/// y = 0 when `symmetric`. `place` moves the nodes.
inline meshes::HexMesh block(const std::vector<double>& x, const std::vector<double>& y,
                             const std::vector<double>& z, bool contact_above,
                             const std::function<Point(const Point&)>& place = nullptr,
                             bool symmetric = false) {
  using meshes::Side;
  meshes::HexMesh mesh;
  const int nx = static_cast<int>(x.size());
  const int ny = static_cast<int>(y.size());
  const int nz = static_cast<int>(z.size());
  const auto node = [&](int i, int j, int k) { return (k * ny + j) * nx + i; };
  for (const double c : z)
    for (const double b : y)
      for (const double a : x) mesh.points.push_back(place ? place({a, b, c}) : Point{a, b, c});
  for (int k = 0; k + 1 < nz; ++k)
    for (int j = 0; j + 1 < ny; ++j)
      for (int i = 0; i + 1 < nx; ++i) {
        const std::array<int, 8> cell{node(i, j, k),
                                      node(i + 1, j, k),
                                      node(i + 1, j + 1, k),
                                      node(i, j + 1, k),
                                      node(i, j, k + 1),
                                      node(i + 1, j, k + 1),
                                      node(i + 1, j + 1, k + 1),
                                      node(i, j + 1, k + 1)};
        mesh.cells.push_back(cell);
        const bool outside[6] = {k == 0, k + 2 == nz, j == 0, i + 2 == nx, j + 2 == ny, i == 0};
        for (int f = 0; f < 6; ++f) {
          if (!outside[f]) continue;
          Side side = f == (contact_above ? 1 : 0) ? Side::contact : Side::fixed;
          if (symmetric && f == 2) side = Side::symmetry;
          std::array<int, 4> corners{};
          for (int c = 0; c < 4; ++c) corners[c] = cell[meshes::hex_faces[f][c]];
          mesh.sides.push_back({corners, side});
        }
      }
  return mesh;
}

inline double smallest_scaled_jacobian(const meshes::HexMesh& mesh) {
  double smallest = 1.0;
  for (const auto& cell : mesh.cells) {
    std::array<std::array<double, 3>, 8> corners{};
    for (int k = 0; k < 8; ++k) corners[k] = mesh.points[cell[k]];
    smallest = std::min(smallest, meshes::cell_quality(corners).scaled_jacobian);
  }
  return smallest;
}

}  // namespace rollfem::testing

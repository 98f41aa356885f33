// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meshes/segment_mesh.hpp"

#include "base/count.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::meshes {

std::vector<double> outward_steps(double first, double fine, double extent, double growth) {
  const int equal =
      std::max(1, contact::count_of(std::ceil(fine / first - 1e-9),
                                    "cells of a mesh (fem.cell_size, fem.fine_extent)"));
  std::vector<double> steps(equal, first);
  const double rest = extent - equal * first;
  if (rest < 0.5 * first) return steps;
  std::vector<double> growing;
  double sum = 0.0;
  for (double step = first * growth; sum < rest; step *= growth) {
    // A last step that would shrink by half is dropped and the others are stretched.
    if (!growing.empty() && sum + 0.5 * step > rest) break;
    growing.push_back(step);
    sum += step;
  }
  for (const double step : growing) steps.push_back(step * rest / sum);
  return steps;
}

std::vector<double> points_both_ways(const std::vector<double>& outward) {
  std::vector<double> points{0.0};
  for (const double step : outward) points.push_back(points.back() + step);
  std::vector<double> all;
  for (auto it = points.rbegin(); it + 1 != points.rend(); ++it) all.push_back(-*it);
  all.insert(all.end(), points.begin(), points.end());
  return all;
}

HexMesh sweep(const Section& section, std::size_t steps,
              const std::function<std::array<double, 3>(const std::array<double, 2>& point,
                                                        std::size_t step)>& place) {
  HexMesh mesh;
  const int count = static_cast<int>(section.points.size());
  for (std::size_t k = 0; k < steps; ++k)
    for (const auto& p : section.points) mesh.points.push_back(place(p, k));
  for (std::size_t k = 0; k + 1 < steps; ++k) {
    const int below = static_cast<int>(k) * count;
    for (const auto& quad : section.quads) {
      std::array<int, 8> cell{};
      std::array<std::array<double, 3>, 8> corners{};
      for (int c = 0; c < 4; ++c) {
        cell[c] = below + quad[c];
        cell[c + 4] = below + count + quad[c];
      }
      for (int c = 0; c < 8; ++c) corners[c] = mesh.points[cell[c]];
      // The handedness of y, v and the sweep depends on the body and on the quadrilateral.
      if (cell_quality(corners).scaled_jacobian < 0)
        for (int c = 0; c < 4; ++c) std::swap(cell[c], cell[c + 4]);
      mesh.cells.push_back(cell);
    }
    for (const auto& edge : section.edges)
      mesh.sides.push_back({{below + edge.ends[0], below + edge.ends[1],
                             below + count + edge.ends[1], below + count + edge.ends[0]},
                            edge.side});
  }
  const int last = static_cast<int>(steps - 1) * count;
  for (const auto& quad : section.quads) {
    mesh.sides.push_back({quad, Side::fixed});
    mesh.sides.push_back(
        {{last + quad[0], last + quad[1], last + quad[2], last + quad[3]}, Side::fixed});
  }
  return mesh;
}

}  // namespace rollfem::meshes

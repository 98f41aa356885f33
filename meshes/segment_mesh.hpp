// SPDX-License-Identifier: LGPL-2.1-or-later
// Coarse meshes of wheel and rail segments generated with gmsh: the cross-section in
// quadrilaterals, then revolved about the axle or extruded along the track.
#pragma once

#include "meshes/hex_mesh.hpp"

#include <array>
#include <functional>
#include <vector>

namespace rollfem::meshes {

/// In the plane of a section, mm: y and z, or y and v.
using SectionPoint = std::array<double, 2>;

/// Quadrilaterals with their named outer edges.
struct Section {
  std::vector<SectionPoint> points;
  std::vector<std::array<int, 4>> quads;
  struct Edge {
    std::array<int, 2> ends;
    Side side;
  };
  std::vector<Edge> edges;
};

/// The section at every step of a sweep, `place(section point, step)` in space: end faces are
/// `fixed`. Cells are in the order steps, quadrilaterals.
HexMesh sweep(const Section& section, std::size_t steps,
              const std::function<std::array<double, 3>(const std::array<double, 2>& point,
                                                        std::size_t step)>& place);

}  // namespace rollfem::meshes

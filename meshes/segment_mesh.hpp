// SPDX-License-Identifier: LGPL-2.1-or-later
// Coarse meshes of segments of wheel and rail: step sizes of a graded line, and the cross-section
// in quadrilaterals, revolved about the axle or extruded along the track.
#pragma once

#include "meshes/hex_mesh.hpp"

#include <array>
#include <functional>
#include <vector>

namespace rollfem::meshes {

/// Steps from 0 outwards that add up to `extent` (at least the length of the equal steps): equal
/// steps of size `first` until `fine` is covered, then growing by the factor `growth`.
std::vector<double> outward_steps(double first, double fine, double extent, double growth = 1.5);

/// Points -..., 0, ...+ with the steps in both directions.
std::vector<double> points_both_ways(const std::vector<double>& outward);

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

// SPDX-License-Identifier: LGPL-2.1-or-later
// Coarse meshes of wheel and rail segments generated with gmsh: the cross-section in
// quadrilaterals, then revolved about the axle or extruded along the track.
#pragma once

#include "meshes/hex_mesh.hpp"

#include <array>
#include <functional>
#include <vector>

namespace rollfem::meshes {

/// Parameters of a cross-section. Coordinates are y and v, where v is the distance from z = 0 into
/// the body.
struct SectionOptions {
  std::function<double(double)> drop;  ///< v of the surface at y, mm; 0 at y = 0
  double half_width = 60;              ///< mm, reaches to |y| = half_width
  double depth = 60;                   ///< mm, v at the far side, more where the profile drops far
  double fine_half_width = 5;  ///< mm, smallest extent of cells of cell_size along the profile
  double fine_depth = 2;       ///< mm, their smallest depth
  double cell_size = 1;        ///< mm, of the coarse cells in that fine block
  bool half = false;           ///< only y >= 0
};

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

/// Quadrilaterals of a block under the patch (first, row by row) and around it, coarser with the
/// distance.
struct BlockedSection {
  Section section;
  std::size_t block_quads = 0;
};

/// A block of equal cells under the patch, quadrilaterals that grow from there to the outside.
/// Surface nodes lie exactly on the profile. Throws contact::InputError when the block does not fit
/// into the section or gmsh fails.
Section mesh_section(const SectionOptions& options);

/// The section at every step of a sweep, `place(section point, step)` in space: end faces are
/// `fixed`. Cells are in the order steps, quadrilaterals.
HexMesh sweep(const Section& section, std::size_t steps,
              const std::function<std::array<double, 3>(const std::array<double, 2>& point,
                                                        std::size_t step)>& place);

}  // namespace rollfem::meshes

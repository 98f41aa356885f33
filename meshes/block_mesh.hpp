// SPDX-License-Identifier: LGPL-2.1-or-later
// A block of equal cells under the patch that follows the profile exactly, and free quadrilaterals
// in the polygon around it. Internal to meshes/.
#pragma once

#include "meshes/segment_mesh.hpp"

#include <optional>
#include <string>

namespace rollfem::meshes {

struct BlockMesh {
  std::function<double(double)> height;  ///< of the surface over y, mm
  std::vector<double> columns;           ///< y, an odd number
  int rows = 2;                          ///< even
  double row_height = 1.0;               ///< mm, negative downwards
  bool half = false;                     ///< the first column is the symmetry line

  SectionPoint point(int column, int row) const {
    return {columns[column], height(columns[column]) + row * row_height};
  }
  int last_column() const { return static_cast<int>(columns.size()) - 1; }
};

/// A line of the polygon around a block, from here to the next one; each becomes two edges.
struct BlockedLine {
  SectionPoint begin;
  std::optional<Side> side;  ///< none: free
  bool of_block = false;     ///< between nodes of the block
};
/// The lines on the block's sides inside the section, anticlockwise around the rest: down the first
/// column (unless half), along the bottom and up the last column.
std::vector<BlockedLine> lines_of(const BlockMesh& block);

/// Block and polygon. Nodes on lines of the side `contact` are put on the surface. Throws
/// contact::InputError with the advice to change `what` when gmsh fails.
BlockedSection mesh_around(const BlockMesh& block, const std::vector<BlockedLine>& polygon,
                           const std::string& what);

}  // namespace rollfem::meshes

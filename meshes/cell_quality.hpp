// SPDX-License-Identifier: LGPL-2.1-or-later
// Quality measures of a hexahedron.
#pragma once

#include <array>

namespace rollfem::meshes {

struct CellQuality {
  /// Scaled Jacobian: minimum over the corners of the Jacobian divided by the product of the three
  /// edge lengths there; 1 for a box, 0 for a cell that is flat at a corner, negative for an
  /// inverted one.
  double scaled_jacobian = 1.0;
  double shortest_edge = 0.0;  ///< mm
  double longest_edge = 0.0;   ///< mm
  /// Aspect ratio: longest over shortest of the three lines that join the centres of opposite
  /// faces.
  double aspect_ratio = 1.0;
};

/// Corners in gmsh's (VTK's) order.
CellQuality cell_quality(const std::array<std::array<double, 3>, 8>& corners);

}  // namespace rollfem::meshes

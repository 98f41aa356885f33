// SPDX-License-Identifier: LGPL-2.1-or-later
// A coarse mesh of hexahedra with named surfaces: exchanged with gmsh
// files and passed to the finite-element bodies.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace rollfem::meshes {

// Quality measures of a hexahedron.

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

/// Surfaces with a meaning; in a gmsh file they are physical groups of these names.
enum class Side { contact, fixed, symmetry };
inline constexpr std::array<const char*, 3> side_names{"contact", "fixed", "symmetry"};

struct SideQuad {
  std::array<int, 4> corners;
  Side side;
};

struct HexMesh {
  std::vector<std::array<double, 3>> points;  ///< mm
  std::vector<std::array<int, 8>> cells;      ///< gmsh's (VTK's) order: 4 below, 4 above, both ccw
  std::vector<SideQuad> sides;

  /// Whether half of the body is meshed.
  bool half() const {
    for (const SideQuad& quad : sides)
      if (quad.side == Side::symmetry) return true;
    return false;
  }
};

/// The six faces of a cell as corner numbers, outward.
inline constexpr std::array<std::array<int, 4>, 6> hex_faces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// Checks a finite-element mesh: cells with positive volume, joined by whole faces into one piece,
/// sides made of outside faces, `contact` and `fixed` both present. `name` begins the message.
/// Throws contact::InputError.
void check_mesh(const HexMesh& mesh, const std::string& name);

}  // namespace rollfem::meshes

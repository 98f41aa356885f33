// SPDX-License-Identifier: LGPL-2.1-or-later
// Owns the gmsh library for the lifetime of an object. Internal to meshes/.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace rollfem::meshes {

/// One session at a time in a process, because gmsh has global state.
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
};

/// Last error message of gmsh; "unknown error" if there is none.
std::string gmsh_complaint();

/// Settings for meshing cross-sections: quadrilaterals whose sizes follow the given boundary lines.
void set_quadrilaterals();

/// Meshes the plane surfaces of the model. Throws contact::InputError with the advice to change
/// `what`.
void mesh_plane(const std::string& what);

/// Result of mesh_plane: nodes and quadrilaterals, and the edges on the given boundary lines.
struct PlaneMesh {
  std::vector<std::array<double, 2>> points;
  std::vector<std::array<int, 4>> quads;
  std::vector<std::array<int, 2>> edges;
  std::vector<std::size_t> line;  ///< index in `lines` of each edge
};
/// Throws contact::InputError when gmsh has left other cells.
PlaneMesh collect_plane(const std::vector<int>& lines);

}  // namespace rollfem::meshes

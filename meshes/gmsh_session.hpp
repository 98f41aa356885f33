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

/// Nodes and quadrilaterals in a closed polygon, and the edges on its lines.
struct PlaneMesh {
  std::vector<std::array<double, 2>> points;
  std::vector<std::array<int, 4>> quads;
  std::vector<std::array<int, 2>> edges;
  std::vector<std::size_t> line;  ///< of each edge: the one that begins at this corner
};
/// Cells of twice the size of the lines, recombined and split into four (a left-over triangle into
/// three): each line becomes two edges. Throws contact::InputError with the advice to change
/// `what`.
PlaneMesh mesh_polygon(const std::vector<std::array<double, 2>>& corners, const std::string& what);

}  // namespace rollfem::meshes

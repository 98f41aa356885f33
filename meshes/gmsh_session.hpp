// SPDX-License-Identifier: LGPL-2.1-or-later
// Owns the gmsh library for the lifetime of an object. Internal to meshes/.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace rollfem::meshes {

/// One at a time in a process: gmsh has one global state.
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
};

/// What gmsh complained about last; "unknown error" when it did not say.
std::string gmsh_complaint();

/// How cross-sections are meshed: in quadrilaterals whose sizes follow the lines of the boundary,
/// which are given.
void set_quadrilaterals();

/// Meshes the plane surfaces of the model. Throws contact::InputError, which advises to change
/// `what`.
void mesh_plane(const std::string& what);

/// What mesh_plane has made: nodes and quadrilaterals, and the edges on some lines of the boundary.
struct PlaneMesh {
  std::vector<std::array<double, 2>> points;
  std::vector<std::array<int, 4>> quads;
  std::vector<std::array<int, 2>> edges;
  std::vector<std::size_t> line;  ///< index in `lines` of each edge
};
/// Throws contact::InputError when gmsh has left other cells.
PlaneMesh collect_plane(const std::vector<int>& lines);

}  // namespace rollfem::meshes

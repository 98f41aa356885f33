// SPDX-License-Identifier: LGPL-2.1-or-later
// Builds hexahedra, and quadrilaterals by group, from the
// elements of a .msh file. Internal to meshes/.
#pragma once

#include "meshes/hex_mesh.hpp"
#include "meshes/msh_bytes.hpp"

#include <array>
#include <functional>
#include <map>
#include <set>
#include <unordered_map>
#include <vector>

namespace rollfem::meshes {

/// A kind of element, by its number in .msh files.
struct MshKind {
  int dimension;
  int nodes;
  const char* name;  ///< "Tetrahedron 4"
};

class MshElements {
 public:
  explicit MshElements(const MshBytes& bytes) : bytes_(bytes) {}

  /// Throws contact::InputError for a number that is not one of gmsh's kinds.
  const MshKind& kind(std::int64_t type) const;

  /// Adds the node at the last position read. Throws contact::InputError when the number exists
  /// already or a coordinate is not finite.
  void add_node(std::int64_t number, const std::array<double, 3>& coordinates);
  /// Adds the element at the last position read: its nodes, and its group of faces (4.1: the
  /// surface, 2.2: the physical group). Throws contact::InputError when there is no such node.
  void add(std::int64_t number, const MshKind& kind, int group,
           const std::vector<std::int64_t>& nodes);

  /// The hexahedra with their nodes, and the faces for which `side_of` gives a side. Throws
  /// contact::InputError when these are not quadrilaterals or not faces of the hexahedra.
  HexMesh mesh(const std::function<std::vector<Side>(int group)>& side_of) const;

 private:
  struct Face {
    std::size_t place;  ///< in the file
    int count;          ///< of nodes, 4 for a quadrilateral
    std::array<int, 4> corners{};
  };

  const MshBytes& bytes_;
  std::vector<std::array<double, 3>> points_;
  std::unordered_map<std::int64_t, int> index_;  ///< in points_, by number
  std::vector<std::array<int, 8>> cells_;
  std::set<std::array<int, 8>> once_;       ///< the cells of 2.2
  std::map<int, std::vector<Face>> faces_;  ///< by group
};

}  // namespace rollfem::meshes

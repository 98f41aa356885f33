// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meshes/msh_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::meshes {

namespace {

constexpr int quadrilateral_corners = 4;
constexpr int hexahedron_corners = 8;
/// mm: exceeded by meshes in micrometres or with garbage.
constexpr double farthest = 1e9;

/// gmsh's names and numbers.
const std::map<std::int64_t, MshKind> kinds{
    {1, {1, 2, "Line 2"}},           {2, {2, 3, "Triangle 3"}},
    {3, {2, 4, "Quadrilateral 4"}},  {4, {3, 4, "Tetrahedron 4"}},
    {5, {3, 8, "Hexahedron 8"}},     {6, {3, 6, "Prism 6"}},
    {7, {3, 5, "Pyramid 5"}},        {8, {1, 3, "Line 3"}},
    {9, {2, 6, "Triangle 6"}},       {10, {2, 9, "Quadrilateral 9"}},
    {11, {3, 10, "Tetrahedron 10"}}, {12, {3, 27, "Hexahedron 27"}},
    {13, {3, 18, "Prism 18"}},       {14, {3, 14, "Pyramid 14"}},
    {15, {0, 1, "Point"}},           {16, {2, 8, "Quadrilateral 8"}},
    {17, {3, 20, "Hexahedron 20"}},  {18, {3, 15, "Prism 15"}},
    {19, {3, 13, "Pyramid 13"}},     {20, {2, 9, "Triangle 9"}},
    {21, {2, 10, "Triangle 10"}},    {26, {1, 4, "Line 4"}},
    {29, {3, 20, "Tetrahedron 20"}}, {36, {2, 16, "Quadrilateral 16"}},
    {92, {3, 64, "Hexahedron 64"}}};

}  // namespace

const MshKind& MshElements::kind(std::int64_t type) const {
  const auto found = kinds.find(type);
  if (found == kinds.end())
    bytes_.fail(fmt::format("gmsh's element type {} is not supported; allowed: 1 (lines), 3 "
                            "(quadrilaterals), 5 (hexahedra), 15 (points)",
                            type),
                "mesh with hexahedra of order 1");
  if (found->second.dimension == 3 && found->second.nodes != hexahedron_corners)
    bytes_.fail(fmt::format("there are cells of type {}; allowed: hexahedra with 8 corners",
                            found->second.name),
                "mesh with hexahedra of order 1 (transfinite, or an extruded recombined section)");
  return found->second;
}

void MshElements::add_node(std::int64_t number, const std::array<double, 3>& coordinates) {
  for (const double c : coordinates)
    if (!(std::abs(c) <= farthest))
      bytes_.fail(fmt::format("node {} is at ({}, {}, {}) mm; allowed: magnitudes up to {:g}",
                              number, coordinates[0], coordinates[1], coordinates[2], farthest),
                  "save the mesh again, in mm");
  if (!index_.try_emplace(number, static_cast<int>(points_.size())).second)
    bytes_.fail(fmt::format("there are two nodes with the number {}", number),
                "renumber the nodes (in gmsh Renumber Mesh Nodes)");
  points_.push_back(coordinates);
}

void MshElements::add(std::int64_t number, const MshKind& kind, int group,
                      const std::vector<std::int64_t>& nodes) {
  std::array<int, 8> corners{};
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto found = index_.find(nodes[k]);
    if (found == index_.end())
      bytes_.fail(
          fmt::format(
              "element {} refers to node {}, which does not exist; allowed: nodes listed in $Nodes",
              number, nodes[k]),
          save_msh_again);
    if (k < corners.size()) corners[k] = found->second;
  }
  if (kind.dimension == 2)
    faces_[group].push_back(
        {bytes_.place(), kind.nodes, {corners[0], corners[1], corners[2], corners[3]}});
  // In 2.2 a cell is repeated with another number for each physical group that it belongs to.
  if (kind.dimension == 3 && (!bytes_.format().old || once_.insert(corners).second))
    cells_.push_back(corners);
}

HexMesh MshElements::mesh(const std::function<std::vector<Side>(int group)>& side_of) const {
  HexMesh mesh;
  std::vector<int> number(points_.size(), -1);
  for (std::array<int, 8> cell : cells_) {
    for (int& corner : cell) {
      int& own = number[static_cast<std::size_t>(corner)];
      if (own < 0) {
        own = static_cast<int>(mesh.points.size());
        mesh.points.push_back(points_[static_cast<std::size_t>(corner)]);
      }
      corner = own;
    }
    mesh.cells.push_back(cell);
  }
  for (const auto& [group, faces] : faces_)
    for (const Side side : side_of(group))
      for (const Face& face : faces) {
        const char* const name = side_names[static_cast<std::size_t>(side)];
        if (face.count != quadrilateral_corners)
          bytes_.fail_at(
              face.place,
              fmt::format("the group `{}` has faces that are not quadrilaterals with 4 corners",
                          name),
              "recombine the surface mesh");
        SideQuad quad{face.corners, side};
        for (int& corner : quad.corners) {
          corner = number[static_cast<std::size_t>(corner)];
          if (corner < 0)
            bytes_.fail_at(
                face.place,
                fmt::format("the group `{}` has a face that is not a face of a hexahedron", name),
                "save the volume cells too: put the volume into a physical group (gmsh "
                "then saves it), or set Mesh.SaveAll = 1");
        }
        mesh.sides.push_back(quad);
      }
  return mesh;
}

}  // namespace rollfem::meshes

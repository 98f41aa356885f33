// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meshes/hex_mesh.hpp"

#include "base/errors.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace rollfem::meshes {

namespace {

using Point = std::array<double, 3>;
using Face = std::array<int, 4>;
using Vector = Eigen::Vector3d;

Vector vector(const Point& p) {
  return {p[0], p[1], p[2]};
}

/// Nodes closer than this fraction of the shortest edge coincide.
constexpr double same_place = 1e-4;

[[noreturn]] void fail(const std::string& name, const std::string& wrong,
                       const std::string& action) {
  throw contact::InputError(fmt::format("{}: {}; do: {}", name, wrong, action));
}

std::string place(const Point& p) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) mm", p[0], p[1], p[2]);
}

Face sorted(Face face) {
  std::sort(face.begin(), face.end());
  return face;
}

/// Shortest edge of the mesh.
double check_cells(const HexMesh& mesh, const std::string& name) {
  if (mesh.cells.empty())
    fail(name, "it contains no hexahedra",
         "mesh the volume with hexahedra (transfinite, or an extruded recombined section)");
  double shortest = HUGE_VAL;
  long inverted = 0;
  Point where{};
  for (const auto& cell : mesh.cells) {
    std::array<Point, 8> corners{};
    for (int k = 0; k < 8; ++k) corners[k] = mesh.points[cell[k]];
    const CellQuality quality = cell_quality(corners);
    shortest = std::min(shortest, quality.shortest_edge);
    if (quality.scaled_jacobian > 0) continue;
    if (inverted++ == 0) where = corners[0];
  }
  if (inverted > 0)
    fail(name,
         fmt::format("{} of {} hexahedra are inverted or flat at a corner; the first is at {}",
                     inverted, mesh.cells.size(), place(where)),
         "smooth the mesh there, or reverse the orientation of the cells");
  return shortest;
}

/// Number of occurrences of a face, the last cell with it and the one before, and the excess of one
/// orientation over the other.
struct FaceUse {
  int count = 0;
  int cell = 0;
  int other = 0;
  int turns = 0;
};

/// +1 or -1 for the two orientations of the same corners.
int turn_of(const Face& face) {
  const auto least = std::min_element(face.begin(), face.end()) - face.begin();
  return face[(least + 1) % 4] < face[(least + 3) % 4] ? 1 : -1;
}

std::map<Face, FaceUse> faces_of(const HexMesh& mesh) {
  std::map<Face, FaceUse> faces;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const auto& corners : hex_faces) {
      Face face{};
      for (int k = 0; k < 4; ++k) face[k] = mesh.cells[c][corners[k]];
      FaceUse& use = faces[sorted(face)];
      ++use.count;
      use.turns += turn_of(face);
      use.other = std::exchange(use.cell, static_cast<int>(c));
    }
  return faces;
}

int root(std::vector<int>& parent, int k) {
  while (parent[k] != k) k = parent[k] = parent[parent[k]];
  return k;
}

/// No face belongs to more than two cells.
void check_connected(const HexMesh& mesh, const std::map<Face, FaceUse>& faces,
                     const std::string& name) {
  std::vector<int> parent(mesh.cells.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& [face, use] : faces)
    if (use.count > 1) parent[root(parent, use.other)] = root(parent, use.cell);
  std::map<int, int> sizes;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) ++sizes[root(parent, static_cast<int>(c))];
  if (sizes.size() == 1) return;
  const auto smallest = std::min_element(
      sizes.begin(), sizes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  fail(name,
       fmt::format(
           "it consists of {} parts that share no face; the smallest has {} cells and is at {}",
           sizes.size(), smallest->second, place(mesh.points[mesh.cells[smallest->first][0]])),
       "join them (in gmsh `Coherence Mesh` merges coincident nodes), or remove the loose parts");
}

/// Nodes of outside faces, sorted by x for neighbour searches.
class OutsideNodes {
 public:
  OutsideNodes(const HexMesh& mesh, const std::map<Face, FaceUse>& faces) : mesh_(mesh) {
    for (const auto& [face, use] : faces)
      if (use.count == 1) nodes_.insert(nodes_.end(), face.begin(), face.end());
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    std::sort(nodes_.begin(), nodes_.end(), [&](int a, int b) { return x(a) < x(b); });
  }

  /// A node within `reach` of the line between two nodes, other than these, or -1.
  int on_line(int from, int to, double reach) const {
    const Point& a = mesh_.points[from];
    const Point& b = mesh_.points[to];
    const double lower = std::min(a[0], b[0]) - reach;
    const double upper = std::max(a[0], b[0]) + reach;
    auto it = std::lower_bound(nodes_.begin(), nodes_.end(), lower,
                               [&](int node, double value) { return x(node) < value; });
    for (; it != nodes_.end() && x(*it) <= upper; ++it) {
      if (*it == from || *it == to) continue;
      const Vector way = vector(b) - vector(a), there = vector(mesh_.points[*it]) - vector(a);
      const double along = std::clamp(there.dot(way) / way.squaredNorm(), 0.0, 1.0);
      if ((there - along * way).norm() < reach) return *it;
    }
    return -1;
  }

 private:
  double x(int node) const { return mesh_.points[node][0]; }
  const HexMesh& mesh_;
  std::vector<int> nodes_;
};

/// Cells that touch without sharing a whole face: doubled nodes, nodes on another cell's edge.
void check_conforming(const HexMesh& mesh, const std::map<Face, FaceUse>& faces, double shortest,
                      const std::string& name) {
  for (const auto& [face, use] : faces)
    if (use.count > 2)
      fail(name,
           fmt::format("{} cells share the face at {}", use.count, place(mesh.points[face[0]])),
           "remove cells that lie on top of each other");
  for (const auto& [face, use] : faces)
    if (use.count == 2 && use.turns != 0)
      fail(name,
           fmt::format("two cells lie on the same side of the face they share at {}",
                       place(mesh.points[face[0]])),
           "remove cells that lie on top of each other");
  const OutsideNodes nodes(mesh, faces);
  for (const auto& [face, use] : faces) {
    if (use.count > 1) continue;
    // The corners are sorted; only pairs that are edges of the cell count.
    for (const auto& corners : hex_faces) {
      Face own{};
      for (int k = 0; k < 4; ++k) own[k] = mesh.cells[use.cell][corners[k]];
      if (sorted(own) != face) continue;
      for (int k = 0; k < 4; ++k) {
        const int found = nodes.on_line(own[k], own[(k + 1) % 4], same_place * shortest);
        if (found < 0) continue;
        fail(name,
             fmt::format("cells do not match at {}: a node lies on the edge of a cell that does "
                         "not contain it",
                         place(mesh.points[found])),
             "join the parts with matching nodes (in gmsh `Coherence Mesh`); rollfem does the "
             "refinement");
      }
    }
  }
}

void check_sides(const HexMesh& mesh, const std::map<Face, FaceUse>& faces,
                 const std::string& name) {
  std::array<long, side_names.size()> count{};
  for (const SideQuad& quad : mesh.sides) {
    ++count[static_cast<std::size_t>(quad.side)];
    const auto found = faces.find(sorted(quad.corners));
    if (found != faces.end() && found->second.count == 1) continue;
    fail(name,
         fmt::format("the group `{}` has a face at {} that is {}",
                     side_names[static_cast<std::size_t>(quad.side)],
                     place(mesh.points[quad.corners[0]]),
                     found == faces.end() ? "not a face of a hexahedron" : "inside the body"),
         "put only faces on the outside of the body into the group");
  }
  for (const Side side : {Side::contact, Side::fixed})
    if (count[static_cast<std::size_t>(side)] == 0)
      fail(name,
           fmt::format("there is no surface group `{}` with quadrilaterals",
                       side_names[static_cast<std::size_t>(side)]),
           "name the physical surfaces `contact` (the running surface) and `fixed` (the clamped "
           "faces), and `symmetry` if half of the body is meshed");
}

/// Neighbours of each corner, right-handed.
constexpr int neighbours[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                  {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
/// Opposite faces.
constexpr int opposite_faces[3][2][4] = {
    {{0, 3, 7, 4}, {1, 2, 6, 5}}, {{0, 1, 5, 4}, {3, 2, 6, 7}}, {{0, 1, 2, 3}, {4, 5, 6, 7}}};

}  // namespace

void check_mesh(const HexMesh& mesh, const std::string& name) {
  const double shortest = check_cells(mesh, name);
  const auto faces = faces_of(mesh);
  check_conforming(mesh, faces, shortest, name);
  check_connected(mesh, faces, name);
  check_sides(mesh, faces, name);
}

CellQuality cell_quality(const std::array<std::array<double, 3>, 8>& corners) {
  const auto at = [&](int k) { return Eigen::Map<const Eigen::Vector3d>(corners[k].data()); };
  CellQuality quality;
  quality.shortest_edge = (at(1) - at(0)).norm();
  for (int k = 0; k < 8; ++k) {
    Eigen::Matrix3d edges;
    double product = 1.0;
    for (int d = 0; d < 3; ++d) {
      edges.col(d) = at(neighbours[k][d]) - at(k);
      const double size = edges.col(d).norm();
      product *= size;
      quality.shortest_edge = std::min(quality.shortest_edge, size);
      quality.longest_edge = std::max(quality.longest_edge, size);
    }
    quality.scaled_jacobian =
        std::min(quality.scaled_jacobian, product > 0 ? edges.determinant() / product : 0.0);
  }
  double shortest = 0.0, longest = 0.0;
  for (const auto& pair : opposite_faces) {
    Eigen::Vector3d way = Eigen::Vector3d::Zero();
    for (int k = 0; k < 4; ++k) way += 0.25 * (at(pair[1][k]) - at(pair[0][k]));
    const double size = way.norm();
    shortest = longest == 0.0 ? size : std::min(shortest, size);
    longest = std::max(longest, size);
  }
  quality.aspect_ratio = shortest > 0 ? longest / shortest : HUGE_VAL;
  return quality;
}

}  // namespace rollfem::meshes

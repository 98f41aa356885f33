// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meshes/block_mesh.hpp"
#include "meshes/gmsh_session.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::meshes {

namespace {

/// Numbers of the nodes of a block, row by row.
class BlockNodes {
 public:
  explicit BlockNodes(const BlockMesh& block) : block_(block) {}
  int at(int column, int row) const { return row * (block_.last_column() + 1) + column; }

  Section section() const {
    Section result;
    const int columns = block_.last_column();
    for (int row = 0; row <= block_.rows; ++row)
      for (int column = 0; column <= columns; ++column)
        result.points.push_back(block_.point(column, row));
    for (int row = 0; row < block_.rows; ++row)
      for (int column = 0; column < columns; ++column)
        result.quads.push_back(
            {at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)});
    for (int column = 0; column < columns; ++column)
      result.edges.push_back({{at(column, 0), at(column + 1, 0)}, Side::contact});
    for (int row = 0; block_.half && row < block_.rows; ++row)
      result.edges.push_back({{at(0, row), at(0, row + 1)}, Side::symmetry});
    return result;
  }

  /// In the order of lines_of().
  std::vector<int> around() const {
    std::vector<int> nodes;
    for (int row = block_.half ? block_.rows : 0; row < block_.rows; ++row)
      nodes.push_back(at(0, row));
    for (int column = 0; column < block_.last_column(); ++column)
      nodes.push_back(at(column, block_.rows));
    for (int row = block_.rows; row >= 0; --row) nodes.push_back(at(block_.last_column(), row));
    return nodes;
  }

 private:
  const BlockMesh& block_;
};

}  // namespace

std::vector<BlockedLine> lines_of(const BlockMesh& block) {
  const std::vector<int> nodes = BlockNodes(block).around();
  const Section section = BlockNodes(block).section();
  std::vector<BlockedLine> lines;
  for (std::size_t k = 0; k + 1 < nodes.size(); k += 2)
    lines.push_back({section.points[nodes[k]], std::nullopt, true});
  return lines;
}

BlockedSection mesh_around(const BlockMesh& block, const std::vector<BlockedLine>& polygon,
                           const std::string& what) {
  BlockedSection result{BlockNodes(block).section(), 0};
  Section& section = result.section;
  result.block_quads = section.quads.size();
  const std::vector<int> around = BlockNodes(block).around();
  std::vector<SectionPoint> corners;
  corners.reserve(polygon.size());
  for (const BlockedLine& line : polygon) corners.push_back(line.begin);
  const PlaneMesh rest = mesh_polygon(corners, what);
  const auto distance = [&](int node, int other) {
    const SectionPoint &a = section.points[node], &b = rest.points[other];
    return std::hypot(a[0] - b[0], a[1] - b[1]);
  };
  // Nodes on the sides of the block are the block's nodes.
  std::vector<int> number(rest.points.size(), -1);
  for (std::size_t e = 0; e < rest.edges.size(); ++e)
    if (polygon[rest.line[e]].of_block)
      for (const int end : rest.edges[e])
        number[end] = *std::min_element(around.begin(), around.end(), [&](int a, int b) {
          return distance(a, end) < distance(b, end);
        });
  for (std::size_t k = 0; k < rest.points.size(); ++k) {
    if (number[k] >= 0) continue;
    number[k] = static_cast<int>(section.points.size());
    section.points.push_back(rest.points[k]);
  }
  for (const auto& quad : rest.quads)
    section.quads.push_back({number[quad[0]], number[quad[1]], number[quad[2]], number[quad[3]]});
  for (std::size_t e = 0; e < rest.edges.size(); ++e) {
    const std::optional<Side> side = polygon[rest.line[e]].side;
    if (!side) continue;
    section.edges.push_back({{number[rest.edges[e][0]], number[rest.edges[e][1]]}, *side});
    // gmsh has put the node in the middle on the chord.
    if (side == Side::contact)
      for (const int end : section.edges.back().ends)
        section.points[end][1] = block.height(section.points[end][0]);
  }
  return result;
}

}  // namespace rollfem::meshes

// SPDX-License-Identifier: LGPL-2.1-or-later
// The mesh of a true section: a block of equal cells under the patch that follows the profile
// exactly, and free quadrilaterals in the remaining polygon around it.
#include "contact/base/count.hpp"
#include "contact/base/errors.hpp"
#include "contact/base/pi.hpp"
#include "meshes/true_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::meshes {

namespace {

/// Lines of the polygon grow by this fraction of their distance from the block, up to `longest`; a
/// web of 16.5 mm then has two cells.
constexpr double growth = 0.5;
constexpr double longest = 16.0;  // mm
/// Largest turn of a line, rad.
constexpr double largest_turn = 0.6;

double distance(const SectionPoint& a, const SectionPoint& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

class BlockMesh {
 public:
  BlockMesh(const SectionBlock& block, double inwards) : block_(block), inwards_(inwards) {}

  int columns() const { return 2 * block_.half_columns; }
  double lower() const { return block_.middle - block_.half_columns * block_.cell_size; }
  double upper() const { return block_.middle + block_.half_columns * block_.cell_size; }
  int node(int column, int row) const { return row * (columns() + 1) + column; }

  SectionPoint point(int column, int row) const {
    const double y = block_.middle + (column - block_.half_columns) * block_.cell_size;
    return {y, block_.height(y) + inwards_ * row * block_.cell_size};
  }

  Section section() const {
    Section result;
    for (int row = 0; row <= block_.rows; ++row)
      for (int column = 0; column <= columns(); ++column)
        result.points.push_back(point(column, row));
    for (int row = 0; row < block_.rows; ++row)
      for (int column = 0; column < columns(); ++column)
        result.quads.push_back({node(column, row), node(column + 1, row), node(column + 1, row + 1),
                                node(column, row + 1)});
    for (int column = 0; column < columns(); ++column)
      result.edges.push_back({{node(column, 0), node(column + 1, 0)}, Side::contact});
    return result;
  }

  /// Nodes around the block except on top: from the left end of its top down, along the bottom and
  /// up again.
  std::vector<int> side_nodes() const {
    std::vector<int> nodes;
    for (int row = 0; row <= block_.rows; ++row) nodes.push_back(node(0, row));
    for (int column = 1; column <= columns(); ++column) nodes.push_back(node(column, block_.rows));
    for (int row = block_.rows - 1; row >= 0; --row) nodes.push_back(node(columns(), row));
    return nodes;
  }

 private:
  const SectionBlock& block_;
  double inwards_;
};

/// Points along a path at about the requested spacing: both ends, and between them as many as the
/// sum of ds / length plus the turning requires.
std::vector<SectionPoint> spaced(const std::vector<SectionPoint>& way,
                                 const std::function<double(const SectionPoint&)>& length) {
  std::vector<SectionPoint> fine{way.front()};
  for (std::size_t k = 1; k < way.size(); ++k) {
    const double size = distance(way[k - 1], way[k]);
    const int parts =
        std::max(1, contact::count_of(std::ceil(size / 0.25), "points around a section"));
    for (int p = 1; p <= parts; ++p)
      fine.push_back({way[k - 1][0] + p * (way[k][0] - way[k - 1][0]) / parts,
                      way[k - 1][1] + p * (way[k][1] - way[k - 1][1]) / parts});
  }
  std::vector<double> measure{0.0};
  double last = std::atan2(fine[1][1] - fine[0][1], fine[1][0] - fine[0][0]);
  for (std::size_t k = 1; k < fine.size(); ++k) {
    const double angle = std::atan2(fine[k][1] - fine[k - 1][1], fine[k][0] - fine[k - 1][0]);
    const double turn = std::abs(std::remainder(angle - last, 2.0 * contact::pi));
    last = angle;
    measure.push_back(measure.back() + std::max(distance(fine[k - 1], fine[k]) / length(fine[k]),
                                                turn / largest_turn));
  }
  const int count = std::max(
      1, contact::count_of(std::round(measure.back()), "points around a section (fem.cell_size)"));
  std::vector<SectionPoint> places{fine.front()};
  std::size_t at = 0;
  for (int k = 1; k < count; ++k) {
    while (measure[at] < k * measure.back() / count) ++at;
    places.push_back(fine[at]);
  }
  places.push_back(fine.back());
  return places;
}

/// Left of the block, right of it: the profile between its ends and the corners of the block.
std::vector<SectionPoint> profile_part(const TrueSection& outline, const BlockMesh& block,
                                       bool left) {
  const SectionPoint corner = block.point(left ? 0 : block.columns(), 0);
  // The nearest point of the profile, which may be undercut at a flange.
  std::size_t nearest = 0;
  for (std::size_t k = 0; k < outline.profile.size(); ++k)
    if (distance(outline.profile[k], corner) < distance(outline.profile[nearest], corner))
      nearest = k;
  std::vector<SectionPoint> part;
  if (left) {
    part.assign(outline.profile.begin(),
                outline.profile.begin() + static_cast<std::ptrdiff_t>(nearest));
    part.push_back(corner);
  } else {
    part.push_back(corner);
    part.insert(part.end(), outline.profile.begin() + static_cast<std::ptrdiff_t>(nearest) + 1,
                outline.profile.end());
  }
  if (part.size() < 2)
    throw contact::InputError(
        fmt::format("the finely meshed region from y = {:.4g} to {:.4g} mm extends beyond the "
                    "profile: use a smaller [fem] fine_extent or cell_size",
                    block.lower(), block.upper()));
  return part;
}

}  // namespace

BlockedSection mesh_true_section(const TrueSection& outline, const SectionBlock& given) {
  const BlockMesh block(given, outline.inwards);
  BlockedSection result;
  result.section = block.section();
  result.block_quads = result.section.quads.size();
  const std::vector<int> around_block = block.side_nodes();
  const auto length = [&](const SectionPoint& p) {
    double nearest = HUGE_VAL;
    for (const int node : around_block)
      nearest = std::min(nearest, distance(p, result.section.points[node]));
    return std::min(std::max(longest, 2.0 * given.cell_size),
                    2.0 * given.cell_size + growth * nearest);
  };

  // The closed polygon: profile, block, profile, lower outline. Only every second node of the
  // block, because gmsh splits each line in two.
  std::vector<SectionPoint> polygon = spaced(profile_part(outline, block, true), length);
  polygon.pop_back();
  const std::size_t block_begin = polygon.size();
  for (std::size_t k = 0; k + 1 < around_block.size(); k += 2)
    polygon.push_back(result.section.points[around_block[k]]);
  const std::size_t block_end = polygon.size();  // its last line ends here
  std::size_t held_begin = 0, held_end = 0;
  const auto add = [&](const std::vector<SectionPoint>& way) {
    const auto places = spaced(way, length);
    polygon.insert(polygon.end(), places.begin(), places.end() - 1);
  };
  add(profile_part(outline, block, false));
  for (std::size_t k = 0; k + 1 < outline.around.size(); ++k) {
    if (k == outline.held) held_begin = polygon.size();
    add({outline.around[k], outline.around[k + 1]});
    if (k == outline.held) held_end = polygon.size();
  }
  const PlaneMesh rest = mesh_polygon(polygon);

  // Merges nodes on the sides of the block with the block's nodes.
  std::vector<int> number(rest.points.size(), -1);
  for (std::size_t e = 0; e < rest.edges.size(); ++e) {
    if (rest.line[e] < block_begin || rest.line[e] >= block_end) continue;
    for (const int end : rest.edges[e]) {
      const auto nearest =
          std::min_element(around_block.begin(), around_block.end(), [&](int a, int b) {
            return distance(result.section.points[a], rest.points[end]) <
                   distance(result.section.points[b], rest.points[end]);
          });
      number[end] = *nearest;
    }
  }
  for (std::size_t k = 0; k < rest.points.size(); ++k) {
    if (number[k] >= 0) continue;
    number[k] = static_cast<int>(result.section.points.size());
    result.section.points.push_back(rest.points[k]);
  }
  for (const auto& quad : rest.quads)
    result.section.quads.push_back(
        {number[quad[0]], number[quad[1]], number[quad[2]], number[quad[3]]});
  for (std::size_t e = 0; e < rest.edges.size(); ++e)
    if (rest.line[e] >= held_begin && rest.line[e] < held_end)
      result.section.edges.push_back(
          {{number[rest.edges[e][0]], number[rest.edges[e][1]]}, Side::fixed});
  return result;
}

}  // namespace rollfem::meshes

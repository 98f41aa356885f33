// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meshes/gmsh_sections.hpp"

#include "base/count.hpp"
#include "base/errors.hpp"
#include "base/pi.hpp"
#include "base/root.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace rollfem::meshes {

GmshSession::GmshSession() {
  // User configuration files are ignored, so that meshes are the same everywhere.
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
}

GmshSession::~GmshSession() {
  gmsh::finalize();
}

namespace {

/// Nodes and quadrilaterals in a closed polygon, and the edges on its lines.
struct PlaneMesh {
  std::vector<std::array<double, 2>> points;
  std::vector<std::array<int, 4>> quads;
  struct Edge {
    std::array<int, 2> ends;
    std::size_t line;  ///< that begins at this corner
  };
  std::vector<Edge> edges;
};

/// Quadrilaterals whose sizes follow the boundary lines.
void set_quadrilaterals() {
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 1);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  // Frontal-Delaunay; the variant for quadrilaterals (8) crashes on sections in gmsh 4.8.4.
  gmsh::option::setNumber("Mesh.Algorithm", 6);
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 1);
  gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 1);
  gmsh::option::setNumber("Mesh.Smoothing", 10);
}

void mesh_plane(const std::string& what) {
  try {
    gmsh::model::geo::synchronize();
    gmsh::model::mesh::generate(2);
  } catch (...) {
    std::string complaint;
    gmsh::logger::getLastError(complaint);
    throw contact::InputError("gmsh cannot mesh the cross-section (" +
                              (complaint.empty() ? "unknown error" : complaint) +
                              "): use [fem] mesh = \"structured\", or change " + what);
  }
}

PlaneMesh collect_plane(const std::vector<int>& lines) {
  PlaneMesh mesh;
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements, corners;
  gmsh::model::mesh::getElements(types, elements, corners, 2, -1);
  constexpr int quadrilateral = 3;
  if (types != std::vector<int>{quadrilateral})
    throw contact::InputError(
        "gmsh left cells in the cross-section that are not quadrilaterals: use [fem] mesh = "
        "\"structured\"");
  std::vector<std::size_t> tags;
  std::vector<double> places, unused;
  gmsh::model::mesh::getNodes(tags, places, unused, -1, -1, false, false);
  std::unordered_map<std::size_t, std::array<double, 2>> place_of;
  for (std::size_t k = 0; k < tags.size(); ++k)
    place_of[tags[k]] = {places[3 * k], places[3 * k + 1]};
  std::unordered_map<std::size_t, int> number;
  for (const std::size_t tag : corners.front())
    if (number.try_emplace(tag, static_cast<int>(mesh.points.size())).second)
      mesh.points.push_back(place_of.at(tag));
  const auto& c = corners.front();
  for (std::size_t k = 0; k < c.size(); k += 4)
    mesh.quads.push_back(
        {number.at(c[k]), number.at(c[k + 1]), number.at(c[k + 2]), number.at(c[k + 3])});
  for (std::size_t line = 0; line < lines.size(); ++line) {
    std::vector<std::vector<std::size_t>> line_elements, ends;
    gmsh::model::mesh::getElements(types, line_elements, ends, 1, lines[line]);
    for (const auto& of_type : ends)
      for (std::size_t k = 0; k < of_type.size(); k += 2)
        mesh.edges.push_back({{number.at(of_type[k]), number.at(of_type[k + 1])}, line});
  }
  return mesh;
}

/// Cells of twice the size of the lines, recombined and split into four (a left-over triangle into
/// three): each line becomes two edges. Throws contact::InputError with the advice to change
/// `what`.
PlaneMesh mesh_polygon(const std::vector<std::array<double, 2>>& corners, const std::string& what) {
  namespace geo = gmsh::model::geo;
  const GmshSession session;
  gmsh::model::add("section");
  set_quadrilaterals();
  std::vector<int> points, lines;
  for (const auto& p : corners) points.push_back(geo::addPoint(p[0], p[1], 0.0));
  for (std::size_t k = 0; k < points.size(); ++k) {
    lines.push_back(geo::addLine(points[k], points[(k + 1) % points.size()]));
    geo::mesh::setTransfiniteCurve(lines.back(), 2);
  }
  geo::mesh::setRecombine(2, geo::addPlaneSurface({geo::addCurveLoop(lines)}));
  mesh_plane(what);
  return collect_plane(lines);
}

double distance(const SectionPoint& a, const SectionPoint& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

struct BlockMesh {
  std::function<double(double)> height;  ///< of the surface over y, mm
  std::vector<double> columns;           ///< y, an odd number
  std::vector<double> depths;            ///< of the rows, mm along the surface's z; an odd number
  bool half = false;                     ///< the first column is the symmetry line

  SectionPoint point(int column, int row) const {
    return {columns[column], height(columns[column]) + depths[row]};
  }
  int rows() const { return static_cast<int>(depths.size()) - 1; }
  int last_column() const { return static_cast<int>(columns.size()) - 1; }
  /// Nodes are numbered row by row.
  int at(int column, int row) const { return row * (last_column() + 1) + column; }

  Section section() const {
    Section result;
    const int last = last_column();
    for (int row = 0; row <= rows(); ++row)
      for (int column = 0; column <= last; ++column) result.points.push_back(point(column, row));
    for (int row = 0; row < rows(); ++row)
      for (int column = 0; column < last; ++column)
        result.quads.push_back(
            {at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)});
    for (int column = 0; column < last; ++column)
      result.edges.push_back({{at(column, 0), at(column + 1, 0)}, Side::contact});
    for (int row = 0; half && row < rows(); ++row)
      result.edges.push_back({{at(0, row), at(0, row + 1)}, Side::symmetry});
    return result;
  }

  /// In the order of lines_of().
  std::vector<int> around() const {
    std::vector<int> nodes;
    for (int row = half ? rows() : 0; row < rows(); ++row) nodes.push_back(at(0, row));
    for (int column = 0; column < last_column(); ++column) nodes.push_back(at(column, rows()));
    for (int row = rows(); row >= 0; --row) nodes.push_back(at(last_column(), row));
    return nodes;
  }
};

/// A line of the polygon around a block, from here to the next one; each becomes two edges.
struct BlockedLine {
  SectionPoint begin;
  std::optional<Side> side;  ///< none: free
  bool of_block = false;     ///< between nodes of the block
};

/// The lines on the block's sides inside the section, anticlockwise around the rest: down the first
/// column (unless half), along the bottom and up the last column.
std::vector<BlockedLine> lines_of(const BlockMesh& block) {
  const std::vector<int> nodes = block.around();
  const std::vector<SectionPoint> points = block.section().points;
  std::vector<BlockedLine> lines;
  for (std::size_t k = 0; k + 1 < nodes.size(); k += 2)
    lines.push_back({points[nodes[k]], std::nullopt, true});
  return lines;
}

/// Block and polygon. Nodes on lines of the side `contact` are put on the surface. Throws
/// contact::InputError with the advice to change `what` when gmsh fails.
BlockedSection mesh_around(const BlockMesh& block, const std::vector<BlockedLine>& polygon,
                           const std::string& what) {
  BlockedSection result{block.section(), 0};
  Section& section = result.section;
  result.block_quads = section.quads.size();
  const std::vector<int> around = block.around();
  std::vector<SectionPoint> corners;
  corners.reserve(polygon.size());
  for (const BlockedLine& line : polygon) corners.push_back(line.begin);
  const PlaneMesh rest = mesh_polygon(corners, what);
  // Nodes on the sides of the block are the block's nodes.
  std::vector<int> number(rest.points.size(), -1);
  for (const auto& [ends, line] : rest.edges)
    if (polygon[line].of_block)
      for (const int end : ends) {
        const auto to_node = [&, end = end](int node) {
          return distance(section.points[node], rest.points[end]);
        };
        number[end] = *std::min_element(around.begin(), around.end(),
                                        [&](int a, int b) { return to_node(a) < to_node(b); });
      }
  for (std::size_t k = 0; k < rest.points.size(); ++k) {
    if (number[k] >= 0) continue;
    number[k] = static_cast<int>(section.points.size());
    section.points.push_back(rest.points[k]);
  }
  for (const auto& quad : rest.quads)
    section.quads.push_back({number[quad[0]], number[quad[1]], number[quad[2]], number[quad[3]]});
  for (const auto& [ends, line] : rest.edges) {
    const std::optional<Side> side = polygon[line].side;
    if (!side) continue;
    section.edges.push_back({{number[ends[0]], number[ends[1]]}, *side});
    // gmsh has put the node in the middle on the chord.
    if (side == Side::contact)
      for (const int end : section.edges.back().ends)
        section.points[end][1] = block.height(section.points[end][0]);
  }
  return result;
}

// The cross-section of a segment: the block under the patch and the rest of a box below the
// profile.

/// y of the profile's nodes from 0 outwards: chords of `step` over the fine block, then growing.
struct ProfileNodes {
  std::vector<double> y{0.0};
  std::size_t fine = 0;  ///< the block ends at y[fine]
};

/// The next node at the distance `step` along the profile.
double next_node(const std::function<double(double)>& drop, double y, double step) {
  const auto beyond = [&](double at) { return std::hypot(at - y, drop(at) - drop(y)) - step; };
  // A little farther, because a flat profile reaches the distance only up to rounding.
  return contact::bracketed_root(beyond, y, y + (1.0 + 1e-9) * step, 1e-15 * step,
                                 "nodes of the section");
}

ProfileNodes profile_nodes(const SectionOptions& options) {
  const double step = 2.0 * options.cell_size;
  ProfileNodes nodes;
  while (nodes.y.back() < options.fine_half_width * (1.0 - 1e-9))
    nodes.y.push_back(next_node(options.drop, nodes.y.back(), step));
  nodes.fine = nodes.y.size() - 1;
  const double begin = nodes.y.back();
  if (begin > 0.8 * options.half_width)
    throw contact::InputError(
        fmt::format("the finely meshed region needs {:.4g} mm of the half width {:.4g} mm of the "
                    "section: enlarge [fem] width or extent",
                    begin, options.half_width));
  const auto steps = outward_steps(step, step, options.half_width - begin);
  const double sum = std::accumulate(steps.begin(), steps.end(), 0.0);
  double at = 0.0;
  for (const double s : steps)
    nodes.y.push_back(begin + (at += s) * (options.half_width - begin) / sum);
  nodes.y.back() = options.half_width;
  return nodes;
}

constexpr const char* of_section = "cells of a cross-section (fem.cell_size, fem.extent)";

/// Columns at the nodes of the profile and in the middle between them.
BlockMesh block_of(const SectionOptions& options, const ProfileNodes& nodes) {
  const double step = 2.0 * options.cell_size;
  const int rows =
      std::max(1, contact::count_of(std::ceil(options.fine_depth / step - 1e-9), of_section));
  if (rows * step > 0.8 * options.depth)
    throw contact::InputError(
        fmt::format("the finely meshed region needs {:.4g} mm of the depth {:.4g} mm of the "
                    "section: enlarge [fem] depth or extent",
                    rows * step, options.depth));
  BlockMesh block{options.drop, {0.0}, {}, options.half};
  for (int row = 0; row <= 2 * rows; ++row)
    block.depths.push_back(options.row_depth(row * options.cell_size));
  for (std::size_t k = 0; k < nodes.fine; ++k) {
    block.columns.push_back(0.5 * (nodes.y[k] + nodes.y[k + 1]));
    block.columns.push_back(nodes.y[k + 1]);
  }
  if (options.half) return block;
  std::vector<double> both(block.columns.rbegin(), block.columns.rend() - 1);
  for (double& y : both) y = -y;
  both.insert(both.end(), block.columns.begin(), block.columns.end());
  block.columns = std::move(both);
  return block;
}

/// The lines around the block: right part of the profile, right side, bottom, left side, left part,
/// and along the block.
class Around {
 public:
  Around(const SectionOptions& options, const ProfileNodes& nodes, const BlockMesh& block) {
    const double end = options.half_width, left = options.half ? 0.0 : -end;
    const double bottom = std::max(options.depth, options.drop(end) + 0.4 * options.depth);
    const double coarse = end - nodes.y[nodes.y.size() - 2];
    for (std::size_t k = nodes.fine; k + 1 < nodes.y.size(); ++k)
      lines_.push_back({{nodes.y[k], options.drop(nodes.y[k])}, Side::contact});
    add_equal({end, options.drop(end)}, {end, bottom}, coarse);
    add_equal({end, bottom}, {left, bottom}, coarse);
    if (options.half) {
      add_graded(bottom, block.point(0, block.rows())[1], options.cell_size);
    } else {
      add_equal({left, bottom}, {left, options.drop(left)}, coarse);
      for (std::size_t k = nodes.y.size() - 1; k > nodes.fine; --k)
        lines_.push_back({{-nodes.y[k], options.drop(-nodes.y[k])}, Side::contact});
    }
    const std::vector<BlockedLine> of_block = lines_of(block);
    lines_.insert(lines_.end(), of_block.begin(), of_block.end());
  }
  const std::vector<BlockedLine>& lines() const { return lines_; }

 private:
  void add_equal(const SectionPoint& from, const SectionPoint& to, double step) {
    const int count =
        std::max(2, contact::count_of(std::round(distance(from, to) / step), of_section));
    for (int k = 0; k < count; ++k) {
      const double share = static_cast<double>(k) / count;
      lines_.push_back({{from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])},
                        Side::fixed});
    }
  }
  /// On the symmetry line from the bottom up to the block, finer upwards.
  void add_graded(double bottom, double block_depth, double cell_size) {
    const double way = bottom - block_depth;
    const auto steps = outward_steps(2.6 * cell_size, 0.0, way);
    const double sum = std::accumulate(steps.begin(), steps.end(), 0.0);
    double below = sum;
    for (auto step = steps.rbegin(); step != steps.rend(); below -= *step++)
      lines_.push_back({{0.0, block_depth + below * way / sum}, Side::symmetry});
  }

  std::vector<BlockedLine> lines_;
};

// The mesh of a true section: a block of equal cells under the patch, and the polygon around it.

/// Lines of the polygon grow by this fraction of their distance from the block, up to `longest`; a
/// web of 16.5 mm then has two cells.
constexpr double growth = 0.5;
constexpr double longest = 16.0;  // mm
/// Largest turn of a line, rad.
constexpr double largest_turn = 0.6;

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
  const SectionPoint corner = block.point(left ? 0 : block.last_column(), 0);
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
                    block.columns.front(), block.columns.back()));
  return part;
}

}  // namespace

Section mesh_section(const SectionOptions& options) {
  const ProfileNodes nodes = profile_nodes(options);
  const BlockMesh block = block_of(options, nodes);
  return mesh_around(block, Around(options, nodes, block).lines(), "width and depth").section;
}

BlockedSection mesh_true_section(const TrueSection& outline, const SectionBlock& given) {
  BlockMesh block{given.height, {}, {}};
  for (int row = 0; row <= given.rows; ++row)
    block.depths.push_back(outline.inwards * given.row_depth(row * given.cell_size));
  for (int column = -given.half_columns; column <= given.half_columns; ++column)
    block.columns.push_back(given.middle + column * given.cell_size);
  std::vector<SectionPoint> around_block;
  for (int row = 0; row <= block.rows(); ++row)
    for (int column = 0; column <= block.last_column(); ++column)
      if (row == block.rows() || column == 0 || column == block.last_column())
        around_block.push_back(block.point(column, row));
  const auto length = [&](const SectionPoint& p) {
    double nearest = HUGE_VAL;
    for (const SectionPoint& node : around_block) nearest = std::min(nearest, distance(p, node));
    return std::min(std::max(longest, 2.0 * given.cell_size),
                    2.0 * given.cell_size + growth * nearest);
  };
  // The closed polygon: profile, block, profile, lower outline.
  std::vector<BlockedLine> polygon;
  const auto add = [&](const std::vector<SectionPoint>& way, std::optional<Side> side = {}) {
    const auto places = spaced(way, length);
    for (std::size_t k = 0; k + 1 < places.size(); ++k) polygon.push_back({places[k], side});
  };
  add(profile_part(outline, block, true));
  const std::vector<BlockedLine> of_block = lines_of(block);
  polygon.insert(polygon.end(), of_block.begin(), of_block.end());
  add(profile_part(outline, block, false));
  for (std::size_t k = 0; k + 1 < outline.around.size(); ++k)
    add({outline.around[k], outline.around[k + 1]},
        k == outline.held ? std::optional(Side::fixed) : std::nullopt);
  return mesh_around(block, polygon, "the depth");
}

}  // namespace rollfem::meshes

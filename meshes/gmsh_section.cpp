// SPDX-License-Identifier: LGPL-2.1-or-later
// The cross-section through gmsh: two surfaces, the transfinite block under the patch and the rest,
// in quadrilaterals of twice the size, which gmsh then splits into four (or a left-over triangle
// into three), so that only quadrilaterals remain.
#include "contact/base/count.hpp"
#include "contact/base/errors.hpp"
#include "contact/base/root.hpp"
#include "meshes/gmsh_session.hpp"
#include "meshes/grading.hpp"
#include "meshes/segment_mesh.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace rollfem::meshes {

namespace {

namespace geo = gmsh::model::geo;

/// y of the profile's nodes from 0 outwards: chords of `step` over the fine block, then growing.
struct ProfileNodes {
  std::vector<double> y{0.0};
  std::size_t fine = 0;  ///< the block ends at y[fine]
};

/// The next node at the distance `step` along the profile.
double next_node(const std::function<double(double)>& drop, double y, double step) {
  const auto beyond = [&](double at) { return std::hypot(at - y, drop(at) - drop(y)) - step; };
  return contact::bracketed_root(beyond, y, y + step, 1e-15 * step, "nodes of the section");
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
  double sum = 0.0, at = 0.0;
  for (const double s : steps) sum += s;
  for (const double s : steps)
    nodes.y.push_back(begin + (at += s) * (options.half_width - begin) / sum);
  nodes.y.back() = options.half_width;
  return nodes;
}

constexpr const char* of_section = "cells of a cross-section (fem.cell_size, fem.extent)";

/// Points and lines of the section, with the meaning of the lines.
class SectionGeometry {
 public:
  explicit SectionGeometry(const SectionOptions& options)
      : options_(options), nodes_(profile_nodes(options)) {
    const double step = 2.0 * options.cell_size;
    const int rows =
        std::max(1, contact::count_of(std::ceil(options.fine_depth / step - 1e-9), of_section));
    block_depth_ = rows * step;
    const double highest = options.drop(options.half_width);
    bottom_ = std::max(options.depth, highest + 0.4 * options.depth);
    if (block_depth_ > 0.8 * options.depth)
      throw contact::InputError(
          fmt::format("the finely meshed region needs {:.4g} mm of the depth {:.4g} mm of the "
                      "section: enlarge [fem] depth or extent",
                      block_depth_, options.depth));
    build(rows);
  }

  const std::map<int, Side>& sides() const { return sides_; }

  /// Splitting puts the new nodes of the block on chords; they are moved back to their depth below
  /// the profile.
  void straighten_block(Section& section) const {
    const double end = nodes_.y[nodes_.fine] * (1.0 + 1e-9);
    for (auto& [y, v] : section.points) {
      const double row = std::round((v - options_.drop(y)) / options_.cell_size);
      if (std::abs(y) <= end && row * options_.cell_size <= block_depth_ * (1.0 + 1e-9))
        v = options_.drop(y) + row * options_.cell_size;
    }
  }

 private:
  /// Points of one side of the section from the middle outwards (sign: +1 or -1).
  int point(double y, double v) { return geo::addPoint(y, v, 0.0); }

  int line(int from, int to) {
    const int tag = geo::addLine(from, to);
    geo::mesh::setTransfiniteCurve(tag, 2);
    return tag;
  }

  std::vector<int> lines(const std::vector<int>& points) {
    std::vector<int> tags;
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      tags.push_back(line(points[k], points[k + 1]));
    return tags;
  }

  std::vector<int> named(std::vector<int> tags, Side side) {
    for (const int tag : tags) sides_[tag] = side;
    return tags;
  }

  void build(int rows) {
    // From the left end of the profile to the right one.
    std::vector<double> y;
    if (!options_.half)
      for (std::size_t k = nodes_.y.size() - 1; k > 0; --k) y.push_back(-nodes_.y[k]);
    y.insert(y.end(), nodes_.y.begin(), nodes_.y.end());
    const std::size_t outer = nodes_.y.size() - 1 - nodes_.fine;
    const std::size_t left = options_.half ? 0 : outer;  // first point of the block
    const std::size_t right = y.size() - 1 - outer;      // its last
    std::vector<int> top;
    for (const double at : y) top.push_back(point(at, options_.drop(at)));
    std::vector<int> under;  // bottom of the block, from left to right
    for (std::size_t k = left; k <= right; ++k)
      under.push_back(point(y[k], options_.drop(y[k]) + block_depth_));
    const auto down = [&](double at, int from, int to) {
      std::vector<int> points{from};
      for (int r = 1; r < rows; ++r)
        points.push_back(point(at, options_.drop(at) + r * block_depth_ / rows));
      points.push_back(to);
      return points;
    };
    const auto part = [](const std::vector<int>& all, std::size_t from, std::size_t to) {
      return std::vector<int>(all.begin() + static_cast<std::ptrdiff_t>(from),
                              all.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    };
    const auto block_top = named(lines(part(top, left, right)), Side::contact);
    const auto block_bottom = lines(under);
    auto block_left = lines(down(y[left], top[left], under.front()));
    if (options_.half) block_left = named(block_left, Side::symmetry);
    const auto block_right = lines(down(y[right], top[right], under.back()));

    const int block =
        surface({{block_top, 1}, {block_right, 1}, {block_bottom, -1}, {block_left, -1}});
    geo::mesh::setTransfiniteSurface(block, "Left",
                                     {top[left], top[right], under.back(), under.front()});
    geo::mesh::setRecombine(2, block);

    // The rest: right part of the profile, right side, bottom, left side, left part, and around
    // the block.
    const double coarse = y.back() - y[y.size() - 2];
    const auto right_side =
        spaced(y.back(), options_.drop(y.back()), y.back(), bottom_, coarse, top.back(), 0);
    const double left_end = y.front();
    std::vector<int> left_side;  // upwards
    if (options_.half)
      left_side = graded_upwards(under.front());
    else
      left_side =
          spaced(left_end, bottom_, left_end, options_.drop(left_end), coarse, 0, top.front());
    const auto bottom =
        spaced(y.back(), bottom_, left_end, bottom_, coarse, right_side.back(), left_side.front());
    const auto right_top = named(lines(part(top, right, top.size() - 1)), Side::contact);
    const auto right_lines = named(lines(right_side), Side::fixed);
    const auto bottom_lines = named(lines(bottom), Side::fixed);
    const auto left_lines = named(lines(left_side), options_.half ? Side::symmetry : Side::fixed);
    std::vector<std::pair<std::vector<int>, int>> around{
        {right_top, 1}, {right_lines, 1}, {bottom_lines, 1}, {left_lines, 1}};
    if (!options_.half) {
      around.push_back({named(lines(part(top, 0, left)), Side::contact), 1});
      around.push_back({block_left, 1});
    }
    around.push_back({block_bottom, 1});
    around.push_back({block_right, -1});
    geo::mesh::setRecombine(2, surface(around));
  }

  /// Points between two ends, about `step` apart; given end points are used, 0 creates new ones.
  std::vector<int> spaced(double y0, double v0, double y1, double v1, double step, int first,
                          int last) {
    const int count =
        std::max(2, contact::count_of(std::round(std::hypot(y1 - y0, v1 - v0) / step), of_section));
    std::vector<int> points;
    for (int k = 0; k <= count; ++k) {
      const double share = static_cast<double>(k) / count;
      if (k == 0 && first != 0)
        points.push_back(first);
      else if (k == count && last != 0)
        points.push_back(last);
      else
        points.push_back(point(y0 + share * (y1 - y0), v0 + share * (v1 - v0)));
    }
    return points;
  }

  /// Points on the symmetry line from the bottom up to the block, finer upwards.
  std::vector<int> graded_upwards(int block_corner) {
    const double way = bottom_ - block_depth_;
    const auto steps = outward_steps(2.6 * options_.cell_size, 0.0, way);
    double sum = 0.0;
    for (const double s : steps) sum += s;
    std::vector<int> points{block_corner};
    double at = 0.0;
    for (const double s : steps) points.push_back(point(0.0, block_depth_ + (at += s) * way / sum));
    std::reverse(points.begin(), points.end());
    return points;
  }

  int surface(const std::vector<std::pair<std::vector<int>, int>>& chains) {
    std::vector<int> loop;
    for (const auto& [tags, sign] : chains) {
      auto chain = tags;
      if (sign < 0) std::reverse(chain.begin(), chain.end());
      for (const int tag : chain) loop.push_back(sign * tag);
    }
    return geo::addPlaneSurface({geo::addCurveLoop(loop)});
  }

  const SectionOptions& options_;
  ProfileNodes nodes_;
  double block_depth_ = 0.0;
  double bottom_ = 0.0;
  std::map<int, Side> sides_;
};

/// Nodes and quadrilaterals of the finished mesh.
Section collect(const SectionOptions& options, const SectionGeometry& geometry) {
  std::vector<int> lines;
  std::vector<Side> sides;
  for (const auto& [line, side] : geometry.sides()) {
    lines.push_back(line);
    sides.push_back(side);
  }
  PlaneMesh mesh = collect_plane(lines);
  Section section{std::move(mesh.points), std::move(mesh.quads), {}};
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    section.edges.push_back({mesh.edges[k], sides[mesh.line[k]]});
    // Splitting has put nodes on the chord.
    if (section.edges.back().side == Side::contact)
      for (const int end : mesh.edges[k])
        section.points[end][1] = options.drop(section.points[end][0]);
  }
  geometry.straighten_block(section);
  return section;
}

}  // namespace

Section mesh_section(const SectionOptions& options) {
  const GmshSession session;
  gmsh::model::add("section");
  set_quadrilaterals();
  const SectionGeometry geometry(options);
  mesh_plane("width and depth");
  return collect(options, geometry);
}

}  // namespace rollfem::meshes

// SPDX-License-Identifier: LGPL-2.1-or-later
// The cross-section of a segment: the block under the patch and the rest of a box below the
// profile.
#include "contact/base/count.hpp"
#include "contact/base/errors.hpp"
#include "contact/base/root.hpp"
#include "meshes/block_mesh.hpp"
#include "meshes/grading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rollfem::meshes {

namespace {

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
  double sum = 0.0, at = 0.0;
  for (const double s : steps) sum += s;
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
  BlockMesh block{options.drop, {0.0}, 2 * rows, options.cell_size, options.half};
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
      add_graded(bottom, block.point(0, block.rows)[1], options.cell_size);
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
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    const int count = std::max(2, contact::count_of(std::round(length / step), of_section));
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

}  // namespace

Section mesh_section(const SectionOptions& options) {
  const ProfileNodes nodes = profile_nodes(options);
  const BlockMesh block = block_of(options, nodes);
  return mesh_around(block, Around(options, nodes, block).lines(), "width and depth").section;
}

}  // namespace rollfem::meshes

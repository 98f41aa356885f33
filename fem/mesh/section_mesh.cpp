// SPDX-License-Identifier: LGPL-2.1-or-later
// Coarse meshes of true sections: the block under the patch as large as fits, swept along the rail
// or about the axle.
#include "contact/base/count.hpp"
#include "contact/base/errors.hpp"
#include "fem/mesh/coarse_mesh.hpp"
#include "fem/mesh/profile_shape.hpp"
#include "meshes/cell_quality.hpp"
#include "meshes/grading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace rollfem::fem {

namespace {

using meshes::HexMesh;

/// Coarse cells of true sections, mm.
constexpr double largest_coarse_cell = 7.0;
constexpr int deepest_level_of_section = 5;
/// Meshes with sharper corners than this are retried with smaller cells near the patch.
constexpr double good_scaled_jacobian = 0.2;

constexpr const char* of_block = "cells under the patch (fem.cell_size, fem.extent)";

double smallest_scaled_jacobian(const HexMesh& mesh) {
  double smallest = 1.0;
  for (const auto& cell : mesh.cells) {
    std::array<std::array<double, 3>, 8> corners{};
    for (int k = 0; k < 8; ++k) corners[k] = mesh.points[cell[k]];
    smallest = std::min(smallest, meshes::cell_quality(corners).scaled_jacobian);
  }
  return smallest;
}

/// Sweeps the section over the slices: along the rail, or about the axle by arcs of the given
/// length on the surface of the block, so that its faces are rectangles in the chart.
CoarseBody swept_section(const meshes::BlockedSection& blocked, const meshes::SectionBlock& block,
                         const SurfaceShape& shape, const std::vector<double>& places) {
  const double reach = block.half_columns * block.cell_size;
  CoarseBody body;
  body.mesh = meshes::sweep(
      blocked.section, places.size(), [&](const meshes::SectionPoint& p, std::size_t k) {
        if (!shape.is_revolved()) return std::array<double, 3>{places[k], p[0], p[1]};
        const double t = std::clamp(p[0], block.middle - reach, block.middle + reach);
        const auto at =
            shape.profile->turned_about_axle(p[0], p[1], places[k] / shape.profile->radius(t));
        return std::array<double, 3>{at[0], at[1], at[2]};
      });
  const std::size_t quads = blocked.section.quads.size();
  for (std::size_t c = 0; c < body.mesh.cells.size(); ++c)
    body.follows_surface.push_back(c % quads < blocked.block_quads);
  return body;
}

}  // namespace

CoarseBody make_true_section_mesh(const meshes::TrueSection& outline, const SurfaceShape& shape,
                                  const BodyOptions& options) {
  const double room =
      std::min(options.middle - shape.lower_t(), shape.upper_t() - options.middle) + 1e-9;
  meshes::SectionBlock block;
  block.height = [&shape](double t) { return shape.profile->height(t).value; };
  block.middle = options.middle;
  CoarseBody best;
  double best_quality = 0.0;
  std::string complaint = "no block of cells fits under the patch";
  for (int level = deepest_level_of_section; level >= 0; --level) {
    block.cell_size = options.cell_size * std::exp2(level);
    if (level > 0 && block.cell_size > std::min(largest_coarse_cell, options.fine_half_width))
      continue;
    block.half_columns = std::max(
        1,
        contact::count_of(std::ceil(options.fine_half_width / block.cell_size - 1e-9), of_block));
    block.rows =
        2 *
        std::max(
            1, contact::count_of(
                   std::ceil(0.5 * options.fine_depth * options.cell_size / block.cell_size - 1e-9),
                   of_block));
    if (block.half_columns * block.cell_size > room) continue;
    try {
      const auto along =
          meshes::outward_steps(block.cell_size, options.fine_half_length, options.reach_s());
      CoarseBody body = swept_section(meshes::mesh_true_section(outline, block), block, shape,
                                      meshes::points_both_ways(along));
      meshes::check_mesh(body.mesh, "its section");  // free meshing may produce overlapping cells
      const double quality = smallest_scaled_jacobian(body.mesh);
      if (quality > best_quality) {
        best = std::move(body);
        best_quality = quality;
      }
      if (best_quality > good_scaled_jacobian) return best;
    } catch (const contact::InputError& error) {
      complaint = error.what();
    }
  }
  if (best_quality <= 0.0)
    throw contact::InputError(fmt::format(
        "the true section of the {} cannot be meshed with cells of {:.4g} mm under the patch: {}",
        shape.is_wheel ? "wheel" : "rail", options.cell_size, complaint));
  return best;
}

}  // namespace rollfem::fem

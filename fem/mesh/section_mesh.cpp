// SPDX-License-Identifier: LGPL-2.1-or-later
// Coarse meshes of sections, swept along the rail or about the axle: of circles by gmsh, of true
// profiles with the block under the patch as large as fits.
#include "contact/base/count.hpp"
#include "contact/base/errors.hpp"
#include "fem/mesh/coarse_mesh.hpp"
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

/// Sweeps a section (y, z) over the slices: along the rail, or about the axle by these arcs of
/// circles of the given radius.
template <class Radius>
HexMesh swept(const meshes::Section& section, const std::vector<double>& places,
              const SurfaceShape& shape, const Radius& radius) {
  return meshes::sweep(section, places.size(), [&](const auto& p, std::size_t k) {
    const auto at = shape.is_revolved() ? shape.turned_about_axle(p[0], p[1], places[k] / radius(p))
                                        : dealii::Point<3>(places[k], p[0], p[1]);
    return std::array<double, 3>{at[0], at[1], at[2]};
  });
}

/// The faces of the block are rectangles in the chart.
CoarseBody swept_block(const meshes::BlockedSection& blocked, const meshes::SectionBlock& block,
                       const SurfaceShape& shape, const std::vector<double>& places) {
  const double reach = block.half_columns * block.cell_size;
  CoarseBody body = swept(blocked.section, places, shape, [&](const meshes::SectionPoint& p) {
    return shape.streamline_radius(std::clamp(p[0], block.middle - reach, block.middle + reach));
  });
  const std::size_t quads = blocked.section.quads.size();
  for (std::size_t c = 0; c < body.mesh.cells.size(); ++c)
    body.follows_surface.push_back(c % quads < blocked.block_quads);
  return body;
}

}  // namespace

CoarseBody gmsh_mesh(const SurfaceShape& shape, const BodyOptions& options, int level) {
  meshes::SectionOptions section;
  section.drop = [&shape](double y) { return shape.drop_at(y).value; };
  section.half_width = options.reach_t();
  section.depth = options.reach_depth();
  section.fine_half_width = options.fine_half_width;
  section.fine_depth = options.fine_depth * options.cell_size;
  section.half = options.half;
  section.cell_size = options.cell_size * std::exp2(level);
  // The block of equal cells must leave space for the others.
  while (level > 0 && (2 * section.cell_size > 0.4 * section.depth ||
                       section.fine_half_width + 2 * section.cell_size > 0.75 * section.half_width))
    section.cell_size = options.cell_size * std::exp2(--level);
  auto quads = meshes::mesh_section(section);
  if (!shape.is_wheel)
    for (auto& p : quads.points) p[1] = -p[1];
  // Faces stay below cell_size along s also at the largest radius of the patch, and where slices of
  // equal angle are inclined to lines of equal arc length.
  const double width = options.fine_half_width;
  const double lean = std::abs(shape.drop_at(width).slope) * options.fine_half_length /
                      std::abs(shape.rolling_radius);
  const double radius =
      std::max(std::abs(shape.rolling_radius), std::abs(shape.streamline_radius(width))) *
      (1.0 + lean);
  const auto along =
      meshes::outward_steps(section.cell_size, options.fine_half_length, options.reach_s());
  return swept(quads, meshes::points_both_ways(along), shape, [=](const auto&) { return radius; });
}

CoarseBody true_section_mesh(const meshes::TrueSection& outline, const SurfaceShape& shape,
                             const BodyOptions& options) {
  const double room =
      std::min(options.middle - shape.lower_t(), shape.upper_t() - options.middle) + 1e-9;
  meshes::SectionBlock block;
  block.height = [&shape](double t) { return shape.height(t).value; };
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
      CoarseBody body = swept_block(meshes::mesh_true_section(outline, block), block, shape,
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

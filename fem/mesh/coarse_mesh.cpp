// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/mesh/coarse_mesh.hpp"

#include "base/count.hpp"
#include "base/errors.hpp"
#include "fem/mesh/surface_shape.hpp"
#include "meshes/gmsh_sections.hpp"
#include "meshes/hex_mesh.hpp"
#include "meshes/msh_file.hpp"
#include "meshes/segment_mesh.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>

namespace rollfem::meshes {

template <class Archive>
void serialize(Archive& archive, SideQuad& quad, unsigned int /*version*/) {
  archive& quad.corners& quad.side;
}
template <class Archive>
void serialize(Archive& archive, HexMesh& mesh, unsigned int /*version*/) {
  archive& mesh.points& mesh.cells& mesh.sides;
}

}  // namespace rollfem::meshes

namespace rollfem::fem {

template <class Archive>
void serialize(Archive& archive, CoarseBody& body, unsigned int /*version*/) {
  archive& body.mesh& body.follows_surface;
}

namespace {

using meshes::HexMesh;
using meshes::Side;

// Coarse meshes of sections, swept along the rail or about the axle: of circles by gmsh, of true
// profiles with the block under the patch as large as fits.

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

/// deal.II's corner k is gmsh's corner gmsh_corner[k], and the other way round.
constexpr std::array<unsigned int, 8> gmsh_corner{0, 1, 3, 2, 4, 5, 7, 6};

/// In the order of Side.
constexpr std::array<dealii::types::boundary_id, 3> id_of_side{contact_surface, far_boundary,
                                                               symmetry_plane};

/// Allowed distance of contact faces from the surface, as a fraction of the finely meshed region's
/// half size.
constexpr double surface_tolerance = 0.01;

/// Nodes of contact faces, each once.
std::vector<int> contact_nodes(const HexMesh& mesh) {
  std::vector<int> nodes;
  for (const auto& quad : mesh.sides)
    if (quad.side == Side::contact)
      nodes.insert(nodes.end(), quad.corners.begin(), quad.corners.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

dealii::Point<3> as_point(const std::array<double, 3>& p) {
  return {p[0], p[1], p[2]};
}

[[noreturn]] void fail(const std::string& name, const std::string& wrong,
                       const std::string& action) {
  throw contact::InputError(fmt::format("{}: {}; do: {}", name, wrong, action));
}

const char* const frame_advice =
    "the mesh is in mm with the contact point at the origin, x along rolling, y lateral, z into "
    "the wheel (which lies at z > 0, the rail at z < 0)";

/// A mesh in metres or inches is far too small or large compared with the patch and the wheel.
void check_size(const HexMesh& mesh, const std::string& name, const SurfaceShape& shape,
                const BodyOptions& options) {
  auto lower = mesh.points.front(), upper = lower;
  for (const auto& p : mesh.points)
    for (int d = 0; d < 3; ++d) {
      lower[d] = std::min(lower[d], p[d]);
      upper[d] = std::max(upper[d], p[d]);
    }
  const double size = std::hypot(upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]);
  const double patch = std::hypot(options.fine_half_length, options.fine_half_width);
  if (size < 2.0 * patch)
    fail(name,
         fmt::format("is only {:.4g} mm large, but the contact patch alone needs {:.4g} mm", size,
                     2.0 * patch),
         "give coordinates in mm (multiply a mesh in metres by 1000)");
  const double radius = std::abs(shape.rolling_radius);
  const double largest = shape.is_revolved() ? 8.0 * radius : 2000.0 * patch;
  if (size > largest)
    fail(name,
         fmt::format("is {:.4g} mm large, far beyond {}", size,
                     shape.is_revolved() ? fmt::format("a {} of radius {:.4g} mm",
                                                       shape.is_wheel ? "wheel" : "roller", radius)
                                         : fmt::format("a patch of {:.4g} mm", patch)),
         "give coordinates in mm");
}

/// Moves nodes of contact faces onto the surface if they are close to it.
void project(HexMesh& mesh, const std::string& name, const SurfaceShape& shape,
             const BodyOptions& options) {
  const double tolerance =
      surface_tolerance * std::max(options.fine_half_length, options.fine_half_width);
  double worst = 0.0;
  int worst_node = -1;
  for (const int node : contact_nodes(mesh)) {
    auto chart = shape.coordinates(as_point(mesh.points[node]));
    if (std::abs(chart[2]) > worst) {
      worst = std::abs(chart[2]);
      worst_node = node;
    }
    chart[2] = 0.0;
    const auto p = shape.place(chart[0], chart[1], chart[2]);
    if (worst <= tolerance) mesh.points[node] = {p[0], p[1], p[2]};
  }
  if (worst > tolerance) {
    const auto& p = mesh.points[worst_node];
    fail(name,
         fmt::format("a node of the group `contact` at ({:.5g}, {:.5g}, {:.5g}) mm is {:.3g} mm "
                     "away from the surface of the case; allowed: {:.3g} mm",
                     p[0], p[1], p[2], worst, tolerance),
         fmt::format("mesh the true profile and put only the running surface into `contact`; {}",
                     frame_advice));
  }
}

/// Whether the contact faces surround the patch.
void check_covers_patch(const HexMesh& mesh, const std::string& name, const SurfaceShape& shape,
                        const BodyOptions& options) {
  std::array<double, 2> lower{HUGE_VAL, HUGE_VAL}, upper{-HUGE_VAL, -HUGE_VAL};
  for (const int node : contact_nodes(mesh)) {
    const auto chart = shape.coordinates(as_point(mesh.points[node]));
    for (int d = 0; d < 2; ++d) {
      lower[d] = std::min(lower[d], chart[d]);
      upper[d] = std::max(upper[d], chart[d]);
    }
  }
  const std::array<double, 2> needed{options.fine_half_length, options.fine_half_width};
  const bool covered = lower[0] <= -needed[0] && upper[0] >= needed[0] &&
                       upper[1] >= options.middle + needed[1] &&
                       lower[1] <= (options.half ? 1e-6 : options.middle - needed[1]);
  if (!covered)
    fail(name,
         fmt::format(
             "its group `contact` covers x = {:.4g} to {:.4g} mm and y = {:.4g} to {:.4g} mm; the "
             "contact needs {:.4g} mm along x and {:.4g} mm along y to each side of (0, {:.4g}) mm",
             lower[0], upper[0], lower[1], upper[1], needed[0], needed[1], options.middle),
         fmt::format("enlarge the contact group or move the mesh: {}", frame_advice));
}

/// A half body lies at y >= 0 and its symmetry faces at y = 0.
void check_symmetry(const HexMesh& mesh, const std::string& name, const BodyOptions& options) {
  const double tolerance = 1e-6 * options.fine_half_width;
  bool half = false;
  for (const auto& quad : mesh.sides) {
    if (quad.side != Side::symmetry) continue;
    half = true;
    for (const int corner : quad.corners)
      if (std::abs(mesh.points[corner][1]) > tolerance)
        fail(name,
             fmt::format("a node of the group `symmetry` lies at y = {:.4g} mm",
                         mesh.points[corner][1]),
             "put only faces on the plane y = 0 into `symmetry`");
  }
  if (!half) return;
  for (const auto& p : mesh.points)
    if (p[1] < -tolerance)
      fail(name,
           fmt::format("it has a group `symmetry` and a node at y = {:.4g} mm, on the other side",
                       p[1]),
           "mesh the half y >= 0, or remove the group");
}

/// Whether the chart is one to one over a cell. Around a whole wheel it is not: behind the axle
/// cells stay straight.
bool is_charted(const SurfaceShape& shape, const dealii::CellAccessor<3>& cell) {
  if (!shape.is_revolved()) return true;
  for (const unsigned int v : cell.vertex_indices()) {
    const auto chart = shape.coordinates(cell.vertex(v));
    if (!(std::abs(chart[0]) < 1.5 * std::abs(shape.streamline_radius(chart[1])) &&
          chart[2] < 0.8 * std::abs(shape.rolling_radius)))
      return false;
  }
  return true;
}

constexpr dealii::types::manifold_id on_surface = 0, about_axle = 1;

/// Faces between both kinds of cells belong to the cells at the surface.
void set_manifolds(const SurfaceShape& shape, const GradedDepth& rows,
                   const std::vector<bool>& follows_surface,
                   dealii::Triangulation<3>& triangulation) {
  const bool everywhere = follows_surface.empty();
  if (!everywhere && shape.is_revolved() && shape.profile) {
    triangulation.set_all_manifold_ids(about_axle);
    triangulation.set_manifold(about_axle, axle_manifold(shape));
  }
  triangulation.set_manifold(on_surface, surface_manifold(shape, rows));
  for (const auto& cell : triangulation.cell_iterators_on_level(0))
    if (everywhere ? is_charted(shape, *cell)
                   : follows_surface[static_cast<std::size_t>(cell->index())])
      cell->set_all_manifold_ids(on_surface);
}

}  // namespace

CoarseBody gmsh_mesh(const SurfaceShape& shape, const BodyOptions& options, int level) {
  meshes::SectionOptions section;
  section.drop = [&shape](double y) { return shape.drop_at(y).value; };
  section.half_width = options.reach_t();
  section.depth = options.reach_depth();
  section.fine_half_width = options.fine_half_width;
  section.fine_depth = options.fine_depth * options.cell_size;
  section.row_depth = [&options](double even) { return options.rows.depth(even); };
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
  block.row_depth = [&options](double even) { return options.rows.depth(even); };
  block.middle = options.middle;
  const double most_rows =
      options.rows.equal_rows() ? contact::infinity : options.rows.step() * (1.0 + 1e-9);
  CoarseBody best;
  double best_quality = 0.0;
  std::string complaint = "no block of cells fits under the patch";
  for (int level = deepest_level_of_section; level >= 0; --level) {
    block.cell_size = options.cell_size * std::exp2(level);
    if (level > 0 &&
        block.cell_size > std::min({largest_coarse_cell, options.fine_half_width, most_rows}))
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

CoarseBody on_all_processes(MPI_Comm communicator, const std::function<CoarseBody()>& make) {
  CoarseBody body;
  std::string refusal;
  if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0) {
    try {
      body = make();
    } catch (const contact::InputError& error) {
      refusal = error.what();
    }
  }
  refusal = dealii::Utilities::MPI::broadcast(communicator, refusal, 0);
  if (!refusal.empty()) throw contact::InputError(refusal);
  return dealii::Utilities::MPI::broadcast(communicator, body, 0);
}

CoarseBody user_mesh(const std::string& path, const std::string& name, const SurfaceShape& shape,
                     const BodyOptions& options) {
  HexMesh mesh = meshes::read_msh(path, name);
  if (!mesh.points.empty()) check_size(mesh, name, shape, options);
  meshes::check_mesh(mesh, name);
  check_symmetry(mesh, name, options);
  project(mesh, name, shape, options);
  BodyOptions own = options;
  own.half = mesh.half();
  check_covers_patch(mesh, name, shape, own);
  return mesh;
}

void create_triangulation(const CoarseBody& coarse, const SurfaceShape& shape,
                          const GradedDepth& rows, dealii::Triangulation<3>& triangulation) {
  std::vector<dealii::Point<3>> points;
  for (const auto& p : coarse.mesh.points) points.push_back(as_point(p));
  std::vector<dealii::CellData<3>> cells;
  for (const auto& corners : coarse.mesh.cells) {
    dealii::CellData<3>& cell = cells.emplace_back();
    for (unsigned int k = 0; k < 8; ++k) cell.vertices[k] = corners[gmsh_corner[k]];
  }
  dealii::SubCellData sides;
  for (const auto& quad : coarse.mesh.sides) {
    dealii::CellData<2>& side = sides.boundary_quads.emplace_back();
    std::copy(quad.corners.begin(), quad.corners.end(), side.vertices.begin());
    side.boundary_id = id_of_side[static_cast<std::size_t>(quad.side)];
  }
  dealii::GridTools::consistently_order_cells(cells);
  triangulation.create_triangulation(points, cells, sides);
  set_manifolds(shape, rows, coarse.follows_surface, triangulation);
}

HexMesh hex_mesh(const dealii::Triangulation<3>& triangulation) {
  HexMesh mesh;
  std::map<unsigned int, int> number;
  const auto node = [&](unsigned int vertex, const dealii::Point<3>& p) {
    const auto [it, is_new] = number.try_emplace(vertex, static_cast<int>(mesh.points.size()));
    if (is_new) mesh.points.push_back({p[0], p[1], p[2]});
    return it->second;
  };
  for (const auto& cell : triangulation.cell_iterators_on_level(0)) {
    std::array<int, 8> corners{};
    for (unsigned int k = 0; k < 8; ++k)
      corners[gmsh_corner[k]] = node(cell->vertex_index(k), cell->vertex(k));
    mesh.cells.push_back(corners);
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary() || face->boundary_id() == free_surface) continue;
      const auto at = [&](unsigned int k) { return node(face->vertex_index(k), face->vertex(k)); };
      const auto id = std::find(id_of_side.begin(), id_of_side.end(), face->boundary_id());
      mesh.sides.push_back(
          {{at(0), at(1), at(3), at(2)}, static_cast<Side>(id - id_of_side.begin())});
    }
  }
  return mesh;
}

}  // namespace rollfem::fem

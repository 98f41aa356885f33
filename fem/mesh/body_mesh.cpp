// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/mesh/body_mesh.hpp"

#include "base/errors.hpp"
#include "fem/mesh/coarse_mesh.hpp"
#include "meshes/segment_mesh.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace rollfem::fem {

namespace {

/// Octrees much deeper than this over many coarse cells make multigrid set-up slow and wrong.
constexpr int deepest_level = 5;
/// A given mesh may be coarser.
constexpr int deepest_level_of_given_mesh = 7;

void check_sizes(const BodyOptions& options) {
  if (!(options.cell_size > 0) || !(options.growth > 0) || options.degree < 1)
    throw contact::InputError("fem: cell_size, growth and degree must be positive");
}

void check(const SurfaceShape& shape, const BodyOptions& options) {
  check_sizes(options);
  if (!(std::min({options.reach_s(), options.reach_t(), options.reach_depth()}) > 0))
    throw contact::InputError("fem: extent, width, depth and length must be positive");
  const auto needs = [](const char* key, double given, double needed) {
    if (!(needed <= given))
      throw contact::InputError(
          fmt::format("fem.{} extends the segment by {:.4g} mm to one side, less than the finely "
                      "meshed region needs ({:.4g} mm): enlarge it",
                      key, given, needed));
  };
  needs(options.half_length ? "length" : "extent", options.reach_s(), options.fine_half_length);
  needs(options.half_width ? "width" : "extent", options.reach_t(), options.fine_half_width);
  needs(options.depth ? "depth" : "extent", options.reach_depth(),
        options.rows.depth(options.fine_depth * options.cell_size));
  if (options.middle - options.fine_half_width < shape.lower_t() - 1e-9 ||
      options.middle + options.fine_half_width > shape.upper_t() + 1e-9)
    throw contact::InputError(
        fmt::format("fem: the finely meshed region extends from y = {:.4g} to {:.4g} mm; the "
                    "profile of the {} can be meshed from {:.4g} to {:.4g} mm (beyond that it ends "
                    "or is steeper than {}): give a smaller [fem] fine_extent",
                    options.middle - options.fine_half_width,
                    options.middle + options.fine_half_width, shape.is_wheel ? "wheel" : "rail",
                    shape.lower_t(), shape.upper_t(), ProfileShape::steepest));
  const double inwards = shape.drop_at(options.reach_t()).value + options.reach_depth();
  const double radius = std::abs(shape.rolling_radius), most = 0.7 * radius;
  const auto holds = [&](const char* key, double given) {
    if (!(given <= most))
      throw contact::InputError(fmt::format(
          "fem.{} extends the segment by {:.4g} mm, and a {} of radius {} mm has room for {:.4g} "
          "mm before the axle: give a smaller one",
          key, given, shape.is_wheel ? "wheel" : "roller", radius, most));
  };
  holds(options.half_length ? "length" : "extent", options.reach_s());
  holds(options.depth ? "depth" : options.half_width ? "width" : "extent", inwards);
}

double sum(const std::vector<double>& steps) {
  return std::accumulate(steps.begin(), steps.end(), 0.0);
}

std::vector<double> reversed(std::vector<double> steps) {
  std::reverse(steps.begin(), steps.end());
  return steps;
}

std::vector<double> both_ways(const std::vector<double>& outward) {
  auto steps = reversed(outward);
  steps.insert(steps.end(), outward.begin(), outward.end());
  return steps;
}

void mark_boundaries(const BodyOptions& options, Triangulation& mesh) {
  for (const auto& cell : mesh.active_cell_iterators())
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary()) continue;
      const auto centre = face->center();
      if (std::abs(centre[2]) < 1e-9)
        face->set_boundary_id(contact_surface);
      else if (options.half && std::abs(centre[1]) < 1e-9)
        face->set_boundary_id(symmetry_plane);
      else
        face->set_boundary_id(far_boundary);
    }
}

/// The coarse box in (s, t, w), w = even depth for the wheel and minus that for the rail so that
/// cells stay right-handed, then mapped to space.
void make_structured_mesh(const SurfaceShape& shape, const BodyOptions& options,
                          Triangulation& mesh) {
  const double first = options.cell_size * std::exp2(coarse_level(options));
  using meshes::outward_steps;
  const auto along = outward_steps(first, options.fine_half_length, options.reach_s());
  const auto across = outward_steps(first, options.fine_half_width, options.reach_t());
  const auto down = outward_steps(first, options.fine_depth * options.cell_size,
                                  options.rows.even(options.reach_depth()));
  const std::vector<std::vector<double>> steps{both_ways(along),
                                               options.half ? across : both_ways(across),
                                               shape.is_wheel ? down : reversed(down)};
  const double middle = options.middle;
  const dealii::Point<3> lower(-sum(along), options.half ? 0.0 : middle - sum(across),
                               shape.is_wheel ? 0.0 : -sum(down));
  const dealii::Point<3> upper(sum(along), middle + sum(across), shape.is_wheel ? sum(down) : 0.0);
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, steps, lower, upper);
  mark_boundaries(options, mesh);
  dealii::GridTools::transform(
      [&](const dealii::Point<3>& p) {
        return shape.place(p[0], p[1], options.rows.depth(std::abs(p[2])));
      },
      mesh);
  mesh.set_all_manifold_ids(0);
  mesh.set_manifold(0, surface_manifold(shape, options.rows));
}

/// Distance between a cell and the fine region in even depth, 0 where they touch or overlap.
double distance_to_fine_region(const BodyOptions& options, const ChartBox& box) {
  const double fine[3] = {options.fine_half_length, options.fine_half_width,
                          options.fine_depth * options.cell_size};
  const double middle[3] = {0.0, options.middle, 0.0};
  double squared = 0.0;
  for (unsigned int d = 0; d < 3; ++d) {
    const double gap =
        std::max({0.0, box.lower[d] - middle[d] - fine[d], middle[d] - fine[d] - box.upper[d]});
    squared += gap * gap;
  }
  return std::sqrt(squared);
}

/// One pass over the mesh; whether any cell on any process was refined.
bool refine_once(const SurfaceShape& shape, const BodyOptions& options, Triangulation& mesh) {
  int flagged = 0;
  for (const auto& cell : mesh.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    ChartBox box = chart_box(shape, cell);
    // Thin rows are as long and wide as others; cells of sections beside them have no rows.
    double size = 0.0;
    for (unsigned int d = 0; d < 3; ++d) size = std::max(size, box.upper[d] - box.lower[d]);
    for (auto* corner : {&box.lower, &box.upper}) (*corner)[2] = options.rows.even((*corner)[2]);
    const double distance = distance_to_fine_region(options, box);
    if (size <= 1.001 * (options.cell_size + options.growth * distance)) continue;
    cell->set_refine_flag();
    ++flagged;
  }
  if (dealii::Utilities::MPI::max(flagged, mesh.get_communicator()) == 0) return false;
  mesh.execute_coarsening_and_refinement();
  return true;
}

void refine_towards_patch(const SurfaceShape& shape, const BodyOptions& options, int levels,
                          Triangulation& mesh) {
  for (int step = 0; step < levels; ++step)
    if (!refine_once(shape, options, mesh)) return;
}

void refine_given_mesh(const SurfaceShape& shape, const BodyOptions& options, Triangulation& mesh) {
  for (int step = 0; step <= deepest_level_of_given_mesh; ++step)
    if (!refine_once(shape, options, mesh)) return;
  throw contact::InputError(fmt::format(
      "the mesh is too coarse at the contact: its cells would have to be halved more than {} times "
      "to reach the cell size of {:.4g} mm: make it finer there, or enlarge [fem] cell_size",
      deepest_level_of_given_mesh, options.cell_size));
}

void check_refined_cells(const dealii::Mapping<3>& mapping, const Triangulation& mesh) {
  const dealii::FE_Q<3> element(1);
  dealii::FEValues<3> values(mapping, element, dealii::QGauss<3>(3), dealii::update_jacobians);
  int inside_out = 0;
  for (const auto& cell : mesh.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    values.reinit(cell);
    for (const unsigned int q : values.quadrature_point_indices())
      if (!(values.jacobian(q).determinant() > 0)) {
        ++inside_out;
        break;
      }
  }
  inside_out = dealii::Utilities::MPI::sum(inside_out, mesh.get_communicator());
  if (inside_out > 0)
    throw contact::InputError(fmt::format(
        "{} refined cells of the mesh are inverted when its contact surface is moved onto the true "
        "one: smooth the mesh below the contact surface, or make it finer",
        inside_out));
}

/// Number of cells created by refine_towards_patch from a box, without the additional cells from
/// octree balance and the bending of the chart.
double cells_of(const BodyOptions& options, const ChartBox& box, int depth, double enough) {
  double size = 0.0;
  for (unsigned int d = 0; d < 3; ++d) size = std::max(size, box.upper[d] - box.lower[d]);
  const double distance = distance_to_fine_region(options, box);
  if (depth == 0 || size <= 1.001 * (options.cell_size + options.growth * distance)) return 1.0;
  double sum = 0.0;
  for (unsigned int child = 0; child < 8 && sum < enough; ++child) {
    ChartBox part = box;
    for (unsigned int d = 0; d < 3; ++d) {
      const double middle = 0.5 * (box.lower[d] + box.upper[d]);
      ((child >> d & 1U) != 0 ? part.lower[d] : part.upper[d]) = middle;
    }
    sum += cells_of(options, part, depth - 1, enough);
  }
  return sum;
}

}  // namespace

/// Coarse cells are cubes of cell_size * 2^level near the patch, below thin rows flatter ones.
int coarse_level(const BodyOptions& options) {
  double largest = std::min({options.reach_s(), options.reach_t(), options.reach_depth()}) / 6;
  if (!options.rows.equal_rows()) largest = std::min(largest, options.rows.step());
  int level = 0;
  while (level < deepest_level && options.cell_size * std::exp2(level + 1) <= largest) ++level;
  return level;
}

double predicted_unknowns(const BodyOptions& given, double enough) {
  BodyOptions options = given;
  options.middle = 0.0;  // a body and its mirror image are counted as one
  const int depth = coarse_level(options);
  const double first = options.cell_size * std::exp2(depth);
  const std::vector<double> steps[3] = {
      meshes::outward_steps(first, options.fine_half_length, options.reach_s()),
      meshes::outward_steps(first, options.fine_half_width, options.reach_t()),
      meshes::outward_steps(first, options.fine_depth * options.cell_size,
                            options.rows.even(options.reach_depth()))};
  // degree^3 nodes per cell in a large mesh; the outside, steps between cell sizes and octree
  // balance add a quarter (measured from 1.88 to 0.47 mm on case a: 0.79 to 0.81 without).
  const double of_cell = 1.25 * 3.0 * std::pow(options.degree, 3);
  const double mirrored = options.half ? 2.0 : 4.0;
  double cells = 0.0;
  dealii::Point<3> upper;
  const auto next = [&](unsigned int d, double step) {
    return std::exchange(upper[d], upper[d] + step);
  };
  for (const double along : steps[0]) {
    const double x = next(0, along);
    upper[1] = 0.0;
    for (const double across : steps[1]) {
      const double y = next(1, across);
      upper[2] = 0.0;
      for (const double down : steps[2]) {
        const double z = next(2, down);
        cells += cells_of(options, {{x, y, z}, upper}, depth, enough / (mirrored * of_cell));
        if (mirrored * of_cell * cells > enough) return mirrored * of_cell * cells;
      }
    }
  }
  return mirrored * of_cell * cells;
}

void make_mesh(const SurfaceShape& shape, const BodyOptions& options, Triangulation& mesh) {
  check(shape, options);
  const int level = coarse_level(options);
  if (options.family == MeshFamily::gmsh) {
    const auto make = [&] { return gmsh_mesh(shape, options, level); };
    create_triangulation(on_all_processes(mesh.get_communicator(), make), shape, options.rows,
                         mesh);
    refine_given_mesh(shape, options, mesh);
  } else {
    make_structured_mesh(shape, options, mesh);
    refine_towards_patch(shape, options, level, mesh);
  }
}

void refine_coarse_mesh(const SurfaceShape& shape, const BodyOptions& options,
                        const CoarseBody& coarse, const dealii::Mapping<3>& mapping,
                        Triangulation& mesh) {
  check_sizes(options);
  create_triangulation(coarse, shape, options.rows, mesh);
  refine_given_mesh(shape, options, mesh);
  check_refined_cells(mapping, mesh);
}

}  // namespace rollfem::fem

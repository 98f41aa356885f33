// Meshing of a body: a graded coarse box in chart coordinates, octree refinement towards the patch,
// then degrees of freedom and constraints.
#include "fem/body.hpp"

#include "contact/errors.hpp"
#include "fem/chart.hpp"
#include "fem/rolling_inertia.hpp"

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rollfem::fem {

namespace {

using Triangulation = dealii::parallel::distributed::Triangulation<3>;

/// Octrees much deeper than this over many coarse cells make multigrid set-up slow and wrong.
constexpr int deepest_level = 5;
constexpr double coarse_growth = 1.5;

void check(const SurfaceShape& shape, const BodyOptions& options) {
  if (!(options.cell_size > 0) || !(options.extent > 0) || !(options.growth > 0) ||
      options.degree < 1)
    throw contact::InputError("fem: cell_size, extent, growth and degree must be positive");
  const double fine = std::max(options.fine_half_length, options.fine_half_width);
  if (!(fine <= options.extent))
    throw contact::InputError(fmt::format(
        "fem.extent = {} mm is less than the finely meshed region needs ({} mm): enlarge it",
        options.extent, fine));
  const double inwards =
      contact::profile_drop(shape.transverse_radius, options.extent).value + options.extent;
  if (shape.is_wheel && !(std::max(inwards, options.extent) <= 0.7 * shape.rolling_radius))
    throw contact::InputError(fmt::format(
        "fem.extent = {} mm is too much for a wheel of radius {} mm: the segment would reach the "
        "axle; take at most {:.4g} mm",
        options.extent, shape.rolling_radius, 0.5 * shape.rolling_radius));
}

/// Coarse cells are cubes of cell_size * 2^level near the patch.
int coarse_level(const BodyOptions& options) {
  int level = 0;
  while (level < deepest_level && options.cell_size * std::exp2(level + 1) <= options.extent / 6)
    ++level;
  return level;
}

/// Steps from 0 outwards: equal ones over the fine region, then growing to the far boundary.
std::vector<double> outward_steps(double first, double fine, double extent) {
  const int equal = std::max(1, static_cast<int>(std::ceil(fine / first - 1e-9)));
  std::vector<double> steps(equal, first);
  const double rest = extent - equal * first;
  if (rest < 0.5 * first) return steps;
  std::vector<double> growing;
  double sum = 0.0;
  for (double step = first * coarse_growth; sum < rest; step *= coarse_growth) {
    // A last step that would have to shrink by half is left out and the others are stretched.
    if (!growing.empty() && sum + 0.5 * step > rest) break;
    growing.push_back(step);
    sum += step;
  }
  for (const double step : growing) steps.push_back(step * rest / sum);
  return steps;
}

double sum(const std::vector<double>& steps) {
  double total = 0.0;
  for (const double step : steps) total += step;
  return total;
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

/// The coarse box in (s, t, w), w = depth for the wheel and -depth for the rail so that cells stay
/// right-handed, then placed in space.
void make_coarse_mesh(const SurfaceShape& shape, const BodyOptions& options, Triangulation& mesh) {
  const double first = options.cell_size * std::exp2(coarse_level(options));
  const auto along = outward_steps(first, options.fine_half_length, options.extent);
  const auto across = outward_steps(first, options.fine_half_width, options.extent);
  const auto down = outward_steps(first, options.fine_depth * options.cell_size, options.extent);
  const std::vector<std::vector<double>> steps{both_ways(along),
                                               options.half ? across : both_ways(across),
                                               shape.is_wheel ? down : reversed(down)};
  const dealii::Point<3> lower(-sum(along), options.half ? 0.0 : -sum(across),
                               shape.is_wheel ? 0.0 : -sum(down));
  const dealii::Point<3> upper(sum(along), sum(across), shape.is_wheel ? sum(down) : 0.0);
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, steps, lower, upper);
  mark_boundaries(options, mesh);
  dealii::GridTools::transform(
      [&shape](const dealii::Point<3>& p) { return shape.place(p[0], p[1], std::abs(p[2])); },
      mesh);
  mesh.set_all_manifold_ids(0);
  mesh.set_manifold(0, SurfaceManifold(shape));
}

/// Distance between a cell and the fine region, 0 where they touch or overlap.
double distance_to_fine_region(const BodyOptions& options, const ChartBox& box) {
  const double fine[3] = {options.fine_half_length, options.fine_half_width,
                          options.fine_depth * options.cell_size};
  double squared = 0.0;
  for (unsigned int d = 0; d < 3; ++d) {
    const double gap = std::max({0.0, box.lower[d] - fine[d], -fine[d] - box.upper[d]});
    squared += gap * gap;
  }
  return std::sqrt(squared);
}

void refine_towards_patch(const SurfaceShape& shape, const BodyOptions& options,
                          Triangulation& mesh) {
  for (int step = 0; step < coarse_level(options); ++step) {
    for (const auto& cell : mesh.active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      const auto box = chart_box(shape, cell);
      double size = 0.0;
      for (unsigned int d = 0; d < 3; ++d) size = std::max(size, box.upper[d] - box.lower[d]);
      const double distance = distance_to_fine_region(options, box);
      if (size > 1.001 * (options.cell_size + options.growth * distance)) cell->set_refine_flag();
    }
    mesh.execute_coarsening_and_refinement();
  }
}

BoundaryConditions boundary_conditions(const BodyOptions& options) {
  BoundaryConditions conditions;
  conditions.clamped = {far_boundary};
  if (options.half) conditions.vanishing_component = {{symmetry_plane, 1}};
  return conditions;
}

/// Cells that refine_towards_patch makes of a box, but for what octree balance and the bending of
/// the chart add.
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

double predicted_unknowns(const BodyOptions& options, double enough) {
  const int depth = coarse_level(options);
  const double first = options.cell_size * std::exp2(depth);
  const std::vector<double> steps[3] = {
      outward_steps(first, options.fine_half_length, options.extent),
      outward_steps(first, options.fine_half_width, options.extent),
      outward_steps(first, options.fine_depth * options.cell_size, options.extent)};
  // degree^3 nodes a cell in a large mesh; the outside, steps between cell sizes and octree balance
  // add a quarter (measured from 1.88 to 0.47 mm on case a: 0.79 to 0.81 without).
  const double of_cell = 1.25 * 3.0 * std::pow(options.degree, 3);
  const double mirrored = options.half ? 2.0 : 4.0;
  double cells = 0.0;
  ChartBox box;
  box.lower[0] = 0.0;
  for (const double along : steps[0]) {
    box.upper[0] = box.lower[0] + along;
    box.lower[1] = 0.0;
    for (const double across : steps[1]) {
      box.upper[1] = box.lower[1] + across;
      box.lower[2] = 0.0;
      for (const double down : steps[2]) {
        box.upper[2] = box.lower[2] + down;
        cells += cells_of(options, box, depth, enough / (mirrored * of_cell));
        if (mirrored * of_cell * cells > enough) return mirrored * of_cell * cells;
        box.lower[2] = box.upper[2];
      }
      box.lower[1] = box.upper[1];
    }
    box.lower[0] = box.upper[0];
  }
  return mirrored * of_cell * cells;
}

Body::Body(const SurfaceShape& shape, const contact::Material& material, const BodyOptions& options,
           MPI_Comm communicator)
    : shape_(shape),
      material_(material),
      options_(options),
      boundary_(boundary_conditions(options)),
      triangulation_(communicator),
      mapping_(std::max(2, options.degree)),
      dofs_(triangulation_) {
  check(shape, options);
  make_coarse_mesh(shape, options, triangulation_);
  refine_towards_patch(shape, options, triangulation_);
  dofs_.distribute_dofs(dealii::FESystem<3>(dealii::FE_Q<3>(options.degree), 3));
  constraints_ = make_constraints(dofs_, mapping_, boundary_);
}

ElasticProblem Body::problem() const {
  return {dofs_,     mapping_,  constraints_,
          boundary_, material_, material_motion(shape_, options_.speed)};
}

}  // namespace rollfem::fem

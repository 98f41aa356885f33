// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/elasticity/run_level.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/progress.hpp"
#include "contact/result/derived.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/solve/contact_run.hpp"
#include "contact/solve/side_by_side.hpp"
#include "contact/solve/state_record.hpp"
#include "fem/elasticity/fem_elasticity.hpp"
#include "fem/mesh/run_layout.hpp"
#include "fem/plasticity/pass_results.hpp"
#include "halfspace/patch/coverage.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace rollfem::fem {

namespace {

using contact::PointResult;
using contact::Scene;

/// Every outer iteration solves each body, so the tolerance matches the accuracy of the elements.
constexpr contact::ContactAccuracy fem_accuracy{1e-6, {1e-4, 40, 3}};
/// Tolerance of a prescribed force, relative to mu F_z.
constexpr double force_tolerance = 1e-5;

[[noreturn]] void refuse_border(const Scene& scene, const contact::ChartedGeometry& geometry,
                                const contact::ContactGrid& grid) {
  const double border = geometry.lateral_place(grid.y(grid.ny - 1));
  const std::string why = contact::why_flanks_touch(scene.geometry, border);
  if (!why.empty()) throw contact::SolveError(why);
  throw contact::SolveError(fmt::format(
      "the contact patch reaches the border of the potential contact area ({:.3g} x {:.3g} mm): {}",
      grid.nx * grid.dx, grid.ny * grid.dy,
      scene.contact_grid.extent ? "give a larger contact_grid.extent"
                                : "the segments are too compliant for their size; give a larger "
                                  "[fem] extent"));
}

void refuse_further_patches(const Scene& scene, const contact::ChartedGeometry& geometry,
                            const contact::ContactGrid& grid,
                            const std::vector<PointResult>& points) {
  const halfspace::PatchSearch area(scene);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto beyond =
        halfspace::touched_beyond(scene, geometry, area, grid, points[k], scene.points[k].load);
    if (!beyond) continue;
    const double lower = std::min((*beyond)[0], grid.y(0)) - grid.dy;
    const double upper = std::max((*beyond)[1], grid.y(grid.ny - 1)) + grid.dy;
    throw contact::SolveError(fmt::format(
        "{}: {}wheel and rail also touch between y = {:.4g} and {:.4g} mm, beyond the potential "
        "contact area from {:.4g} to {:.4g} mm; do: give contact_grid.extent = [{:.3g}, {:.3g}] "
        "and middle = [0, {:.3g}]",
        scene.file, scene.patch_prefix(), (*beyond)[0], (*beyond)[1], grid.y(0) - 0.5 * grid.dy,
        grid.y(grid.ny - 1) + 0.5 * grid.dy, grid.nx * grid.dx, 1.1 * (upper - lower),
        0.5 * (lower + upper)));
  }
}

/// The part of the first process: everything except the collective work of FemElasticity.
void solve_contact(const Scene& scene, const contact::ChartedGeometry& geometry,
                   const RunLayout& layout, const LevelOptions& options,
                   const contact::Progress& progress, const FemElasticity& elasticity,
                   contact::ModelResult& result) {
  // Load points with the states from which the next ones start, so that numbers of a resumed run
  // are the same to the last bit.
  const std::string name = fmt::format("fem-{:.9g}mm", options.cell_size);
  contact::Response first_defect;
  /// Writes or reads the frictionless solution and the data of the level as a whole.
  const auto start = [&](contact::Record& record) {
    record.values(first_defect, result.contact_elements, result.unknowns, result.notes,
                  result.bodies);
    record.demand(first_defect.displacement.x.size() == first_defect.displacement.n.size());
  };
  const contact::ModelResult before = result;
  const bool stored =
      options.checkpoint != nullptr &&
      contact::found(*options.checkpoint, name + "-normal", start, layout.grid.size());
  if (!stored) {
    result = before;
    first_defect = {};
  }
  contact::RunOptions run_options;
  run_options.model = "fem";
  run_options.stage_prefix = options.stage_prefix;
  run_options.accuracy = run_options.force_accuracy = fem_accuracy;
  run_options.force_tolerance = force_tolerance;
  run_options.independent = !scene.is_history() && !scene.load_changes() && !scene.yields();
  const auto make = [&] { return elasticity.beside(); };
  std::optional<contact::PointStore> store;
  // What several processes know of bodies that yield is not collected.
  const bool collected =
      !scene.yields() || dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
  if (options.checkpoint != nullptr && collected) store.emplace(*options.checkpoint, name, stored);
  if (!stored) {
    contact::ContactRun run(scene, geometry, run_options, progress, nullptr);
    run.on_first_defect = [&](const contact::Response& defect, int contact_elements) {
      first_defect = defect;
      result.contact_elements = contact_elements;
      if (options.checkpoint == nullptr) return;
      contact::Record record;
      start(record);
      options.checkpoint->keep(name + "-normal", record.bytes());
    };
    run.solve_without_friction(layout.grid, make);
    result.seconds["normal"] = run.take_result().normal_seconds;
  }
  run_options.first_defect = first_defect;
  run_options.most_beside = elasticity.most_beside();
  auto solved = contact::solve_points(scene, geometry, run_options, progress,
                                      store ? &*store : nullptr, layout.grid, make);
  if (!solved) refuse_border(scene, geometry, layout.grid);
  contact::LevelResult level = *std::move(solved);
  refuse_further_patches(scene, geometry, layout.grid, level.points);
  if (std::string note = contact::steep_friction_note(level, scene.friction()); !note.empty())
    result.notes.push_back(std::move(note));
  result.points = std::move(level.points);
  for (const contact::YieldedSection& section : result.points.back().yielded)
    result.notes.push_back(verdict_note(section, static_cast<int>(result.points.size())));
  result.seconds["normal"] += level.normal_seconds;
  result.seconds["tangential"] = level.tangential_seconds;
}

}  // namespace

contact::ModelResult run_level(const Scene& scene, const LevelOptions& options,
                               const contact::Progress& progress) {
  const RunLayout layout = run_layout(scene, options.cell_size);
  const contact::ChartedGeometry geometry(scene.geometry, contact::Chart::projected);
  contact::ModelResult result;
  result.name = "fem";
  result.grid = layout.grid;
  FirstProcess first(MPI_COMM_WORLD);
  const auto elasticity =
      make_fem_elasticity(scene, geometry, layout, options, progress, first, result);
  first.run([&] { solve_contact(scene, geometry, layout, options, progress, *elasticity, result); },
            [&](const FirstProcess::Order& order) { elasticity->obey(order); });
  contact::place_pass_work(geometry, scene.place, result);
  return result;
}

}  // namespace rollfem::fem

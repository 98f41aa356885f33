// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/elasticity/run_level.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/progress.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/solve/contact_run.hpp"
#include "contact/solve/state_record.hpp"
#include "fem/elasticity/fem_elasticity.hpp"
#include "fem/mesh/run_layout.hpp"
#include "fem/trace/far_error.hpp"
#include "halfspace/patch/coverage.hpp"

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

void exchange(contact::Record& record, LevelStart& start) {
  record.values(start.defect, start.contact_elements, start.unknowns, start.solver);
  record.values(start.reach, start.half, start.notes, start.bodies);
}

/// False when nothing is stored; the start is then unchanged.
bool find_start(contact::Checkpoint* checkpoint, const std::string& name, LevelStart& start) {
  const auto bytes = checkpoint == nullptr ? std::nullopt : checkpoint->find(name);
  if (!bytes) return false;
  contact::Record record(*bytes);
  exchange(record, start);
  return true;
}

void add_notes(const Scene& scene, const contact::ChartedGeometry& geometry,
               const RunLayout& layout, const LevelStart& start, contact::ModelResult& result) {
  result.notes.push_back(far_boundary_note(scene, start.reach));
  if (!start.notes.empty()) result.notes.push_back(start.notes);
  const double steepest = geometry.shape(layout.grid).climb.cwiseAbs().maxCoeff();
  if (steepest > 0.05)
    result.notes.push_back(fmt::format(
        "the patch is curved (slope {:.2g} at the edge of the grid): tractions, slip and gap are "
        "along the local normal and tangents, y is the lateral coordinate, forces are along x, y, "
        "z",
        steepest));
  if (scene.has_profiles()) {
    const double yaw = std::asin(scene.geometry.surface.profiles->axle().direction[0]);
    if (std::abs(yaw) > 1e-9)
      result.notes.push_back(
          fmt::format("the wheel is yawed by {:.3g} mrad: undeformed distance and slip include "
                      "this; its finite-element body is revolved about the axle without yaw",
                      1e3 * yaw));
  }
  if (start.half)
    result.notes.push_back("half of each body is modelled: y = 0 is a symmetry plane");
  result.notes.push_back(fmt::format("cells of {:.4g} mm in the patch, degree {}; {}",
                                     layout.bodies.cell_size, layout.bodies.degree, start.solver));
}

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
                   const contact::Progress& progress, const contact::MakeElasticity& make,
                   LevelStart& start, contact::ModelResult& result) {
  // Load points with the states from which the next ones start, so that numbers of a resumed run
  // are the same to the last bit.
  const std::string name = fmt::format("fem-{:.9g}mm", options.cell_size);
  const bool start_known = find_start(options.checkpoint, name + "-normal", start);
  contact::RunOptions run_options;
  run_options.model = "fem";
  run_options.stage_prefix = options.stage_prefix;
  run_options.accuracy = run_options.force_accuracy = fem_accuracy;
  run_options.force_tolerance = force_tolerance;
  if (start_known) run_options.first_defect = start.defect;

  std::optional<contact::PointStore> store;
  if (options.checkpoint != nullptr) store.emplace(*options.checkpoint, name, start_known);
  contact::ContactRun run(scene, geometry, run_options, progress, store ? &*store : nullptr);
  run.on_first_defect = [&](const contact::Response& defect, int contact_elements) {
    start.defect = defect;
    start.contact_elements = contact_elements;
    if (options.checkpoint == nullptr) return;
    contact::Record record;
    exchange(record, start);
    options.checkpoint->keep(name + "-normal", record.bytes());
  };
  if (!run.solve(layout.grid, make)) refuse_border(scene, geometry, layout.grid);
  contact::LevelResult level = run.take_result();
  refuse_further_patches(scene, geometry, layout.grid, level.points);
  if (std::string note = contact::steep_friction_note(level, scene.friction()); !note.empty())
    result.notes.push_back(std::move(note));
  result.unknowns = start.unknowns;
  result.contact_elements = start.contact_elements;
  result.bodies = start.bodies;
  result.points = std::move(level.points);
  result.seconds["normal"] = level.normal_seconds;
  result.seconds["tangential"] = level.tangential_seconds;
  add_notes(scene, geometry, layout, start, result);
}

}  // namespace

contact::ModelResult run_level(const Scene& scene, const LevelOptions& options,
                               const contact::Progress& progress) {
  const RunLayout layout = run_layout(scene, options.cell_size);
  const contact::ChartedGeometry geometry(scene.geometry, contact::Chart::projected);
  LevelStart start;
  contact::ModelResult result;
  result.name = "fem";
  result.grid = layout.grid;
  FirstProcess first(MPI_COMM_WORLD);
  auto elasticity =
      make_fem_elasticity(scene, geometry, layout, options, progress, first, start, result);
  first.run(
      [&] {
        solve_contact(
            scene, geometry, layout, options, progress, [&] { return std::move(elasticity); },
            start, result);
      },
      [&](const FirstProcess::Order& order) { elasticity->obey(order); });
  return result;
}

}  // namespace rollfem::fem

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/equivalent_ellipse.hpp"

#include "base/count.hpp"
#include "base/errors.hpp"
#include "base/pi.hpp"
#include "contact/solve/pressure_share.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "theories/elliptic_patch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::theories {

using contact::ContactGrid;
using contact::Creepage;
using contact::ModelResult;
using contact::PointResult;
using contact::Scene;

namespace {

using contact::pi;

/// Relative difference from the half-space in extents or pressure above which a note is written.
constexpr double worth_a_note = 0.02;

constexpr const char* elements_of_ellipse = "elements across the equivalent ellipse (contact_grid)";

/// The ellipse, and the case with its Hertz pressure given in a frame at its centre.
struct EquivalentEllipse {
  halfspace::ExpectedPatch patch;               ///< of the half-space
  double semi_axis_x = 0.0, semi_axis_y = 0.0;  ///< mm
  contact::Scene scene;  ///< creepages at the centre of the ellipse: (xi - phi y, eta + phi x)
};

/// A row of `count` elements from `first` on, extended by whole elements to cover low to high.
void widen(double low, double high, double cell, double& first, int& count) {
  const double lowest = first - 0.5 * cell;
  const double highest = lowest + count * cell;
  const int before =
      std::max(0, contact::count_of(std::ceil((lowest - low) / cell), elements_of_ellipse));
  first -= before * cell;
  count += before +
           std::max(0, contact::count_of(std::ceil((high - highest) / cell), elements_of_ellipse));
}

/// The potential area of the case, extended where the ellipse reaches beyond it because the true
/// patch is shorter on one side of its centre of pressure.
ContactGrid area_around(const Scene& scene, const EquivalentEllipse& ellipse) {
  ContactGrid grid = halfspace::PatchSearch(scene).grid();
  if (scene.contact_grid.extent) return grid;  // requested potential area
  const halfspace::ExpectedPatch& patch = ellipse.patch;
  widen(patch.x_centre - ellipse.semi_axis_x - grid.dx,
        patch.x_centre + ellipse.semi_axis_x + grid.dx, grid.dx, grid.x_first, grid.nx);
  widen(patch.y_centre - ellipse.semi_axis_y - grid.dy,
        patch.y_centre + ellipse.semi_axis_y + grid.dy, grid.dy, grid.y_first, grid.ny);
  return grid;
}

/// The grid as [contact_grid] of a case whose origin is at (x, y) of this grid's frame.
contact::GridOptions fixed_grid(const ContactGrid& grid, double x, double y) {
  contact::GridOptions options;
  options.cell_size = {grid.dx, grid.dy};
  options.extent = {grid.nx * grid.dx, grid.ny * grid.dy};
  options.middle = {grid.x_first + 0.5 * (grid.nx - 1) * grid.dx - x,
                    grid.y_first + 0.5 * (grid.ny - 1) * grid.dy - y};
  return options;
}

/// Position in the patches that corresponds to the ellipse's row at `y`: unloaded rows are skipped.
double loaded_place(const EquivalentEllipse& ellipse, double y) {
  const halfspace::ExpectedPatch& patch = ellipse.patch;
  const double share = 0.5 * ((y - patch.y_centre) / ellipse.semi_axis_y + 1.0);
  double way = share * patch.covered_width();
  for (const auto& run : patch.loaded) {
    if (way <= run[1] - run[0] || &run == &patch.loaded.back()) return run[0] + way;
    way -= run[1] - run[0];
  }
  return y;
}

/// Extra slip of the ellipse's rows, taken from the rows of the patches; at the ellipse's own
/// positions it would come from the gap between the patches.
contact::TangentialField slip_of_loaded_rows(const Scene& scene, const EquivalentEllipse& ellipse,
                                             const contact::ChartedGeometry& geometry,
                                             const ContactGrid& grid) {
  contact::TangentialField slip{contact::Field(grid.size()), contact::Field(grid.size())};
  const double spin = scene.points.front().creepage.spin;
  for (int j = 0; j < grid.ny; ++j) {
    const double place = loaded_place(ellipse, grid.y(j));
    const ContactGrid row{grid.nx, 1, grid.dx, grid.dy, grid.x_first, place};
    const contact::TangentialField there = geometry.extra_slip({}, row);
    slip.x.segment(grid.index(0, j), grid.nx) = there.x.array() - spin * (place - grid.y(j));
    slip.y.segment(grid.index(0, j), grid.nx) = there.y;
  }
  return slip;
}

/// Extra slip of the scene on points in the frame at the middle of its patch that hold the grid and
/// the ellipse.
contact::Lattice extra_slip_about(const Scene& scene, const EquivalentEllipse& ellipse,
                                  const ContactGrid& area) {
  constexpr int rows = 81;
  const halfspace::ExpectedPatch& patch = ellipse.patch;
  const auto farthest = [](double middle, double first, double last, double semi_axis) {
    return 1.05 * std::max({middle - first, last - middle, semi_axis});
  };
  const double half_x =
      farthest(patch.x_centre, area.x(0), area.x(area.nx - 1), ellipse.semi_axis_x);
  const double half_y =
      farthest(patch.y_centre, area.y(0), area.y(area.ny - 1), ellipse.semi_axis_y);
  const ContactGrid grid = ContactGrid::centred(
      4, rows, 2.0 * half_x / 3.0, 2.0 * half_y / (rows - 1), patch.x_centre, patch.y_centre);
  const contact::ChartedGeometry geometry(scene.geometry, contact::Chart::plane);
  const contact::TangentialField slip = patch.loaded.size() > 1
                                            ? slip_of_loaded_rows(scene, ellipse, geometry, grid)
                                            : geometry.extra_slip({}, grid);
  contact::Lattice lattice{
      "",      4,       rows, grid.x_first - patch.x_centre, grid.y_first - patch.y_centre,
      grid.dx, grid.dy, {}};
  for (const contact::Field* values : {&slip.x, &slip.y})
    lattice.values.emplace_back(values->begin(), values->end());
  return lattice;
}

EquivalentEllipse equivalent_ellipse(const Scene& scene) {
  EquivalentEllipse ellipse;
  ellipse.patch = halfspace::PatchSearch(scene).patch();
  const halfspace::ExpectedPatch& patch = ellipse.patch;
  const double aspect = patch.length / patch.covered_width();
  ellipse.semi_axis_x = std::sqrt(patch.area / pi * aspect);
  ellipse.semi_axis_y = std::sqrt(patch.area / pi / aspect);
  Scene& local = ellipse.scene;
  local = scene;
  local.geometry = {};
  local.geometry.extra_slip = contact::ExtraSlip::file;
  const ContactGrid area = area_around(scene, ellipse);
  local.geometry.extra_slip_values = extra_slip_about(scene, ellipse, area);
  local.contact_grid = fixed_grid(area, patch.x_centre, patch.y_centre);
  local.given_pressure = contact::GivenPressure{ellipse.semi_axis_x, ellipse.semi_axis_y,
                                                1.5 * patch.normal_force / patch.area};
  for (contact::LoadPoint& point : local.points) {
    point.load = {patch.normal_force, {}};
    Creepage& creepage = point.creepage;
    creepage.longitudinal -= creepage.spin * patch.y_centre;
    creepage.lateral += creepage.spin * patch.x_centre;
  }
  return ellipse;
}

/// Converts results in the frame of the ellipse into results of the case with profiles: grid, spin
/// moment, creepages and approach, with a note on the equivalent ellipse.
void return_to_patch_frame(const Scene& scene, const EquivalentEllipse& ellipse,
                           ModelResult& result) {
  const halfspace::ExpectedPatch& patch = ellipse.patch;
  const double x = patch.x_centre, y = patch.y_centre;
  result.grid.x_first += x;
  result.grid.y_first += y;
  for (std::size_t k = 0; k < result.points.size(); ++k) {
    PointResult& point = result.points[k];
    point.creepage = scene.points[k].creepage;
    point.spin_moment += x * point.lateral_force - y * point.longitudinal_force;
    point.approach = patch.approach;
    point.patch_x_middle = x;
    point.patch_y_middle = y;
    for (contact::SubsurfaceField& field : point.subsurface)
      for (auto& place : field.points) {
        place[0] += x;
        place[1] += y;
      }
  }
  contact::add_note(result.notes, "profiles",
                    "true profiles: the theory is solved on the ellipse of the same area and ratio "
                    "of extents as "
                    "the half-space patch, semi-axes {:.4g} and {:.4g} mm about its centre of "
                    "pressure ({:.3g}, "
                    "{:.3g}) mm; the half-space patch is {:.4g} by {:.4g} mm with p0 = {:.4g} MPa",
                    ellipse.semi_axis_x, ellipse.semi_axis_y, x, y, patch.length, patch.width,
                    patch.max_pressure);
  if (patch.gaps > 0.0)
    contact::add_note(result.notes, "several_patches",
                      "the contact consists of several patches with {:.4g} mm of its {:.4g} mm "
                      "between them: one ellipse represents all; halfspace and strip resolve each",
                      patch.gaps, patch.width);
}

}  // namespace

ModelResult run_on_ellipse(const contact::Model& model, const Scene& scene,
                           const contact::Progress& progress) {
  const EquivalentEllipse ellipse = equivalent_ellipse(scene);
  ModelResult result = model(ellipse.scene, progress);
  return_to_patch_frame(scene, ellipse, result);
  return result;
}

ModelResult run_hertz_of_patch(const Scene& scene, const contact::Progress& progress) {
  const halfspace::HertzContact hertz = halfspace::hertz_of_scene(scene);
  const contact::Curvatures curvatures = halfspace::curvatures_of_scene(scene);
  Scene local = scene;
  local.geometry = {};
  local.geometry.quadratic = {curvatures.A, curvatures.B};
  ModelResult result = run_hertz(local, progress);
  result.notes.back().text =
      "patch, pressure, approach and area follow from the curvatures at the contact point; the "
      "fields are sampled at element centres";
  const halfspace::ExpectedPatch patch = halfspace::PatchSearch(scene).patch();
  const auto differs = [](double a, double b) { return std::abs(a / b - 1.0) > worth_a_note; };
  if (differs(2.0 * hertz.semi_axis_x, patch.length) ||
      differs(2.0 * hertz.semi_axis_y, patch.width) ||
      differs(hertz.max_pressure, patch.max_pressure))
    contact::add_note(
        result.notes, "ellipse",
        "the profiles do not form an ellipse: Hertz uses the curvatures at the contact "
        "point (A = {:.4g}, B = {:.4g} /mm) and finds {:.4g} by {:.4g} mm with p0 = "
        "{:.4g} MPa; the half-space finds {:.4g} by {:.4g} mm with p0 = {:.4g} MPa",
        curvatures.A, curvatures.B, 2.0 * hertz.semi_axis_x, 2.0 * hertz.semi_axis_y,
        hertz.max_pressure, patch.length, patch.width, patch.max_pressure);
  return result;
}

namespace {

/// Friction on a tilted plane carries a part of the load. In a theory without a traction bound it
/// may be many times mu F_n, and then no F_n is meaningful.
void check_lift(const Scene& scene, const ModelResult& result) {
  constexpr double most_beyond_bound = 0.05;  // of the load
  const contact::NormalLoad& wanted = scene.points.front().load;
  const PointResult& point = result.points.front();
  const double bound = scene.friction_coefficient() * point.normal_force;
  const double beyond = std::abs(point.lateral_force) - bound;
  if (beyond * std::abs(wanted.direction[0]) <= most_beyond_bound * *wanted.force) return;
  throw contact::SolveError(
      fmt::format("this theory has no traction bound: friction is {:.4g} N across the rail, mu F_n "
                  "only {:.4g} N; on a plane tilted by {:.3g} rad this friction would carry {:.3g} "
                  "of the load of {:g} N; do: run with a model that bounds friction (fastsim, "
                  "strip, halfspace), or give load.normal_force",
                  std::abs(point.lateral_force), bound,
                  std::atan2(std::abs(wanted.direction[0]), wanted.direction[1]),
                  wanted.direction[0] * point.lateral_force / *wanted.force, *wanted.force));
}

/// A model at the single load point of a scene whose load is not along z: the force along z is a
/// fixed point, because friction carries a part of the load.
ModelResult run_tilted_load(const contact::Model& model, const Scene& scene,
                            const contact::Progress& progress) {
  constexpr double carried_to = 1e-9;  // of the load, across and upwards
  const contact::NormalLoad& wanted = scene.points.front().load;
  if (!wanted.force || !wanted.is_tilted()) return model(scene, progress);
  Scene single = scene;
  ModelResult result;
  const auto [across, upwards] = wanted.direction;
  contact::PressureShare sharing;
  sharing.load = *wanted.force;
  sharing.tolerance = carried_to / upwards;
  try {
    sharing.solve(sharing.load / upwards, [&, across = across, upwards = upwards](double force,
                                                                                  int) {
      single.points.front().load = {force, {}};
      result = model(single, progress);
      const PointResult& point = result.points.front();
      return force +
             (sharing.load - across * point.lateral_force - upwards * point.normal_force) / upwards;
    });
  } catch (const contact::SolveError&) {
    if (!result.points.empty()) check_lift(scene, result);
    throw;
  }
  check_lift(scene, result);
  return result;
}

}  // namespace

ModelResult run_each_load(const contact::Model& model, const Scene& scene,
                          const contact::Progress& progress) {
  if (!scene.shares_load() && !scene.load_changes()) return model(scene, progress);
  if (scene.points.size() == 1) return run_tilted_load(model, scene, progress);
  Scene single = scene;
  const ContactGrid area = scene.has_profiles() ? area_around(scene, equivalent_ellipse(scene))
                                                : halfspace::PatchSearch(scene).grid();
  single.contact_grid = fixed_grid(area, 0.0, 0.0);
  ModelResult result;
  for (std::size_t k = 0; k < scene.points.size(); ++k) {
    single.points = {scene.points[k]};
    ModelResult one = run_tilted_load(model, single, progress);
    if (k == 0) {
      result = std::move(one);
      continue;
    }
    for (const auto& [name, seconds] : one.seconds) result.seconds[name] += seconds;
    result.points.push_back(std::move(one.points.front()));
  }
  return result;
}

}  // namespace rollfem::theories

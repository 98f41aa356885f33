// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/patch/expected_patch.hpp"

#include "base/count.hpp"
#include "base/errors.hpp"
#include "base/pi.hpp"
#include "contact/iteration/normal.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "result/free_ends.hpp"
#include "scene/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Scene;

namespace {

/// Elements across the box of a search, and fewest elements across the patch found.
constexpr int elements_of_box = 30;
constexpr int fewest_across_patch = 20;
/// Elements over the loaded part in the last solution, on a lattice that moves with the origin:
/// enough for steady results where several waves of a rough profile carry the load.
constexpr int elements_of_lattice = 64;
constexpr int most_rows = 720;
constexpr int most_rounds = 12;
/// Margin on each side of the previous round's patch, relative to its extent.
constexpr double box_margin = 0.2;

constexpr const char* of_search = "elements of the search for the patch";

/// An overlap likely to carry the force: the overlap of Hertz's ellipse for a parabola as wide as
/// the overlap of the profiles.
double overlap_for_force(const Ridge& ridge, double A, double modulus, double force) {
  double overlap = 1e-6;  // mm
  for (int step = 0; step < 200; ++step, overlap *= 1.2) {
    const Overlap found = ridge.overlap(ridge.least_distance() + overlap);
    if (found.regions.empty()) continue;
    const double half = 0.5 * found.covered();
    if (hertz_from_force(A, overlap / (half * half), modulus, force).approach < overlap) break;
  }
  return overlap;
}

/// A solution of the search.
struct Found {
  ContactGrid grid;
  bool touches_border;
  ExpectedPatch patch;

  /// mm, rows without pressure within the patch and its near misses.
  double unloaded() const {
    return patch.near.y_upper - patch.near.y_lower - patch.covered_width();
  }
};

/// Runs of rows with pressure, the outermost ends as found below the element size.
std::vector<std::array<double, 2>> loaded_rows(const ContactGrid& grid,
                                               const contact::Field& pressure,
                                               const contact::PatchSize& size) {
  std::vector<std::array<double, 2>> runs;
  bool inside = false;
  for (int j = 0; j < grid.ny; ++j) {
    const bool loaded = pressure.segment(grid.index(0, j), grid.nx).maxCoeff() > 0.0;
    if (loaded && !inside) runs.push_back({grid.y(j) - 0.5 * grid.dy, 0.0});
    if (loaded) runs.back()[1] = grid.y(j) + 0.5 * grid.dy;
    inside = loaded;
  }
  if (runs.empty()) return runs;
  runs.front()[0] = size.y_lower;
  runs.back()[1] = size.y_upper;
  return runs;
}

/// Every one of several patches needs its elements; rough profiles touch at many points.
constexpr int most_to_resolve = 3;

int to_resolve(std::size_t runs) {
  return std::clamp(static_cast<int>(runs), 1, most_to_resolve);
}

/// Elements along x and y of a box with `runs` patches and `gaps` (mm) between them: as many over
/// each patch as over a single one.
std::array<int, 2> counts(const Box& box, double gaps, std::size_t runs) {
  constexpr double most_times = 24.0;
  const double width = box.y_upper - box.y_lower;
  const double times =
      std::min(most_times, to_resolve(runs) * width / std::max(width - gaps, 1e-3 * width));
  return {elements_of_box, contact::count_of(std::ceil(elements_of_box * times - 1e-9), of_search)};
}

/// mm, loaded length along a line of elements of size h: the extent for a parabolic load.
double carrying(const contact::Field& load, double h) {
  const double sum = load.sum();
  return sum > 0.0 ? 1.2 * h * sum * sum / load.squaredNorm() : 0.0;
}

std::array<double, 2> carrying_lengths(const ContactGrid& grid, const contact::Field& pressure) {
  contact::Field columns = contact::Field::Zero(grid.nx), rows = contact::Field::Zero(grid.ny);
  for (int j = 0; j < grid.ny; ++j) {
    const auto row = pressure.segment(grid.index(0, j), grid.nx);
    rows[j] = row.sum();
    columns += row;
  }
  return {carrying(columns, grid.dx), carrying(rows, grid.dy)};
}

/// `ridge`: null for bodies given point by point.
Found solve_on(const Scene& scene, const Ridge* ridge, const ContactGrid& grid,
               const contact::NormalLoad& load) {
  const HalfspaceCompliance compliance(grid, scene.material.uncoupled());
  const contact::ChartedGeometry geometry(scene.geometry, contact::Chart::plane);
  const contact::NormalProblem problem{geometry.undeformed_distance(grid), load.force,
                                       load.approach};
  contact::NormalOptions options;
  options.tolerance = 1e-4;
  const contact::NormalSolution normal =
      contact::solve_normal(compliance.normal(), problem, options);
  const contact::Field& pressure = normal.pressure;
  contact::PatchSize size = contact::patch_size(grid, pressure);
  contact::cut_at_ends(scene, size);
  const auto centre = [&](auto&& coordinate) {
    return grid.sample(coordinate).dot(pressure) / pressure.sum();
  };
  ExpectedPatch patch;
  static_cast<contact::PatchSize&>(patch) = size;
  patch.x_centre = centre([](double x, double) { return x; });
  patch.y_centre = centre([](double, double y) { return y; });
  patch.approach = normal.approach;
  patch.max_pressure = pressure.maxCoeff();
  patch.normal_force = normal.normal_force;
  patch.loaded = loaded_rows(grid, pressure, size);
  for (std::size_t k = 0; k + 1 < patch.loaded.size(); ++k)
    patch.gaps += patch.loaded[k + 1][0] - patch.loaded[k][1];
  patch.near = {size.x_lower, size.x_upper, size.y_lower, size.y_upper};
  if (ridge != nullptr)
    patch.near = with_near_misses(patch.near, *ridge, normal.approach, grid, pressure,
                                  scene.material.contact_modulus);
  const auto [length, width] = carrying_lengths(grid, pressure);
  patch.carrying_length = length;
  patch.carrying_width = width;
  return {grid, contact::touches_border(grid, pressure), std::move(patch)};
}

Found solve_in(const Scene& scene, const Ridge* ridge, const Box& box,
               const contact::NormalLoad& load, const std::array<int, 2>& n) {
  const double dx = (box.x_upper - box.x_lower) / n[0];
  const double dy = (box.y_upper - box.y_lower) / n[1];
  return solve_on(scene, ridge,
                  {n[0], n[1], dx, dy, box.x_lower + 0.5 * dx, box.y_lower + 0.5 * dy}, load);
}

/// The patch and near misses, so that no small patch is lost between elements, with a box_margin.
Box next_box(const Found& found) {
  const auto grow = [](double& lower, double& upper, double extent, double step) {
    const double margin = box_margin * std::max(extent, 2.0 * step);
    lower -= margin;
    upper += margin;
  };
  Box next = found.patch.near;
  grow(next.x_lower, next.x_upper, found.patch.length, found.grid.dx);
  grow(next.y_lower, next.y_upper, found.patch.width, found.grid.dy);
  return next;
}

/// Elements with a corner at the origin, equally many along x and y over the loaded part. The boxes
/// of the search jump from one position to the next; this lattice moves with the bodies.
ContactGrid lattice_over(const Found& found) {
  const Box box = next_box(found);
  const double dx = std::max(found.patch.carrying_length / elements_of_lattice,
                             (box.x_upper - box.x_lower) / most_rows);
  const double dy = std::max(found.patch.carrying_width / elements_of_lattice,
                             (box.y_upper - box.y_lower) / most_rows);
  const double i = std::floor(box.x_lower / dx), j = std::floor(box.y_lower / dy);
  return {contact::count_of(std::ceil(box.x_upper / dx) - i, of_search),
          contact::count_of(std::ceil(box.y_upper / dy) - j, of_search),
          dx,
          dy,
          (i + 0.5) * dx,
          (j + 0.5) * dy};
}

bool fine_enough(const Found& found) {
  const ExpectedPatch& patch = found.patch;
  return patch.length >= fewest_across_patch * found.grid.dx &&
         patch.covered_width() >=
             fewest_across_patch * to_resolve(patch.loaded.size()) * found.grid.dy &&
         !found.touches_border;
}

}  // namespace

/// The patch on the points, then in a box around it.
ExpectedPatch patch_of_points(const Scene& scene) {
  const contact::Lattice& points = *scene.geometry.distance_values;
  const Box all{points.x_first, points.x_first + (points.nx - 1) * points.dx, points.y_first,
                points.y_first + (points.ny - 1) * points.dy};
  const contact::NormalLoad load = contact::largest_load(scene);
  Found found = solve_in(scene, nullptr, all, load, counts(all, 0.0, 1));
  for (int round = 0; round < most_rounds && !fine_enough(found); ++round) {
    const Box next = next_box(found);
    const Box within{std::max(next.x_lower, all.x_lower), std::min(next.x_upper, all.x_upper),
                     std::max(next.y_lower, all.y_lower), std::min(next.y_upper, all.y_upper)};
    found = solve_in(scene, nullptr, within, load,
                     counts(within, found.patch.gaps, found.patch.loaded.size()));
  }
  return found.patch;
}

ExpectedPatch patch_of_profiles(const Scene& scene, const Ridge& ridge, SearchDetail detail) {
  const contact::NormalLoad load = contact::largest_load(scene);
  const double A = 0.5 / scene.geometry.surface.relative_rolling_radius();
  const double modulus = scene.material.contact_modulus;
  double level =
      load.force ? ridge.least_distance() + 1.1 * overlap_for_force(ridge, A, modulus, *load.force)
                 : load.approach.value_or(0.0);
  const auto solve_overlap = [&] {
    const Overlap overlap = ridge.overlap(level);
    if (overlap.regions.empty())
      throw contact::SolveError(
          scene.where(),
          "no contact: the approach {} mm does not exceed the smallest distance {} mm", level,
          ridge.least_distance());
    // There is no contact outside the overlap: the elastic displacement always opens the gap, so
    // that h < approach wherever there is pressure.
    return solve_in(scene, &ridge, overlap.box, load,
                    counts(overlap.box, overlap.gaps, overlap.regions.size()));
  };
  Found found = solve_overlap();
  for (int round = 0; round < most_rounds && load.force && found.patch.approach > level; ++round) {
    level = ridge.least_distance() + 1.2 * (found.patch.approach - ridge.least_distance());
    found = solve_overlap();
  }
  for (int round = 0; round < most_rounds && !fine_enough(found); ++round) {
    const Box box = next_box(found);
    found = solve_in(scene, &ridge, box, load,
                     counts(box, found.unloaded(), found.patch.loaded.size()));
  }
  check_profiles_reach(scene, found.patch.y_lower, found.patch.y_upper);
  return detail == SearchDetail::box ? found.patch
                                     : solve_on(scene, &ridge, lattice_over(found), load).patch;
}

ExpectedPatch patch_of_ellipse(const Scene& scene) {
  const HertzContact hertz = hertz_of_scene(scene);
  ExpectedPatch patch;
  patch.x_lower = -hertz.semi_axis_x;
  patch.x_upper = hertz.semi_axis_x;
  patch.y_lower = -hertz.semi_axis_y;
  patch.y_upper = hertz.semi_axis_y;
  patch.length = 2.0 * hertz.semi_axis_x;
  patch.width = 2.0 * hertz.semi_axis_y;
  patch.approach = hertz.approach;
  patch.max_pressure = hertz.max_pressure;
  patch.normal_force = hertz.normal_force;
  patch.area = (scene.geometry.line ? 4.0 : contact::pi) * hertz.semi_axis_x * hertz.semi_axis_y;
  patch.near = {patch.x_lower, patch.x_upper, patch.y_lower, patch.y_upper};
  patch.carrying_length = patch.length;
  patch.carrying_width = patch.width;
  return patch;
}

void check_profiles_reach(const Scene& scene, double y_lower, double y_upper) {
  if (!scene.has_profiles()) return;
  const auto check = [&](const contact::HeightCurve& curve, const char* body) {
    const bool below = y_lower < curve.first();
    if (!below && y_upper <= curve.last()) return;
    throw contact::InputError(
        scene.where(),
        "{}.profile: profile too short for the contact: it ends at y = {:.4g} mm of the "
        "patch, but the contact reaches from {:.4g} to {:.4g} mm; allowed: profiles that "
        "extend beyond the patch; do: give a longer profile, or move the wheelset",
        body, below ? curve.first() : curve.last(), y_lower, y_upper);
  };
  check(scene.geometry.surface.profiles->rail(), "rail");
  check(scene.geometry.surface.profiles->wheel(), "wheel");
}

}  // namespace rollfem::halfspace

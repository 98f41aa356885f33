#include "halfspace/theories/equivalent_ellipse.hpp"

#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::halfspace {

using contact::Case;
using contact::ContactGrid;
using contact::Creepage;
using contact::ModelResult;
using contact::PointResult;

namespace {

constexpr double pi = 3.14159265358979323846;

/// Elements along the box of the half-space solution that the ellipse is taken from.
constexpr int elements_for_ellipse = 90;

/// Extents or pressure that differ by more than this from the half-space are said.
constexpr double worth_a_note = 0.02;

/// A row of `count` elements from `first` on, made longer by whole elements to hold low to high.
void widen(double low, double high, double cell, double& first, int& count) {
  const double lowest = first - 0.5 * cell;
  const double highest = lowest + count * cell;
  const int before = std::max(0, static_cast<int>(std::ceil((lowest - low) / cell)));
  first -= before * cell;
  count += before + std::max(0, static_cast<int>(std::ceil((high - highest) / cell)));
}

/// The potential area of the case, which may end within the ellipse where the true patch is shorter
/// on one side of its centre of pressure.
ContactGrid area_around(const Case& input, const EquivalentEllipse& ellipse) {
  ContactGrid grid = potential_area(input);
  if (input.contact_grid.extent) return grid;  // what the user wants to see
  const ExpectedPatch& patch = ellipse.patch;
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

double largest_spin(const Case& input) {
  double spin = 0.0;
  for (const Creepage& creepage : input.rolling.creepages)
    spin = std::abs(creepage.spin) > std::abs(spin) ? creepage.spin : spin;
  return spin;
}

void shift_points(contact::SubsurfaceField& field, double x, double y) {
  for (auto& point : field.points) {
    point[0] += x;
    point[1] += y;
  }
}

}  // namespace

EquivalentEllipse equivalent_ellipse(const Case& input) {
  EquivalentEllipse ellipse;
  ellipse.patch = expected_patch(input, elements_for_ellipse);
  const ExpectedPatch& patch = ellipse.patch;
  const double aspect = patch.length() / patch.width();
  ellipse.semi_axis_x = std::sqrt(patch.area / pi * aspect);
  ellipse.semi_axis_y = std::sqrt(patch.area / pi / aspect);
  Case& local = ellipse.input;
  local = input;
  local.patch = nullptr;
  local.contact_grid = fixed_grid(area_around(input, ellipse), patch.x_centre, patch.y_centre);
  local.given_pressure = contact::GivenPressure{ellipse.semi_axis_x, ellipse.semi_axis_y,
                                                1.5 * patch.normal_force / patch.area};
  local.load = {patch.normal_force, {}, {}, {}};
  for (Creepage& creepage : local.rolling.creepages) {
    creepage.longitudinal -= creepage.spin * patch.y_centre;
    creepage.lateral += creepage.spin * patch.x_centre;
  }
  return ellipse;
}

void return_to_patch_frame(const Case& input, const EquivalentEllipse& ellipse,
                           ModelResult& result) {
  const double x = ellipse.patch.x_centre;
  const double y = ellipse.patch.y_centre;
  result.grid.x_first += x;
  result.grid.y_first += y;
  for (std::size_t k = 0; k < result.points.size(); ++k) {
    PointResult& point = result.points[k];
    point.creepage = input.rolling.creepages[k];
    point.spin_moment += x * point.lateral_force - y * point.longitudinal_force;
    point.approach = ellipse.patch.approach;
    point.patch_x_middle = x;
    point.patch_y_middle = y;
    for (contact::SubsurfaceField& field : point.subsurface) shift_points(field, x, y);
  }
  const ExpectedPatch& patch = ellipse.patch;
  result.notes.push_back(fmt::format(
      "true profiles: the theory is solved on the ellipse of the same area and ratio of extents as "
      "the half-space patch, semi-axes {:.4g} and {:.4g} mm about its centre of pressure ({:.3g}, "
      "{:.3g}) mm; the half-space patch is {:.4g} by {:.4g} mm with p0 = {:.4g} MPa",
      ellipse.semi_axis_x, ellipse.semi_axis_y, x, y, patch.length(), patch.width(),
      patch.max_pressure));
}

ModelResult run_on_ellipse(const contact::Model& model, const Case& input,
                           const contact::Progress& progress, bool no_spin) {
  EquivalentEllipse ellipse = equivalent_ellipse(input);
  if (no_spin)
    for (Creepage& creepage : ellipse.input.rolling.creepages) creepage.spin = 0.0;
  ModelResult result = model(ellipse.input, progress);
  return_to_patch_frame(input, ellipse, result);
  if (const double spin = largest_spin(input); no_spin && spin != 0.0)
    result.notes.push_back(
        fmt::format("spin of up to {:.4g} rad/mm is left out: this theory has none", spin));
  return result;
}

ModelResult run_hertz_of_patch(const Case& input, const contact::Progress& progress) {
  const HertzContact hertz = hertz_of_case(input);
  const contact::Curvatures curvatures = curvatures_of_case(input);
  Case local = input;
  local.patch = nullptr;
  local.undeformed_distance.quadratic = {curvatures.A, curvatures.B};
  ModelResult result = run_hertz(local, progress);
  const ExpectedPatch patch = expected_patch(input, elements_for_ellipse);
  const auto differs = [](double a, double b) { return std::abs(a / b - 1.0) > worth_a_note; };
  if (differs(2.0 * hertz.semi_axis_x, patch.length()) ||
      differs(2.0 * hertz.semi_axis_y, patch.width()) ||
      differs(hertz.max_pressure, patch.max_pressure))
    result.notes.push_back(fmt::format(
        "the profiles make no ellipse: Hertz takes the curvatures at the contact point (A = "
        "{:.4g}, "
        "B = {:.4g} /mm) and finds {:.4g} by {:.4g} mm with p0 = {:.4g} MPa; the half-space finds "
        "{:.4g} by {:.4g} mm with p0 = {:.4g} MPa",
        curvatures.A, curvatures.B, 2.0 * hertz.semi_axis_x, 2.0 * hertz.semi_axis_y,
        hertz.max_pressure, patch.length(), patch.width(), patch.max_pressure));
  return result;
}

ModelResult run_each_load(const contact::Model& model, const Case& input,
                          const contact::Progress& progress) {
  if (input.load.normal_forces.empty()) return model(input, progress);
  Case single = input;
  single.contact_grid = fixed_grid(potential_area(input), 0.0, 0.0);
  single.load.normal_forces.clear();
  ModelResult result;
  for (std::size_t k = 0; k < input.rolling.creepages.size(); ++k) {
    single.load.normal_force = input.load.normal_force_of(k);
    single.rolling.creepages = {input.rolling.creepages[k]};
    ModelResult one = model(single, progress);
    if (k == 0) {
      result = std::move(one);
      continue;
    }
    for (const auto& [name, seconds] : one.seconds) result.seconds[name] += seconds;
    result.points.push_back(std::move(one.points.front()));
  }
  return result;
}

}  // namespace rollfem::halfspace

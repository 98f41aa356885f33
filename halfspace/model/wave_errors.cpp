// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/model/wave_errors.hpp"

#include "base/errors.hpp"
#include "contact/iteration/interpolation.hpp"
#include "contact/iteration/normal.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/elasticity/neighbours.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "result/patch_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;
using contact::PointResult;
using contact::Scene;

namespace {

constexpr int times_narrower = 4;

/// Pressure of the profile variation within the elements beyond a parabola through the centres of
/// three, MPa: rms over the loaded rows. Waves in full contact have a pressure of E*/2 times their
/// slope.
double pressure_within_elements(const Scene& scene, const contact::ChartedGeometry& geometry,
                                const ContactGrid& grid, const Field& pressure) {
  const contact::PatchGeometry& profiles = *scene.geometry.surface.profiles;
  const auto height = [&](double y) {
    const double at = geometry.lateral_place(y);
    return profiles.wheel().at(at).value - profiles.rail().at(at).value;
  };
  constexpr std::array<double, 5> places{-0.5, -0.25, 0.0, 0.25, 0.5};
  double squares = 0.0;
  int rows = 0;
  for (int j = 0; j < grid.ny; ++j) {
    if (!(pressure.segment(grid.index(0, j), grid.nx).maxCoeff() > 0.0)) continue;
    ++rows;
    const double y = grid.y(j), here = height(y);
    const double after = height(y + grid.dy) - here, before = height(y - grid.dy) - here;
    std::array<double, 5> rest{};
    for (std::size_t k = 0; k < places.size(); ++k)
      rest[k] = height(y + places[k] * grid.dy) - here -
                0.5 * places[k] * (after - before + places[k] * (after + before));
    for (std::size_t k = 1; k < places.size(); ++k)
      squares += std::pow((rest[k] - rest[k - 1]) / (0.25 * grid.dy), 2) / 4.0;
  }
  return rows > 0 ? 0.5 * scene.material.contact_modulus * std::sqrt(squares / rows) : 0.0;
}

/// The loaded part of a grid, with some elements around it, because narrower elements resolve
/// additional crests.
ContactGrid around_patch(const ContactGrid& grid, const Field& pressure) {
  constexpr int room = 4;
  int left = grid.nx, right = 0, lower = grid.ny, upper = 0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      if (!(pressure[grid.index(i, j)] > 0.0)) continue;
      left = std::min(left, i);
      right = std::max(right, i);
      lower = std::min(lower, j);
      upper = j;
    }
  left = std::max(0, left - room);
  right = std::min(grid.nx - 1, right + room);
  lower = std::max(0, lower - room);
  upper = std::min(grid.ny - 1, upper + room);
  return {right - left + 1, upper - lower + 1, grid.dx, grid.dy, grid.x(left), grid.y(lower)};
}

ContactGrid with_narrow_elements(const ContactGrid& grid) {
  const double dy = grid.dy / times_narrower;
  return {grid.nx,      grid.ny * times_narrower,           grid.dx, dy,
          grid.x_first, grid.y_first - 0.5 * (grid.dy - dy)};
}

struct Pressed {
  Field pressure;
  std::map<std::string, double> values;
};

Pressed press(const Scene& scene, const contact::ChartedGeometry& geometry, const ContactGrid& grid,
              const contact::NormalLoad& load, const Field& start) {
  const HalfspaceCompliance compliance(grid, scene.material.uncoupled());
  contact::NormalProblem problem{geometry.undeformed_distance(grid), load.force, load.approach};
  add_displacement(scene.neighbour_loads, scene.material, grid, problem.undeformed_distance);
  contact::NormalOptions options;
  options.tolerance = 1e-5;
  const contact::NormalSolution normal =
      contact::solve_normal(compliance.normal(), problem, options, start);
  const Field& pressure = normal.pressure;
  const contact::PatchSize size = contact::patch_size(grid, pressure);
  return {pressure,
          {{"max_pressure", pressure.maxCoeff()},
           {"approach", normal.approach},
           {"normal_force", normal.normal_force},
           {"contact_area", size.area},
           {"contact_length", size.length},
           {"contact_width", size.width},
           {"elastic_energy",
            0.5 * grid.element_area() *
                (normal.approach * pressure.sum() - pressure.dot(problem.undeformed_distance))}}};
}

}  // namespace

std::optional<WaveErrors> wave_errors(const Scene& scene, std::size_t k, const ContactGrid& grid,
                                      const PointResult& point) {
  constexpr double negligible = 0.005;      // of the largest pressure
  constexpr int most_elements = 2'000'000;  // of the narrow ones, about 1 GB
  if (!scene.has_profiles() || scene.given_pressure) return {};
  const Field& pressure = point.fields.traction.n;
  const contact::ChartedGeometry geometry = halfspace_geometry(scene);
  const ContactGrid wide = around_patch(grid, pressure);
  if (wide.size() > most_elements / times_narrower ||
      pressure_within_elements(scene, geometry, grid, pressure) <= negligible * point.max_pressure)
    return {};
  const ContactGrid narrow = with_narrow_elements(wide);
  contact::NormalLoad load;
  if (scene.points[k].load.force)
    load.force = pressure.sum() * grid.element_area();
  else
    load.approach = point.approach;
  try {
    const Pressed here =
        press(scene, geometry, wide, load, contact::interpolated(grid, pressure, wide));
    const Pressed there =
        press(scene, geometry, narrow, load, contact::interpolated(wide, here.pressure, narrow));
    WaveErrors errors;
    for (const auto& [name, value] : here.values)
      errors[name] = std::abs(there.values.at(name) - value);
    return errors;
  } catch (const contact::SolveError&) {
    return {};  // then error bars are from the grids only
  }
}

WaveErrors rounding_errors(const Scene& scene, const ContactGrid& grid, const PointResult& point) {
  constexpr double of_pressure = 1.6, of_approach = 2.5, of_axis = 0.25;
  if (!scene.has_profiles()) return {};
  const contact::PatchGeometry& profiles = *scene.geometry.surface.profiles;
  double pressure = 0.0, height = 0.0;
  for (const bool wheel : {false, true}) {
    const contact::HeightCurve& curve = wheel ? profiles.wheel() : profiles.rail();
    const double scatter = profiles.rounding()[wheel ? 1 : 0];
    if (!(scatter > 0.0)) continue;
    const double spacing =
        (curve.last() - curve.first()) / static_cast<double>(curve.knots().size() - 1);
    pressure =
        std::hypot(pressure, contact::pressure_of_scatter(scene.material.contact_modulus, scatter,
                                                          std::max(spacing, grid.dy)));
    height = std::hypot(height, scatter);
  }
  if (!(height > 0.0)) return {};
  const double part = of_axis * pressure / point.max_pressure;
  return {{"max_pressure", of_pressure * pressure},
          {"approach", of_approach * height},
          {"contact_length", part * point.contact_length},
          {"contact_width", part * point.contact_width},
          {"semi_axis_x", part * point.semi_axis_x},
          {"semi_axis_y", part * point.semi_axis_y}};
}

std::string wave_warning(const ContactGrid& grid, const PointResult& point,
                         const WaveErrors& errors) {
  constexpr double worth_a_warning = 0.05, aim = 0.02;
  const double pressure = errors.at("max_pressure") / point.max_pressure;
  const double area = errors.at("contact_area") / point.contact_area;
  const double larger = std::max(pressure, area);
  if (!(larger > worth_a_warning)) return {};
  return fmt::format(
      "cells of {:.3g} mm across do not resolve the waves of the profiles: without friction, cells "
      "of {:.3g} mm change the largest pressure by {:.2g} % and the contact area by {:.2g} %; do: "
      "use about {:.1g} mm (contact_grid.cell_size), or smooth the scatter of the measured points "
      "(smoothing under [wheel_profile] and [rail_profile])",
      grid.dy, grid.dy / times_narrower, 100.0 * pressure, 100.0 * area,
      grid.dy * std::sqrt(aim / larger));
}

}  // namespace rollfem::halfspace

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/scene.hpp"

#include "base/pi.hpp"
#include "scene/geometry.hpp"
#include "scene/hertz_ellipse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

/// Without the creepages and shifts in whose place a force is prescribed.
LoadPoint without_unknowns(LoadPoint point) {
  if (point.force.longitudinal) point.creepage.longitudinal = point.longitudinal_shift = 0.0;
  if (point.force.lateral) point.creepage.lateral = point.lateral_shift = 0.0;
  return point;
}

/// N, by Hertz.
double force_of_max_pressure(const Case& input) {
  return hertz_force(input, combine(input.wheel.material, input.rail.material),
                     *input.load.max_pressure);
}

/// Load point k of a case; values missing in a step of a history come from the whole case.
LoadPoint load_point(const Case& input, std::size_t k) {
  LoadPoint point;
  point.creepage = input.rolling.creepages[k];
  if (k < input.rolling.forces.size()) point.force = input.rolling.forces[k];
  point.load.force = input.load.normal_force;
  point.load.approach = input.load.approach;
  if (input.load.max_pressure) point.load.force = force_of_max_pressure(input);
  if (k >= input.history.size()) return without_unknowns(point);
  const HistoryStep& step = input.history[k];
  if (step.normal_force || step.approach) {
    point.load.force = step.normal_force;
    point.load.approach = step.approach;
  }
  static_cast<StepMotion&>(point) = step;
  return without_unknowns(point);
}

}  // namespace

Scene::Scene(const Case& input)
    : file(input.file),
      geometry(input),
      rail_inclination(input.track.inclination),
      wheel{input.wheel.material, input.wheel.mesh, input.wheel.plasticity},
      rail{input.rail.material, input.rail.mesh, input.rail.plasticity},
      material(combine(input.wheel.material, input.rail.material)),
      friction_law(friction_of(input)),
      problem(input.rolling.problem),
      starts_steady(input.starts_steady),
      given_pressure(input.given_pressure),
      heat(surface_heat(input)),
      speed(input.rolling.speed),
      upwind_order(input.rolling.upwind_order),
      leading_edge(input.rolling.leading_edge),
      contact_grid(input.contact_grid),
      accuracy{input.accuracy, input.accuracy_of},
      follows_surface(input.surface == SurfaceForm::curved ? 1.0 : 0.0),
      inertia(input.inertia),
      body_extent(input.body_extent),
      options(input.options),
      subsurface(input.subsurface),
      output(input.output) {
  if (input.layer) material.layer = input.layer->compliance();
  for (std::size_t k = 0; k < input.rolling.creepages.size(); ++k)
    points.push_back(load_point(input, k));
}

bool Scene::load_changes() const {
  return std::any_of(points.begin(), points.end(), [this](const LoadPoint& point) {
    return !(point.load == points.front().load);
  });
}

bool Scene::shares_load() const {
  return std::any_of(points.begin(), points.end(),
                     [](const LoadPoint& point) { return point.load.is_tilted(); });
}

bool Scene::is_symmetric() const {
  return !has_profiles() && geometry.has_surfaces() && geometry.extra_slip != ExtraSlip::file &&
         !(friction_law && friction_law->varies()) &&
         std::all_of(points.begin(), points.end(), [](const LoadPoint& point) {
           return point.creepage.lateral == 0.0 && point.creepage.spin == 0.0 &&
                  !point.force.lateral && point.lateral_shift == 0.0 && point.spin_shift == 0.0;
         });
}

NormalLoad largest_load(const Scene& scene) {
  NormalLoad largest;
  const auto raise = [](std::optional<double>& highest, double value) {
    highest = std::max(highest.value_or(value), value);
  };
  for (const LoadPoint& point : scene.points) {
    if (point.load.force) raise(largest.force, *point.load.force / point.load.direction[1]);
    if (point.load.approach) raise(largest.approach, *point.load.approach);
  }
  if (largest.force) largest.approach.reset();
  return largest;
}

/// Scaled so that the elements carry the normal force exactly: those cut by the ellipse would
/// otherwise add or lack some 1e-3 of it.
Field pressure_field(const GivenPressure& pressure, const ContactGrid& grid) {
  Field shape = grid.sample([&](double x, double y) {
    const double u = x / pressure.semi_axis_x;
    const double v = y / pressure.semi_axis_y;
    return std::sqrt(std::max(0.0, 1.0 - u * u - v * v));
  });
  const double volume = shape.sum() * grid.element_area();
  const double exact = 2.0 / 3.0 * pi * pressure.semi_axis_x * pressure.semi_axis_y;
  if (volume > 0.0) shape *= pressure.max_pressure * exact / volume;
  return shape;
}

Scene at_point(const Scene& scene, std::size_t k) {
  Scene single = scene;
  single.points = {scene.points.at(k)};
  single.starts_steady = scene.starts_steady && k == 0;
  return single;
}

std::string derived_values(const Case& input) {
  const Curvatures curvatures = relative_curvatures(input);
  const CombinedMaterial material = combine(input.wheel.material, input.rail.material);
  std::string text = "what follows\n";
  const auto line = [&](const char* name, double value, const char* unit, const char* meaning) {
    text += fmt::format("  {:<22} {:.6g}{}  ({})\n", name, value, unit, meaning);
  };
  if (!input.given_pressure && !input.undeformed_distance.values && !input.has_profiles()) {
    line("A", curvatures.A, " 1/mm", "undeformed distance h = A x^2 + B y^2");
    line("B", curvatures.B, " 1/mm",
         input.undeformed_distance.quadratic ? "as given"
                                             : "from the transverse radii of wheel and rail");
  }
  if (input.load.max_pressure)
    line("F_z", force_of_max_pressure(input), " N", "load.max_pressure by Hertz");
  line("E*", material.contact_modulus, " MPa", "contact modulus of both bodies");
  line("G", material.shear_modulus, " MPa", "combined shear modulus");
  line("nu", material.poisson_ratio, "", "combined Poisson's ratio");
  line("K", material.difference, "",
       "unlike materials couple pressure and friction; 0: they do not");
  text += fmt::format("  {:<22} {}\n", "load points", input.rolling.creepages.size());
  return text;
}

}  // namespace rollfem::contact

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/closed_forms.hpp"

#include "base/pi.hpp"
#include "case/keys/key_builder.hpp"
#include "halfspace/closed_forms/kalker.hpp"
#include "theories/brush.hpp"
#include "theories/elliptic_patch.hpp"
#include "theories/theory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollfem::theories {

namespace {

using contact::pi;

double root_of_rest(double x, double y) {
  return std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
}

/// In the adhesion area of the solution.
bool adheres(const VermeulenJohnson& solution, double x, double y) {
  const double t = (x - (1.0 - solution.stick_ratio)) / solution.stick_ratio;
  return solution.stick_ratio > 0.0 && std::hypot(t, y / solution.stick_ratio) < 1.0;
}

/// The tractions subtracted in the adhesion area, mu N s^3, act at x = (1 - s) a.
double spin_moment(const EllipticPatch& patch, const VermeulenJohnson& solution) {
  const double s = solution.stick_ratio;
  return -patch.friction * patch.hertz.normal_force * s * s * s * (1.0 - s) *
         patch.hertz.semi_axis_x * solution.direction_y;
}

void fill_fields(const EllipticPatch& patch, const VermeulenJohnson& solution,
                 contact::PointResult& point) {
  const contact::ContactGrid& grid = patch.grid;
  const double a = patch.hertz.semi_axis_x;
  const double b = patch.hertz.semi_axis_y;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int k = grid.index(i, j);
      if (point.fields.state[k] == contact::ElementState::exterior) continue;
      const double size = patch.friction * patch.hertz.max_pressure *
                          vermeulen_johnson_traction(solution, a, b, grid.x(i), grid.y(j));
      point.fields.traction.x[k] = size * solution.direction_x;
      point.fields.traction.y[k] = size * solution.direction_y;
      if (!adheres(solution, grid.x(i) / a, grid.y(j) / b))
        point.fields.state[k] = contact::ElementState::slip;
    }
}

}  // namespace

VermeulenJohnson vermeulen_johnson(double semi_axis_x, double semi_axis_y, double shear_modulus,
                                   double poisson_ratio, double friction_force,
                                   const contact::Creepage& creepage) {
  const halfspace::CreepForces linear = halfspace::linear_creep_forces(
      semi_axis_x, semi_axis_y, shear_modulus, poisson_ratio, creepage);
  const double size = std::hypot(linear.longitudinal, linear.lateral);
  VermeulenJohnson solution;
  solution.stick_ratio = 1.0;
  if (size == 0.0) return solution;
  solution.load = size / friction_force;
  solution.stick_ratio = std::max(0.0, 1.0 - solution.load / 3.0);
  // 1 - s^3 with s = 1 - t/3, without cancellation at small tau.
  const double s = solution.stick_ratio;
  solution.saturation = std::min(1.0, solution.load / 3.0) * (1.0 + s + s * s);
  solution.direction_x = linear.longitudinal / size;
  solution.direction_y = linear.lateral / size;
  return solution;
}

double vermeulen_johnson_traction(const VermeulenJohnson& solution, double semi_axis_x,
                                  double semi_axis_y, double x, double y) {
  const double s = solution.stick_ratio;
  const double t = x / semi_axis_x;
  const double u = y / semi_axis_y;
  const double whole = root_of_rest(t, u);
  return s > 0.0 ? whole - s * root_of_rest((t - (1.0 - s)) / s, u / s) : whole;
}

contact::ModelResult run_vermeulen_johnson(const contact::Scene& scene,
                                           const contact::Progress& progress) {
  const EllipticPatch patch = elliptic_patch(scene);
  const auto fill = [&](contact::PointResult& point) {
    if (patch.friction == 0.0) return;
    const VermeulenJohnson solution = vermeulen_johnson(
        patch.hertz.semi_axis_x, patch.hertz.semi_axis_y, patch.material.shear_modulus,
        patch.material.poisson_ratio, patch.friction * patch.hertz.normal_force, point.creepage);
    const double force = patch.friction * point.normal_force * solution.saturation;
    fill_fields(patch, solution, point);
    set_forces(
        {force * solution.direction_x, force * solution.direction_y, spin_moment(patch, solution)},
        point);
    set_largest_tractions(point);
    point.adhesion_area *= solution.stick_ratio * solution.stick_ratio;
  };
  return run_theory(scene, patch.grid, patch.normal, "vermeulen-johnson", progress, fill);
}

contact::ModelResult run_linear(const contact::Scene& scene, const contact::Progress& progress) {
  const EllipticPatch patch = elliptic_patch(scene);
  const BrushFlexibilities flexibilities =
      kalker_flexibilities(patch.hertz.semi_axis_x, patch.hertz.semi_axis_y,
                           patch.material.shear_modulus, patch.material.poisson_ratio);
  const auto strip_at = [&](double y) {
    return ellipse_strip(patch.hertz, y, std::numeric_limits<double>::infinity(),
                         BoundShape::parabolic);
  };
  const auto fill = [&](contact::PointResult& point) {
    if (patch.friction == 0.0) return;
    const BrushProblem problem{patch.geometry, point.creepage, flexibilities, 64};
    fill_brush_fields(patch.grid, problem, strip_at, point);
    set_forces(patch.linear_forces(point.creepage), point);
    set_largest_tractions(point);
  };
  return run_theory(scene, patch.grid, patch.normal, "linear", progress, fill);
}

double polach_gradient(double linear_force, double friction_force) {
  return 0.25 * pi * linear_force / friction_force;
}

double polach_saturation(double gradient, double adhesion, double slip) {
  const double stuck = adhesion * gradient;
  return 2.0 / pi * (stuck / (1.0 + stuck * stuck) + std::atan(slip * gradient));
}

namespace {

/// Force over mu N, with the creepage s_yC that spin enlarges and its lateral force by spin (Polach
/// 1999). Creepages oppose it, also where the linear theory has C11 and C22 that differ.
Eigen::Vector2d polach_force(const EllipticPatch& patch, const PolachOptions& options,
                             const contact::Creepage& creepage, double bound) {
  const double a = patch.hertz.semi_axis_x;
  const double b = patch.hertz.semi_axis_y;
  const double leading = creepage.lateral + creepage.spin * a;
  const double lateral =
      std::abs(leading) > std::abs(creepage.lateral) ? leading : creepage.lateral;
  const double size = std::hypot(creepage.longitudinal, lateral);
  if (size == 0.0) return {0.0, 0.0};
  const Eigen::Vector2d rigid{creepage.longitudinal, creepage.lateral};
  const halfspace::CreepForces linear = patch.linear_forces({rigid.x(), rigid.y(), 0.0});
  const double slope =
      rigid.any() ? std::hypot(linear.longitudinal, linear.lateral) / rigid.norm() : 0.0;
  const double saturation = polach_saturation(polach_gradient(slope * size, bound),
                                              options.adhesion_reduction, options.slip_reduction);
  const double scale = 1.0 + 6.3 * (1.0 - std::exp(-a / b));
  const double c23 = halfspace::kalker_coefficients(a, b, patch.material.poisson_ratio).c23;
  const double eps = 8.0 / 3.0 * b * std::sqrt(a * b) * patch.material.shear_modulus * c23 *
                     std::abs(lateral) / (bound * scale);
  const double delta = (eps * eps - 1.0) / (eps * eps + 1.0);
  const double k = eps * (delta * delta * delta / 3.0 - delta * delta / 2.0 + 1.0 / 6.0) -
                   std::pow(1.0 - delta * delta, 1.5) / 3.0;
  return {-saturation * rigid.x() / size,
          (-saturation * rigid.y() + 9.0 / 16.0 * k * scale * a * creepage.spin) / size};
}

void add_polach_keys() {
  using contact::between, contact::symbol;
  contact::Keys<PolachOptions> keys("polach", "Model `polach`");
  keys.add("adhesion_reduction", &PolachOptions::adhesion_reduction, symbol("k_A"),
           between(1e-6, 1.0), "Reduction in the adhesion area; below 1 on wet rails.");
  keys.add("slip_reduction", &PolachOptions::slip_reduction, symbol("k_S"), between(1e-6, 1.0),
           "Reduction in the slip area; at most k_A.");
  keys.section().position = 4;
  contact::add_section(keys);
}

}  // namespace

contact::ModelResult run_polach(const contact::Scene& scene, const contact::Progress& progress) {
  const EllipticPatch patch = elliptic_patch(scene);
  const auto& options = scene.options.of<PolachOptions>();
  const auto fill = [&](contact::PointResult& point) {
    if (patch.friction == 0.0) return;
    const double bound = patch.friction_at(point.creepage) * point.normal_force;
    const Eigen::Vector2d force = bound * polach_force(patch, options, point.creepage, bound);
    contact::SurfaceField& traction = point.fields.traction;
    traction.x = force.x() / point.normal_force * traction.n;
    traction.y = force.y() / point.normal_force * traction.n;
    set_forces({force.x(), force.y(), 0.0}, point);
    set_largest_tractions(point);
  };
  contact::ModelResult result =
      run_theory(scene, patch.grid, patch.normal, "polach", progress, fill);
  result.notes.push_back(
      {"theory",
       "Polach's formula gives forces only: tractions are spread like the pressure, and the "
       "adhesion area is the whole patch"});
  if (patch.falling && patch.falling->memory())
    result.notes.push_back(
        {"memory_distance", "friction is that of the rigid slip; memory_distance is neglected"});
  return result;
}

contact::ModelInfo linear_model() {
  using contact::Demand;
  contact::ModelInfo model = theory(
      "linear", "linear theory", "Kalker's linear theory: creep forces without a friction bound",
      {Demand::profiles, Demand::sections, Demand::lateral_creepage, Demand::spin},
      elliptic(run_linear, true), closed_form);
  model.bounded = false;
  return model;
}

contact::ModelInfo vermeulen_johnson_model() {
  using contact::Demand;
  return theory("vermeulen-johnson", "Vermeulen-Johnson",
                "Vermeulen and Johnson's creep forces on an ellipse; spin by Shen, Hedrick "
                "and Elkins",
                {Demand::profiles, Demand::sections, Demand::lateral_creepage, Demand::spin},
                elliptic(run_vermeulen_johnson, true), closed_form);
}

contact::ModelInfo polach_model() {
  using contact::Demand;
  contact::ModelInfo model = theory(
      "polach", "Polach", "Polach's closed form of the creep force with spin, for comparison",
      {Demand::profiles, Demand::sections, Demand::lateral_creepage, Demand::spin,
       Demand::falling_friction},
      elliptic(run_polach, true), closed_form);
  model.add_keys = add_polach_keys;
  return model;
}

}  // namespace rollfem::theories

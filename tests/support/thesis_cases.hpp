// SPDX-License-Identifier: LGPL-2.1-or-later
// The thesis's cases a, b, c and benchmark 9 (reference/benchmarks.md) as values, for tests of the
// half-space that do not read case files.
#pragma once

#include "case/case.hpp"
#include "contact/iteration/tangential.hpp"
#include "scene/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace rollfem::testing {

/// Longitudinal creepages alone.
inline std::vector<contact::Creepage> along(const std::vector<double>& creepages) {
  std::vector<contact::Creepage> all;
  for (const double xi : creepages) all.push_back({xi, 0.0, 0.0});
  return all;
}

/// Wheel of 405 mm on a rail of 2000, 500 or 100 mm, 50 kN, mu 0.55, like materials.
inline contact::Case thesis_case(char name, int across = 40,
                                 const std::vector<contact::Creepage>& creepages = {}) {
  contact::Case input;
  input.title = std::string("case ") + name;
  input.file = "test.toml";
  input.load.normal_force = 50e3;
  input.friction_coefficient = 0.55;
  input.wheel.rolling_radius = 405.0;
  input.rail.transverse_radius = name == 'a' ? 2000.0 : name == 'b' ? 500.0 : 100.0;
  input.contact_grid.elements_across = across;
  if (!creepages.empty()) input.rolling.creepages = creepages;
  return input;
}

/// Turns a case into rolling on in equal steps of that length (mm), each with this creepage.
inline void roll_on(contact::Case& input, std::size_t steps, double length,
                    const contact::Creepage& creepage = {}) {
  input.rolling.problem = contact::Problem::transient;
  input.history.assign(steps, {});
  for (contact::HistoryStep& step : input.history) step.step_length = length;
  input.rolling.creepages.assign(steps, creepage);
}

inline contact::CombinedMaterial steel() {
  return contact::combine(contact::Material{}, contact::Material{});
}

/// Two bodies of this shear modulus (MPa) and Poisson's ratio.
inline contact::CombinedMaterial alike(double shear_modulus, double poisson_ratio) {
  const contact::Material body{2.0 * shear_modulus * (1.0 + poisson_ratio), poisson_ratio};
  return contact::combine(body, body);
}

/// Hertz's pressure on an ellipse about the middle.
inline contact::Field hertz_pressure(const contact::ContactGrid& on, double a, double b,
                                     double p0) {
  return on.sample([&](double x, double y) {
    return p0 * std::sqrt(std::max(0.0, 1.0 - x * x / (a * a) - y * y / (b * b)));
  });
}

/// Rigid slip of creepages and spin, the spin taken `ahead` of the middles of elements.
inline contact::TangentialField slip_of(const contact::ContactGrid& on,
                                        const contact::Creepage& creepage, double ahead = 0.0) {
  return {
      on.sample([&](double, double y) { return creepage.longitudinal - creepage.spin * y; }),
      on.sample([&](double x, double) { return creepage.lateral + creepage.spin * (x + ahead); })};
}

/// Given Hertz pressure on a circle of 6 mm with combined creepage and spin.
struct Benchmark9 {
  double radius = 6.0;
  double force = 82000.0;
  double friction = 0.3;
  contact::Creepage creepage{-1e-3, 5e-4, 1e-4};

  static contact::CombinedMaterial material() { return alike(82000.0, 0.28); }

  contact::ContactGrid grid(int across, int margin = 3) const {
    const double cell = 2.0 * radius / across;
    return contact::ContactGrid::centred(across + 2 * margin, across + 2 * margin, cell, cell);
  }

  /// `order`: of the difference that it will be solved with, which says where the spin is taken.
  contact::TangentialProblem problem(
      const contact::ContactGrid& on,
      contact::UpwindOrder order = contact::UpwindOrder::second) const {
    const double p0 = 1.5 * force / (M_PI * radius * radius);
    return {hertz_pressure(on, radius, radius, p0),
            {slip_of(on, creepage, contact::upstream_of_spin(order, on.dx))},
            contact::coulomb(friction)};
  }
};

struct Forces {
  double x = 0.0;
  double y = 0.0;
  double moment = 0.0;
};

inline Forces forces(const contact::ContactGrid& grid, const contact::TangentialField& traction) {
  Forces sum;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int k = grid.index(i, j);
      sum.x += grid.element_area() * traction.x[k];
      sum.y += grid.element_area() * traction.y[k];
      sum.moment += grid.element_area() * (grid.x(i) * traction.y[k] - grid.y(j) * traction.x[k]);
    }
  return sum;
}

}  // namespace rollfem::testing

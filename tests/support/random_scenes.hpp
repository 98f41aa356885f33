// SPDX-License-Identifier: LGPL-2.1-or-later
// Random scenes for the model halfspace, each from a seed and its number, for the coverage of error
// bars. Milder than random_contact.hpp, which tries to break solvers: every solution here has a
// realistic patch. Half of the scenes have bodies that are not ellipsoids.
#pragma once

#include "halfspace/model/halfspace_model.hpp"
#include "scene/scene.hpp"

#include "tests/support/random_draws.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::testing {

/// A scene without its contact grid.
struct RandomScene {
  contact::Scene scene;
  std::string shape;          ///< of the undeformed distance
  std::string motion;         ///< "rolling", "spin", "force", "shift", "transient"
  double length = 0.0;        ///< mm, of the patch without friction
  double width = 0.0;         ///< mm
  double max_pressure = 0.0;  ///< MPa, likewise
  bool unlike = false;        ///< materials

  /// With this many elements across both extents of the patch.
  contact::Scene across(int elements) const {
    contact::Scene gridded = scene;
    gridded.contact_grid.cell_size = {{length / elements, width / elements}};
    return gridded;
  }
};

class RandomScenes : private RandomDraws {
 public:
  explicit RandomScenes(unsigned seed) : RandomDraws(seed) {}

  RandomScene scene(unsigned number) {
    begin(number);
    RandomScene random;
    contact::Scene& scene = random.scene;
    scene.file = "random scene " + std::to_string(number);
    scene.wheel.material = scene.rail.material = material(80e3);
    random.unlike = chance(0.25);
    if (random.unlike) scene.rail.material = material(80e3 * log_uniform(0.2, 5.0));
    scene.material = contact::combine(scene.wheel.material, scene.rail.material);
    scene.friction_law = contact::coulomb(log_uniform(0.05, 1.0));
    random.shape = shape(scene);
    const contact::PointResult pressed = press(scene);
    random.length = pressed.contact_length;
    random.width = pressed.contact_width;
    random.max_pressure = pressed.max_pressure;
    contact::LoadPoint point = scene.points.front();
    if (chance(0.5)) point.load = {pressed.normal_force, {}};
    random.motion = move(scene, point, pressed);
    return random;
  }

  /// Lets its friction fall where the surfaces slide, to 0.2 to 1 of that at rest at slips from a
  /// third of those at saturation to 300 times these, with memory in three of four; adds a layer to
  /// half of them. From the same stream, after the scene.
  void let_fall(RandomScene& random) {
    contact::Scene& scene = random.scene;
    const bool shifts = scene.problem == contact::Problem::shift;
    const double mu = scene.friction_coefficient(), part = uniform(0.2, 1.0);
    const contact::FallShape& shape =
        contact::fall_shapes().at(1 + static_cast<std::size_t>(uniform(0.0, 2.999)));
    const double second = chance(0.3) ? uniform(0.0, 1.0) : 0.0;
    const auto fall = [&](double share) {
      const double half_slip = mu * log_uniform(5e-3, 5.0) * (shifts ? 0.5 * reach : 1.0);
      return contact::FallingFriction::Part{share * (1.0 - part) * mu, half_slip};
    };
    const std::array<contact::FallingFriction::Part, 2> parts{fall(1.0 - second), fall(second)};
    const double distance = log_uniform(1e-3, 1e-2);
    std::optional<contact::FrictionMemory> memory;
    if (chance(0.75)) memory = contact::FrictionMemory{distance, shifts ? 1e-5 : 1e-4};
    scene.friction_law =
        std::make_shared<contact::FallingFriction>(shape, part * mu, parts, memory);
    if (chance(0.5))
      scene.material.layer = log_uniform(0.03, 10.0) * reach / scene.material.shear_modulus;
    limit_forces(scene, part);  // below what slides at any velocity
  }

  /// Adds a layer that yields at 0.1 to 1 of mu p_0, which is elastic too in half of them:
  /// perfectly plastic, hardening, or softening by up to 0.3 G over the size of the patch. From the
  /// same stream, after the scene.
  void let_yield(RandomScene& random) {
    contact::Scene& scene = random.scene;
    const double unit = scene.material.shear_modulus / reach;
    const double part = log_uniform(0.1, 1.0);
    const double kind = uniform(0.0, 3.0), size = unit * log_uniform(1e-2, 1.0);
    auto law = std::make_shared<contact::CoulombFriction>(scene.friction_coefficient());
    law->plasticity = contact::Plasticity{part * scene.friction_coefficient() * random.max_pressure,
                                          kind < 1.0   ? 0.0
                                          : kind < 2.0 ? 10.0 * size
                                                       : -0.3 * size};
    scene.friction_law = law;
    if (chance(0.5)) scene.material.layer = log_uniform(0.03, 10.0) / unit;
    limit_forces(scene, 0.5 * part);
  }

  /// Friction that changes across the patch to 0.2 to 1 of the largest, linearly or within a tenth
  /// of the width. From the same stream, after the scene.
  void let_vary(RandomScene& random) {
    contact::Scene& scene = random.scene;
    const double most = scene.friction_coefficient(), part = uniform(0.2, 1.0);
    const double width = random.width * (chance(0.5) ? 1.0 : 0.1);
    const double middle = random.width * uniform(-0.3, 0.3), side = sign();
    scene.friction_law =
        std::make_shared<contact::VaryingFriction>(contact::coulomb(most), [=](double y) {
          const double lies = std::clamp(0.5 + side * (y - middle) / width, 0.0, 1.0);
          return contact::coulomb(most * (part + (1.0 - part) * lies));
        });
    limit_forces(scene, part);
  }

  /// An integer from the same stream, after the scene.
  int choose(const std::vector<int>& among) {
    const auto at = static_cast<std::size_t>(uniform(0.0, 1.0) * static_cast<double>(among.size()));
    return among[std::min(at, among.size() - 1)];
  }

 private:
  /// Undeformed distance over u = x/X and v = y/Y, of some 1 where the bodies are an approach
  /// apart.
  struct Polynomial {
    double u2 = 0.0, u4 = 0.0, v1 = 0.0, v2 = 0.0, v3 = 0.0, v4 = 0.0, uv = 0.0;
    double operator()(double u, double v) const {
      return u * u * (u2 + u4 * u * u) + v * (v1 + v * (v2 + v * (v3 + v * v4))) + uv * u * v;
    }
  };

  static void limit_forces(contact::Scene& scene, double part) {
    for (contact::LoadPoint& point : scene.points)
      for (auto* force : {&point.force.longitudinal, &point.force.lateral})
        if (*force) **force *= part;
  }

  static constexpr double approach = 0.05;  ///< mm
  static constexpr double reach = 6.0;      ///< mm, sqrt(X Y)

  std::string shape(contact::Scene& scene) {
    const double ratio = log_uniform(0.1, 10.0);
    const double x = reach * std::sqrt(ratio);
    const double y = reach / std::sqrt(ratio);
    contact::LoadPoint point;
    point.load.approach = approach;
    scene.points = {point};
    const double kind = uniform(0.0, 1.0);
    if (kind < 0.45) return radii(scene, x, y);
    Polynomial h;
    std::string name;
    if (kind < 0.54) {
      h.u2 = h.v4 = 1.0;
      name = "x^2 + y^4";
    } else if (kind < 0.62) {
      h.u4 = h.v2 = 1.0;
      name = "x^4 + y^2";
    } else if (kind < 0.70) {
      h.u4 = h.v4 = 1.0;
      name = "x^4 + y^4";
    } else if (kind < 0.88) {
      h.u2 = uniform(0.2, 1.0);
      h.u4 = 1.0 - h.u2;
      h.v2 = uniform(0.2, 1.0);
      h.v4 = 1.0 - h.v2;
      // Convex across, and positive definite.
      h.v3 = uniform(-0.8, 0.8) * std::sqrt(8.0 / 3.0 * h.v2 * h.v4);
      h.uv = uniform(-1.2, 1.2) * std::sqrt(h.u2 * h.v2);
      name = "mixed";
    } else {
      const double hill = uniform(0.1, 0.9);  // between the bumps
      h.u2 = 1.0;
      h.v4 = uniform(0.5, 4.0);
      h.v2 = -2.0 * std::sqrt(h.v4 * hill);
      h.v1 = uniform(-0.2, 0.2) * std::abs(h.v2);
      name = "two bumps";
    }
    scene.geometry.distance_values = lattice(h, x, y);
    return name;
  }

  /// Radii whose curvature across is shared out between wheel and rail: the wheel's alone brings a
  /// slip of its own.
  std::string radii(contact::Scene& scene, double x, double y) {
    const double across = 2.0 * approach / (y * y);
    const double share = chance(0.5) ? 0.0 : uniform(-2.0, 2.0);
    scene.geometry.surface.rolling_radius = x * x / (2.0 * approach);
    if (share != 0.0) scene.geometry.surface.wheel_transverse_radius = 1.0 / (share * across);
    scene.geometry.surface.rail_transverse_radius = 1.0 / ((1.0 - share) * across);
    return share == 0.0 ? "ellipse" : "ellipse, curved";
  }

  static contact::Lattice lattice(const Polynomial& h, double x, double y) {
    constexpr int points = 201;
    constexpr double room = 1.2;
    double lower = 0.0, upper = 0.0, along = 0.0, least = 0.0;
    for (double u = -3.0; u <= 3.0; u += 0.02)
      for (double v = -3.0; v <= 3.0; v += 0.02) least = std::min(least, h(u, v));
    for (double u = -3.0; u <= 3.0; u += 0.02)
      for (double v = -3.0; v <= 3.0; v += 0.02) {
        if (h(u, v) - least > 1.0) continue;
        lower = std::min(lower, v);
        upper = std::max(upper, v);
        along = std::max(along, std::abs(u));
      }
    const double middle = 0.5 * (upper + lower);
    const double half = 0.5 * (upper - lower);
    contact::Lattice lattice;
    lattice.file = "polynomial";
    lattice.nx = lattice.ny = points;
    lattice.dx = 2.0 * room * along * x / (points - 1);
    lattice.dy = 2.0 * room * half * y / (points - 1);
    lattice.x_first = -room * along * x;
    lattice.y_first = (middle - room * half) * y;
    lattice.values.emplace_back();
    for (int j = 0; j < points; ++j)
      for (int i = 0; i < points; ++i)
        lattice.values[0].push_back(approach * (h((lattice.x_first + i * lattice.dx) / x,
                                                  (lattice.y_first + j * lattice.dy) / y) -
                                                least));
    return lattice;
  }

  /// Without friction, on a coarse grid.
  static contact::PointResult press(contact::Scene scene) {
    scene.problem = contact::Problem::frictionless;
    scene.contact_grid.elements_across = 24;
    return halfspace::run_halfspace(scene, {}).points.front();
  }

  /// Creepages from a hundredth of saturation to some times it.
  std::string move(contact::Scene& scene, contact::LoadPoint point,
                   const contact::PointResult& pressed) {
    const double a = pressed.semi_axis_x, b = pressed.semi_axis_y, c = std::sqrt(a * b);
    const double bound = scene.friction_coefficient() * pressed.normal_force;
    const double shear = scene.material.shear_modulus;
    const auto part = [&](double saturation) {
      return sign() * saturation * log_uniform(0.02, 4.0);
    };
    const double kind = uniform(0.0, 1.0);
    if (kind < 0.10) return shift(scene, point, bound / (2.0 * shear * c), c);
    const double rolling = bound / (shear * a * b);
    if (kind < 0.20) return force(scene, point, bound, rolling / c);
    const bool transient = kind < 0.30;
    const bool spin = kind > 0.90;
    if (!spin && chance(0.8)) point.creepage.longitudinal = part(rolling);
    if (!spin && chance(0.6)) point.creepage.lateral = part(rolling);
    if (spin || chance(0.5)) point.creepage.spin = part(rolling / c);
    scene.points = {point};
    if (!transient) return spin ? "spin" : "rolling";
    scene.problem = contact::Problem::transient;
    scene.points.front().step_length = 2.0 * a * log_uniform(0.1, 1.0);
    scene.points.assign(3, scene.points.front());
    return "transient";
  }

  std::string force(contact::Scene& scene, contact::LoadPoint point, double bound, double spin) {
    const double size = bound * uniform(0.05, 0.9);
    const double angle = uniform(0.0, 2.0 * M_PI);
    if (chance(0.4)) point.creepage.spin = sign() * spin * log_uniform(0.02, 0.5);
    point.force.longitudinal = size * std::cos(angle);
    if (chance(0.6)) point.force.lateral = size * std::sin(angle);
    scene.points = {point};
    return "force";
  }

  /// There, and half of the way back.
  std::string shift(contact::Scene& scene, contact::LoadPoint point, double saturation, double c) {
    scene.problem = contact::Problem::shift;
    const auto part = [&] { return sign() * saturation * log_uniform(0.05, 2.0); };
    if (chance(0.8)) point.longitudinal_shift = part();
    if (chance(0.5)) point.lateral_shift = part();
    if (chance(0.3)) point.spin_shift = part() / c;
    scene.points = {point, point};
    for (double contact::LoadPoint::*way :
         {&contact::LoadPoint::longitudinal_shift, &contact::LoadPoint::lateral_shift,
          &contact::LoadPoint::spin_shift})
      scene.points.back().*way *= -0.5;
    return "shift";
  }
};

}  // namespace rollfem::testing

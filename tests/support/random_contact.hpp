// SPDX-License-Identifier: LGPL-2.1-or-later
// Random contact problems of half-spaces, each from a seed and its number, so that any of them can
// be made again: the tangential solver has to solve them all.
#pragma once

#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/patch_search.hpp"

#include "tests/support/random_draws.hpp"
#include <array>
#include <cmath>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::testing {

enum class RandomKind { rolling, force, shift, transient };

inline const char* name_of(RandomKind kind) {
  constexpr const char* names[] = {"rolling", "prescribed force", "shift", "transient"};
  return names[static_cast<int>(kind)];
}

/// A patch of sqrt(a b) = 5 mm under p_0 = 1000 MPa, which scaling makes any other.
struct RandomContact {
  RandomKind kind = RandomKind::rolling;
  int across = 20;
  double a = 5.0, b = 5.0;  ///< semi-axes along and across rolling, mm
  double friction = 0.3;
  contact::Material wheel, rail;
  bool given_pressure = true;   ///< Hertz's; false: solved for
  contact::Creepage creepage;   ///< shifts in mm and rad for RandomKind::shift
  Eigen::Vector2d force{0, 0};  ///< over mu F_z, on the wheel
  double step = 0.0;            ///< mm, RandomKind::transient
  contact::Friction falling;    ///< in place of Coulomb's law
  double layer = 0.0;           ///< h/G, mm/MPa

  static constexpr double max_pressure = 1000.0;
  double normal_force() const { return 2.0 / 3.0 * M_PI * a * b * max_pressure; }
  contact::CombinedMaterial material() const {
    contact::CombinedMaterial combined = contact::combine(wheel, rail);
    combined.layer = layer;
    return combined;
  }

  contact::Scene scene() const {
    contact::Scene scene;
    scene.wheel.material = wheel;
    scene.rail.material = rail;
    scene.material = material();
    scene.friction_law = falling ? falling : contact::coulomb(friction);
    scene.given_pressure = contact::GivenPressure{a, b, max_pressure};
    if (!given_pressure) {
      // Of bodies with this contact of Hertz.
      const contact::Curvatures bodies = halfspace::curvatures_of_scene(scene);
      scene.geometry.quadratic = {bodies.A, bodies.B};
      scene.given_pressure.reset();
    }
    contact::LoadPoint point;
    point.load.force = normal_force();
    point.creepage = creepage;
    point.longitudinal_shift = creepage.longitudinal;
    point.lateral_shift = creepage.lateral;
    point.spin_shift = creepage.spin;
    point.step_length = step;
    if (kind == RandomKind::force) {
      point.force.longitudinal = force.x() * friction * normal_force();
      point.force.lateral = force.y() * friction * normal_force();
    }
    scene.points = {point};
    if (kind == RandomKind::shift) scene.problem = contact::Problem::shift;
    if (kind != RandomKind::transient) return scene;
    scene.problem = contact::Problem::transient;
    scene.points.assign(3, point);  // from the pressure alone
    return scene;
  }
};

/// Effort of the solver for a contact on one grid: the largest numbers of any of its load points.
struct RandomOutcome {
  bool solved = true;
  bool chatters = false;  ///< there is no stable state
  std::string message;    ///< why it is not
  int newton_steps = 0;
  int krylov_iterations = 0;
  int outer_iterations = 0;  ///< between pressure and friction of unlike materials
};

class RandomContacts : private RandomDraws {
 public:
  explicit RandomContacts(unsigned seed) : RandomDraws(seed) {}

  /// Contact `number` of the seed, at this many elements across.
  RandomContact contact(unsigned number, int across) {
    begin(number);
    RandomContact c;
    c.across = across;
    const double kind = uniform(0.0, 1.0);
    c.kind = kind < 0.7    ? RandomKind::rolling
             : kind < 0.8  ? RandomKind::force
             : kind < 0.88 ? RandomKind::shift
                           : RandomKind::transient;
    const double ratio = log_uniform(1.0 / 30.0, 30.0);
    c.a = 5.0 * std::sqrt(ratio);
    c.b = 5.0 / std::sqrt(ratio);
    c.friction = log_uniform(1e-3, 10.0);
    c.given_pressure = chance(0.5);
    c.wheel = c.rail = material(80e3);
    if (chance(0.2)) {
      c.rail = material(80e3 * log_uniform(0.1, 10.0));
      c.given_pressure = false;
    }
    move(c);
    return c;
  }

  /// The same with friction that falls and, in half of them, a layer, at 10 m/s: s_h from 1 mm/s to
  /// 1e6, mu_kin/mu from 0.2 to 1, d_c from 1e-4 to 0.1 mm or 0.
  RandomContact falling_contact(unsigned number, int across, bool remembers) {
    RandomContact c = contact(number, across);
    constexpr double speed = 1e4, s_0 = 1.0;
    const contact::FallShape& shape =
        contact::fall_shapes().at(1 + static_cast<std::size_t>(uniform(0.0, 2.999)));
    const double kinetic = c.friction * uniform(0.2, 1.0);
    const double second = chance(0.3) ? uniform(0.0, 1.0) : 0.0;
    const auto part = [&](double share) {
      return contact::FallingFriction::Part{share * (c.friction - kinetic),
                                            log_uniform(1.0, 1e6) / speed};
    };
    const std::array<contact::FallingFriction::Part, 2> parts{part(1.0 - second), part(second)};
    const double distance = log_uniform(1e-4, 0.1);
    std::optional<contact::FrictionMemory> memory;
    if (remembers) memory = contact::FrictionMemory{distance, s_0 / speed};
    c.falling = std::make_shared<contact::FallingFriction>(shape, kinetic, parts, memory);
    const double size = std::sqrt(c.a * c.b);
    if (chance(0.5)) c.layer = log_uniform(1e-3, 1e2) * size / c.material().shear_modulus;
    // Below what slides at any velocity: above, there need not be a creepage.
    c.force *= 0.9 * kinetic / c.friction;
    return c;
  }

  /// The same with a layer that yields at 0.03 to 1.5 times mu p_0, elastic too in half of them:
  /// perfectly plastic, hardening until it is stiff beside the bodies, softening up to 0.3 of them.
  RandomContact yielding_contact(unsigned number, int across) {
    RandomContact c = contact(number, across);
    auto law = std::make_shared<contact::CoulombFriction>(c.friction);
    const double unit = c.material().shear_modulus / std::sqrt(c.a * c.b);
    const double kind = uniform(0.0, 3.0), stiff = unit * log_uniform(1e-3, 1e3);
    const double soft = 0.3 * unit * log_uniform(1e-3, 1.0);
    const double stress = c.friction * RandomContact::max_pressure * log_uniform(0.03, 1.5);
    law->plasticity = contact::Plasticity{stress, kind < 1.0 ? 0.0 : kind < 2.0 ? stiff : -soft};
    c.falling = law;
    if (chance(0.5)) c.layer = log_uniform(1e-3, 1e2) / unit;
    if (c.kind == RandomKind::force) c.kind = RandomKind::rolling;
    return c;
  }

 private:
  /// Creepages from 1e-5 of saturation to 30 times it; the pole of the spin in or near the patch in
  /// a third.
  void move(RandomContact& c) {
    const double size = std::sqrt(c.a * c.b);
    const double bound = c.friction * c.normal_force();
    const double shear = c.material().shear_modulus;
    const bool shifts = c.kind == RandomKind::shift;
    // About where all of the patch slips: by the stiffness without slip, 4 G a b or 8/3 G c.
    const double saturation = shifts ? bound / (2.0 * shear * size) : bound / (shear * c.a * c.b);
    const auto part = [&] { return sign() * log_uniform(1e-5, 30.0); };
    if (chance(0.8)) c.creepage.spin = saturation / size * part();
    if (c.creepage.spin != 0.0 && chance(0.4)) {
      c.creepage.longitudinal = c.creepage.spin * c.b * uniform(-1.5, 1.5);
      c.creepage.lateral = c.creepage.spin * c.a * uniform(-1.5, 1.5);
    } else {
      if (chance(0.8)) c.creepage.longitudinal = saturation * part();
      if (chance(0.8)) c.creepage.lateral = saturation * part();
    }
    if (c.kind == RandomKind::transient) c.step = 2.0 * c.a * log_uniform(0.1, 3.0);
    if (c.kind != RandomKind::force) return;
    // Some spin leaves the force free; what all of the spin's slip would need is another problem.
    c.creepage.spin = chance(0.5) ? 0.0 : saturation / size * sign() * log_uniform(1e-5, 1.0);
    const double angle = uniform(0.0, 2.0 * M_PI);
    const double part_of_bound = chance(0.3) ? 1.0 - log_uniform(1e-3, 0.3) : uniform(0.0, 0.9);
    c.force = part_of_bound * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
};

/// Start of a grid in steady rolling: as in the models from grids of twice the cell size, down to
/// 10 elements across; or a cold start. Steps of a history start from the previous step.
enum class RandomStart { nested, scratch };

/// Solves a random contact; the outcome is that of its own grid. As in the models, a coarser grid
/// without a solution for unlike materials is skipped.
inline RandomOutcome run_random(const RandomContact& contact, RandomStart start) {
  std::vector<int> sizes{contact.across};
  while (start == RandomStart::nested && sizes.back() / 2 >= 10) sizes.push_back(sizes.back() / 2);
  const contact::Scene scene = contact.scene();
  const halfspace::PatchSearch area(scene);
  std::optional<contact::LevelResult> coarser;
  RandomOutcome outcome;
  for (; !sizes.empty(); sizes.pop_back()) {
    outcome = {};
    try {
      coarser = halfspace::solve_level(scene, area, 2.0 * contact.a / sizes.back(),
                                       2.0 * contact.b / sizes.back(),
                                       coarser ? &*coarser : nullptr, "", {});
      outcome.newton_steps = coarser->newton_steps;
      outcome.krylov_iterations = coarser->krylov_iterations;
      if (scene.material.couples()) outcome.outer_iterations = coarser->iterations;
    } catch (const std::exception& error) {
      outcome.solved = false;
      outcome.chatters = dynamic_cast<const contact::NoSteadyFriction*>(&error) != nullptr;
      outcome.message = error.what();
      coarser.reset();
      if (!scene.material.couples()) break;
    }
  }
  return outcome;
}

}  // namespace rollfem::testing

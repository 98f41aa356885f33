// SPDX-License-Identifier: LGPL-2.1-or-later
// Random contact problems of half-spaces, each from a seed and its number, so that any of them can
// be made again: the tangential solver has to solve them all.
#pragma once

#include "contact/base/errors.hpp"
#include "contact/iteration/interpolation.hpp"
#include "contact/solve/contact_problem.hpp"
#include "contact/solve/point_motion.hpp"
#include "contact/solve/prescribed_force.hpp"
#include "halfspace/elasticity/compliance.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "halfspace/model/level.hpp"

#include "tests/support/random_draws.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>
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
  int margin = 3;           ///< elements around the patch of Hertz
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
  contact::Friction law() const { return falling ? falling : contact::coulomb(friction); }
  contact::ContactGrid grid() const {
    const int elements = across + 2 * margin;
    return contact::ContactGrid::centred(elements, elements, 2.0 * a / across, 2.0 * b / across);
  }
};

/// Effort of the solver for a contact on one grid: the largest numbers of any of its problems.
struct RandomOutcome {
  bool solved = true;
  bool chatters = false;  ///< there is no stable state
  std::string message;    ///< why it is not
  int problems = 0;
  int newton_steps = 0;
  int krylov_iterations = 0;
  int outer_iterations = 0;  ///< between pressure and friction of unlike materials

  void add(const contact::TangentialSolution& solution) {
    ++problems;
    newton_steps = std::max(newton_steps, solution.newton_steps);
    krylov_iterations = std::max(krylov_iterations, solution.krylov_iterations);
  }
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
    const auto shape = static_cast<contact::FallShape>(1 + static_cast<int>(uniform(0.0, 2.999)));
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

/// Undeformed distance whose Hertz contact has these semi-axes and this pressure (Johnson 4.26).
inline contact::Field hertz_distance(const RandomContact& c, const contact::ContactGrid& grid) {
  const double large = std::max(c.a, c.b), small = std::min(c.a, c.b);
  const double e2 = 1.0 - small * small / (large * large);
  const double scale = RandomContact::max_pressure / c.material().contact_modulus;
  double along_large = M_PI * scale / (4.0 * large), along_small = along_large;
  if (e2 > 1e-8) {
    const double e = std::sqrt(e2);
    const double first = std::comp_ellint_1(e), second = std::comp_ellint_2(e);
    const double factor = scale * small / (e2 * large * large);
    along_large = factor * (first - second);
    along_small = factor * (large * large / (small * small) * second - first);
  }
  const double along_x = c.a >= c.b ? along_large : along_small;
  const double along_y = c.a >= c.b ? along_small : along_large;
  return grid.sample([&](double x, double y) { return along_x * x * x + along_y * y * y; });
}

/// Start of a grid in steady rolling: as in the models from grids of twice the cell size, down to
/// 10 elements across; or a cold start. Steps of a history start from the previous step.
enum class RandomStart { nested, scratch };

/// One random contact on one grid.
class RandomLevel {
 public:
  /// `coarser` (may be null): the same contact on a coarser grid, solved.
  RandomLevel(const RandomContact& c, const RandomLevel* coarser)
      : contact_(c), grid_(c.grid()), whole_(grid_, c.material()), coarser_(coarser) {
    if (c.material().couples())
      standin_ = std::make_unique<halfspace::HalfspaceCompliance>(grid_, c.material().uncoupled());
    contact::ContactConditions conditions;
    conditions.friction = c.law();
    if (c.given_pressure)
      conditions.given_pressure = grid_.sample([&](double x, double y) {
        const double rest = 1.0 - x * x / (c.a * c.a) - y * y / (c.b * c.b);
        return rest > 0.0 ? RandomContact::max_pressure * std::sqrt(rest) : 0.0;
      });
    else
      conditions.undeformed_distance = hertz_distance(c, grid_);
    problem_ = std::make_unique<contact::ContactProblem>(whole_, standin_ ? *standin_ : whole_,
                                                         std::move(conditions));
    load_.force = c.normal_force();
  }

  RandomOutcome run() {
    try {
      if (contact_.kind == RandomKind::force)
        find_force();
      else if (contact_.kind == RandomKind::transient)
        roll_on();
      else
        solve(motion(contact_.creepage), first_state());
    } catch (const contact::UnfitGrid&) {
      unfit_ = true;
    } catch (const contact::NoSteadyFriction& error) {
      outcome_.solved = false;
      outcome_.chatters = true;
      outcome_.message = error.what();
    } catch (const std::exception& error) {
      outcome_.solved = false;
      outcome_.message = error.what();
    }
    return outcome_;
  }

  /// Under much friction unlike materials carry their patch to where Hertz has none.
  bool reaches_border() const {
    return unfit_ || (outcome_.solved && contact::touches_border(grid_, state_.normal.pressure));
  }

 private:
  contact::TangentialField rigid(const contact::Creepage& c) const {
    return contact::uniform_slip(c, grid_);
  }

  contact::TangentialMotion motion(const contact::Creepage& c) const {
    contact::TangentialMotion result;
    result.rigid_slip = rigid(c);
    if (contact_.kind != RandomKind::shift) return result;
    result.motion = contact::Motion::shift;
    if (remembers()) result.past = contact::friction_after(contact_.law(), grid_);
    if (remembers()) result.past->length = 1.0;
    return result;
  }

  bool remembers() const {
    return contact_.law()->memory().has_value() || contact_.law()->plasticity;
  }
  /// As contact::ContactRun begins.
  contact::ContactState first_state() {
    contact::ContactState start;
    const bool nested = coarser_ != nullptr;
    start.normal = problem_->press(
        load_, nested
                   ? contact::interpolated(coarser_->grid_, coarser_->state_.normal.pressure, grid_)
                   : contact::Field());
    const bool steady = contact_.kind == RandomKind::rolling || contact_.kind == RandomKind::force;
    if (!nested || !steady) return start;
    const contact::Friction friction = contact_.law();
    const contact::Field& pressure = coarser_->state_.normal.pressure;
    start.tangential.traction = contact::finer_tractions(
        coarser_->grid_, pressure,
        contact::relative_to_bound(coarser_->state_.tangential.traction,
                                   contact::traction_bound(friction, coarser_->grid_, pressure)),
        grid_, contact::traction_bound(friction, grid_, start.normal.pressure));
    return start;
  }

  void solve(const contact::TangentialMotion& motion, const contact::ContactState& start,
             const contact::ContactAccuracy& accuracy = {}) {
    state_ = problem_->solve(load_, motion, &start, accuracy,
                             [this](const contact::ContactState& outer) { count(outer); });
    if (!standin_) outcome_.add(state_.tangential);
  }

  void count(const contact::ContactState& outer) {
    outcome_.add(outer.tangential);
    outcome_.outer_iterations = std::max(outcome_.outer_iterations, outer.iterations);
  }

  void find_force() {
    state_ = first_state();
    const double bound = contact_.friction * state_.normal.normal_force;
    const contact::PrescribedForce wanted{contact_.force.x() * bound, contact_.force.y() * bound};
    contact::ForceSearch search;
    search.has_peak = contact_.falling != nullptr;
    search.stiffness = halfspace::rolling_stiffness(
        contact::patch_size(grid_, state_.normal.pressure), contact_.material());
    search.start = coarser_ ? coarser_->found_
                            : contact::first_creepage(wanted, {0.0, 0.0}, search.stiffness, bound);
    const contact::ForceLaw law = [&](const Eigen::Vector2d& creepage) {
      solve(motion({creepage.x(), creepage.y(), contact_.creepage.spin}),
            contact::ContactState(state_), halfspace::accuracy_of_force_search);
      return contact::TransmittedForce{
          grid_.element_area() * Eigen::Vector2d(state_.tangential.traction.x.sum(),
                                                 state_.tangential.traction.y.sum()),
          bound};
    };
    found_ = contact::find_creepage(law, wanted, search).creepage;
  }

  /// Three equal steps from the pressure alone.
  void roll_on() {
    contact::History history(grid_, contact::UpwindOrder::second);
    const contact::Field none = contact::Field::Zero(grid_.size());
    history.advance({none, none}, 0.0, contact::friction_after(contact_.law(), grid_));
    state_ = first_state();
    for (int step = 0; step < 3; ++step) {
      contact::TangentialMotion motion =
          history.rolling_step(rigid(contact_.creepage), contact_.step);
      if (remembers()) motion.past = history.past(contact_.step);
      solve(motion, contact::ContactState(state_));
      history.advance({state_.displacement.x, state_.displacement.y}, contact_.step,
                      contact::friction_after(contact_.law(), grid_, state_));
    }
  }

  RandomContact contact_;
  contact::ContactGrid grid_;
  halfspace::HalfspaceCompliance whole_;
  std::unique_ptr<halfspace::HalfspaceCompliance> standin_;  ///< null for like materials
  const RandomLevel* coarser_;
  std::unique_ptr<contact::ContactProblem> problem_;
  contact::NormalLoad load_;
  contact::ContactState state_;
  Eigen::Vector2d found_ = Eigen::Vector2d::Zero();  ///< creepages of the force
  bool unfit_ = false;                               ///< no state on this grid, which is too small
  RandomOutcome outcome_;
};

/// Solves a contact on one grid, which grows until it holds the patch.
inline std::unique_ptr<RandomLevel> run_level(RandomContact contact, const RandomLevel* coarser,
                                              RandomOutcome& outcome) {
  constexpr int most_enlargements = 4;
  for (int k = 0;; ++k) {
    auto level = std::make_unique<RandomLevel>(contact, coarser);
    outcome = level->run();
    if (!level->reaches_border()) return level;
    if (k < most_enlargements) {
      contact.margin += contact.across / 4 + 3;
      continue;
    }
    outcome.solved = false;
    outcome.message = "the patch reaches the border of the grid";
    return level;
  }
}

/// Solves a random contact; the outcome is that of its own grid. As in the models, a coarser grid
/// without a solution for unlike materials is skipped.
inline RandomOutcome run_random(const RandomContact& contact, RandomStart start) {
  std::vector<int> sizes{contact.across};
  while (start == RandomStart::nested && sizes.back() / 2 >= 10) sizes.push_back(sizes.back() / 2);
  std::unique_ptr<RandomLevel> coarser;
  RandomOutcome outcome;
  for (; !sizes.empty(); sizes.pop_back()) {
    RandomContact on_grid = contact;
    on_grid.across = sizes.back();
    std::unique_ptr<RandomLevel> level = run_level(on_grid, coarser.get(), outcome);
    if (!outcome.solved && !contact.material().couples()) break;
    coarser = outcome.solved ? std::move(level) : nullptr;
  }
  return outcome;
}

}  // namespace rollfem::testing

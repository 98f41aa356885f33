// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/balance/position.hpp"

#include "base/errors.hpp"
#include "base/root.hpp"
#include "base/threads.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/load_sharing.hpp"
#include "track/balance/creepage_errors.hpp"
#include "track/motion/wheelset_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::track {

using contact::Case;
using contact::FreeRolling;

namespace {

/// The balance ends when the normal forces change by less than this fraction of the load.
constexpr double load_tolerance = 1e-4;
/// Torque below this fraction of mu F_z R counts as zero.
constexpr double torque_tolerance = 1e-5;
/// Forces are good to half a percent of mu F_z (docs/accuracy.md); the sine of the contact angle
/// lessens their effect on the balance, and the rotation feels both wheels alike.
constexpr int elements_of_balance = 24;

struct Patch {
  PlacedScene placed;
  std::vector<PatchForce> force{};  ///< per load point, for the current scene
  std::vector<double> vertical{};   ///< N, its share per load point, with this friction
};

struct Wheel {
  bool left = true;
  std::vector<Patch> patches;
};

/// Force prescribed by the scene at load point k, 0 where it prescribes an approach.
double asked_force(const Patch& patch, std::size_t k) {
  return patch.placed.scene.points[k].load.force.value_or(0.0);
}

double largest_force(const Patch& patch) {
  double largest = 0.0;
  for (std::size_t k = 0; k < patch.placed.scene.points.size(); ++k)
    largest = std::max(largest, asked_force(patch, k));
  return largest;
}

class Position {
 public:
  Position(const Case& input, const std::vector<PlacedScene>& scenes, int elements_across)
      : input_(input),
        elements_across_(elements_across),
        rotation_(rotation_changes(input)),
        free_(input.wheelset.free_rolling) {
    for (const PlacedScene& scene : scenes) {
      const bool left = scene.contact.place.left;
      if (wheels_.empty() || wheels_.back().left != left) wheels_.push_back({left, {}});
      wheels_.back().patches.push_back({scene});
    }
  }

  std::vector<contact::Scene> balanced() {
    share_all(false);
    for (Wheel& wheel : wheels_) turn(wheel);
    if (needs_forces()) settle();
    for (Wheel& wheel : wheels_) ask_for_vertical_forces(wheel);
    return scenes();
  }

 private:
  /// A single patch needs no balance: every model solves its vertical force with friction.
  bool shares(const Wheel& wheel) const {
    return input_.load.vertical_force && wheel.patches.size() > 1;
  }

  bool needs_forces() const {
    const bool friction =
        input_.friction_coefficient > 0.0 && input_.rolling.problem == contact::Problem::steady;
    return friction && (free_ != FreeRolling::none ||
                        std::any_of(wheels_.begin(), wheels_.end(),
                                    [this](const Wheel& wheel) { return shares(wheel); }));
  }

  /// Alternates between the free rotation and the shares of the load with friction.
  void settle() {
    constexpr int most_rounds = 30;
    for (int round = 0; round < most_rounds; ++round) {
      if (free_ == FreeRolling::torque) find_rotation(0, wheels_.size());
      if (free_ == FreeRolling::force)
        for (std::size_t w = 0; w < wheels_.size(); ++w) find_rotation(w, w + 1);
      if (free_ == FreeRolling::none) solve(0, wheels_.size());
      const double change = share_all(true);
      if (change < load_tolerance) return;
    }
    throw contact::SolveError(
        fmt::format("the normal forces under {:g} N and friction do not converge in {} iterations",
                    *input_.load.vertical_force, most_rounds));
  }

  /// Shares the loads of all wheels; returns the largest relative change.
  double share_all(bool friction) {
    std::vector<double> changes(wheels_.size(), 0.0);
    contact::for_each_index(wheels_.size(), [&](std::size_t w) {
      if (!friction || shares(wheels_[w])) changes[w] = share(wheels_[w], friction);
    });
    return *std::max_element(changes.begin(), changes.end());
  }

  /// Normal forces of a wheel's patches under its load; returns their largest change relative to
  /// it. With friction, the tangential forces keep their ratio to the normal force.
  double share(Wheel& wheel, bool friction) {
    if (input_.sinks()) {
      drop_untouched(wheel);
      press_at_approach(wheel);
    }
    if (!shares(wheel)) return 0.0;
    const double load = *input_.load.vertical_force;
    double change = 0.0;
    std::vector<halfspace::SharedLoad> shared;
    for (Patch& patch : wheel.patches) patch.vertical.resize(rotation_.size());
    for (std::size_t k = 0; k < rotation_.size(); ++k) {
      // Geometry and elasticity determine the sharing; friction changes the force to be shared.
      if (k == 0 || friction)
        shared.push_back(halfspace::share_load(
            scenes_of(wheel), load,
            friction ? ratios_of(wheel, k) : std::vector<halfspace::ForceRatio>()));
      for (std::size_t i = 0; i < wheel.patches.size(); ++i) {
        Patch& patch = wheel.patches[i];
        const halfspace::PatchLoad& own = shared.back().shares[i];
        change = std::max(change, std::abs(asked_force(patch, k) - own.normal_force) / load);
        patch.placed.scene.points[k].load = {own.normal_force, {}};
        patch.vertical[k] = own.vertical_force;
      }
    }
    set_beside(wheel, shared);
    drop_unloaded(wheel, load);
    return change;
  }

  /// The load points of a scene share one half-space: their mean is the load beside the contact.
  static void set_beside(Wheel& wheel, const std::vector<halfspace::SharedLoad>& shared) {
    const double part = 1.0 / static_cast<double>(shared.size());
    for (std::size_t i = 0; i < wheel.patches.size(); ++i) {
      std::vector<contact::NeighbourLoad>& all = wheel.patches[i].placed.scene.neighbour_loads;
      all.clear();
      for (const halfspace::SharedLoad& at : shared)
        for (contact::NeighbourLoad load : at.shares[i].neighbour_loads) {
          for (double* force : {&load.normal, &load.longitudinal, &load.lateral}) *force *= part;
          all.push_back(load);
        }
    }
  }

  /// The case prescribes the sinking of the wheel; its contacts still displace each other.
  static void press_at_approach(Wheel& wheel) {
    if (wheel.patches.size() < 2) return;
    const contact::Scene& first = wheel.patches.front().placed.scene;
    const auto approach = first.points.front().load.approach;
    if (!approach) return;
    const double sinking =
        (*approach + first.place->separation) / std::cos(first.place->contact_angle);
    set_beside(wheel, {halfspace::load_at(scenes_of(wheel), sinking)});
  }

  static std::vector<halfspace::ForceRatio> ratios_of(const Wheel& wheel, std::size_t k) {
    std::vector<halfspace::ForceRatio> ratios;
    for (const Patch& patch : wheel.patches) {
      ratios.emplace_back();
      if (k >= patch.force.size() || !(patch.force[k].normal > 0.0)) continue;
      const double part = 1.0 / patch.force[k].normal;
      ratios.back() = {part * patch.force[k].longitudinal, part * patch.force[k].lateral};
    }
    return ratios;
  }

  static std::vector<contact::Scene> scenes_of(const Wheel& wheel) {
    std::vector<contact::Scene> scenes;
    for (const Patch& patch : wheel.patches) scenes.push_back(patch.placed.scene);
    return scenes;
  }

  /// The share of each patch becomes a vertical force, from which every model finds the normal
  /// force with its own friction; the shares add up to the load of the wheel.
  void ask_for_vertical_forces(Wheel& wheel) {
    if (!input_.load.vertical_force) return;
    const double load = *input_.load.vertical_force;
    for (std::size_t k = 0; k < rotation_.size(); ++k) {
      double sum = 0.0;
      for (Patch& patch : wheel.patches) {
        if (wheel.patches.size() == 1) patch.vertical.assign(rotation_.size(), load);
        sum += patch.vertical[k];
      }
      for (Patch& patch : wheel.patches)
        patch.placed.scene.points[k].load = {
            patch.vertical[k] * load / sum, {}, halfspace::upwards(patch.placed.contact.place)};
    }
  }

  /// A prescribed sinking may not reach all patches.
  static void drop_untouched(Wheel& wheel) {
    auto& all = wheel.patches;
    all.erase(std::remove_if(all.begin(), all.end(),
                             [](const Patch& p) {
                               const auto& load = p.placed.scene.points.front().load;
                               return load.approach && !(*load.approach > 0.0);
                             }),
              all.end());
  }

  static void drop_unloaded(Wheel& wheel, double load) {
    auto& all = wheel.patches;
    const auto loaded = [&](const Patch& patch) {
      std::size_t count = 0;
      for (std::size_t k = 0; k < patch.placed.scene.points.size(); ++k)
        if (asked_force(patch, k) > load_tolerance * load) ++count;
      return count;
    };
    for (const Patch& patch : all)
      if (const auto count = loaded(patch), of = patch.placed.scene.points.size();
          count > 0 && count < of)
        throw contact::SolveError(
            fmt::format("the {} wheel: a second patch carries load at only {} of {} load points; "
                        "do: solve these load points in separate cases",
                        contact::side_word(wheel.left), count, of));
    all.erase(std::remove_if(all.begin(), all.end(),
                             [&](const Patch& patch) { return loaded(patch) == 0; }),
              all.end());
  }

  void turn(Wheel& wheel) {
    for (Patch& patch : wheel.patches) set_rotation_changes(patch.placed, input_, rotation_);
  }

  /// Tangential forces of the wheels from one to another, by the half-space on a coarse grid at one
  /// load point; null: at all.
  void solve(std::size_t from, std::size_t to, const std::size_t* k = nullptr) {
    std::vector<Patch*> patches;
    for (std::size_t w = from; w < to; ++w)
      for (Patch& patch : wheels_[w].patches) patches.push_back(&patch);
    contact::for_each_index(patches.size(), [&](std::size_t i) {
      Patch& patch = *patches[i];
      contact::Scene scene = halfspace::on_few_elements(patch.placed.scene, elements_across_);
      if (k != nullptr) scene = contact::at_point(scene, *k);
      patch.force.resize(rotation_.size());
      std::size_t at = k != nullptr ? *k : 0;
      for (const contact::PointResult& point : halfspace::run_halfspace(scene, {}).points)
        patch.force[at++] = {point.longitudinal_force, point.lateral_force, point.normal_force,
                             point.spin_moment};
    });
  }

  /// The moment about the axle, or F_x of a wheel as one.
  double torque(const Wheel& wheel, std::size_t k) const {
    double sum = 0.0;
    for (const Patch& patch : wheel.patches)
      sum += free_ == FreeRolling::force
                 ? -patch.force[k].longitudinal * input_.wheel.rolling_radius
                 : driving_moment(patch.placed.contact, patch.force[k]);
    return sum;
  }

  /// Of the torque, at one load point.
  double wanted(std::size_t k) const {
    const contact::Wheelset& given = input_.wheelset;
    if (free_ == FreeRolling::force)
      return given.longitudinal_force.empty()
                 ? 0.0
                 : -given.longitudinal_force.at(k) * input_.wheel.rolling_radius;
    return given.axle_torque.empty() ? 0.0 : given.axle_torque.at(k);
  }

  /// Rotations at which the wheels from one to another have the wanted torque together. A wheel
  /// that turns faster is held back more by the rail: the moment and -F_x fall.
  void find_rotation(std::size_t from, std::size_t to) {
    constexpr double step = 2e-4, largest = 0.1, tolerance = 1e-9;
    const double small =
        torque_tolerance * input_.friction_coefficient * load_scale() * input_.wheel.rolling_radius;
    for (std::size_t k = 0; k < rotation_.size(); ++k) {
      double sum = 0.0;
      const auto torque_at = [&](double rotation) {
        rotation_[k] = rotation;
        sum = -wanted(k);
        for (std::size_t w = from; w < to; ++w) turn(wheels_[w]);
        solve(from, to, &k);
        for (std::size_t w = from; w < to; ++w) sum += torque(wheels_[w], k);
        return std::abs(sum) <= small ? 0.0 : sum;
      };
      const double start = rotation_[k], at_start = torque_at(start);
      const auto found = contact::root_from(torque_at, start, at_start,
                                            at_start > 0.0 ? start + step : start - step, largest,
                                            tolerance, "free rotation");
      if (!found) refuse_rotation(largest, sum);
      rotation_[k] = *found;
    }
    for (std::size_t w = from; w < to; ++w) turn(wheels_[w]);
  }

  [[noreturn]] void refuse_rotation(double largest, double left) const {
    throw contact::SolveError(fmt::format(
        "wheelset.free_rolling = \"{}\": no rotation_change from {:g} to {:g} is free rolling; at "
        "the last one {:.4g} N mm are left; allowed: wheels that roll near their rolling_radius; "
        "do: check wheel.rolling_radius = {:g} mm and the units of the profiles, or give "
        "rotation_change instead",
        free_ == FreeRolling::force ? "force" : "torque", -largest, largest, left,
        input_.wheel.rolling_radius));
  }

  double load_scale() const {
    double sum = 0.0;
    for (const Wheel& wheel : wheels_)
      for (const Patch& patch : wheel.patches) {
        const double asked = largest_force(patch);
        sum += asked > 0.0 ? asked : patch.placed.contact.normal_force;
      }
    return sum;
  }

  std::vector<contact::Scene> scenes() const {
    std::vector<contact::Scene> all;
    for (const Wheel& wheel : wheels_) {
      std::vector<const Patch*> order;
      for (const Patch& patch : wheel.patches) order.push_back(&patch);
      std::stable_sort(order.begin(), order.end(), [](const Patch* a, const Patch* b) {
        return largest_force(*a) > largest_force(*b);
      });
      for (std::size_t i = 0; i < order.size(); ++i) {
        all.push_back(order[i]->placed.scene);
        all.back().place->patch = static_cast<int>(i) + 1;
        all.back().place->patches = static_cast<int>(order.size());
      }
    }
    return all;
  }

  const Case& input_;
  int elements_across_;
  std::vector<Wheel> wheels_;
  std::vector<double> rotation_;  ///< relative change per load point
  FreeRolling free_;
};

}  // namespace

std::vector<contact::Scene> balanced_position(const Case& input,
                                              const std::vector<PlacedScene>& scenes) {
  const bool rolls = input.friction_coefficient > 0.0 &&
                     input.rolling.problem == contact::Problem::steady &&
                     input.wheelset.free_rolling != FreeRolling::none;
  std::vector<contact::Scene> balanced, coarse;
  if (scenes.empty()) return balanced;  // wheels above their rails
  contact::for_each_index(rolls ? 2 : 1, [&](std::size_t k) {
    if (k == 0) balanced = Position(input, scenes, elements_of_balance).balanced();
    try {
      if (k == 1) coarse = Position(input, scenes, elements_of_balance / 2).balanced();
    } catch (const contact::SolveError&) {  // no bars then
    }
  });
  for (contact::Scene& scene : balanced) scene.turns_freely = rolls;
  if (!coarse.empty()) add_creepage_errors(coarse, balanced);
  return balanced;
}

}  // namespace rollfem::track

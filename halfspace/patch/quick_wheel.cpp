// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/patch/quick_wheel.hpp"

#include "base/errors.hpp"
#include "contact/solve/pressure_share.hpp"
#include "result/validity.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::halfspace {

using contact::PatchSize;

namespace {

/// Relative to the approach, for the extents of the patches and for their pressure.
constexpr double search_tolerance = 1e-3;
constexpr double pressure_tolerance = 1e-5;
/// Relative to the load: pressure and friction iterate until they carry it within this tolerance,
/// then both are scaled to it.
constexpr double shared_to = 2e-5;
constexpr int most_shared_turns = 12;
/// Fewest iterations with several patches, which act on each other by the tractions of the previous
/// iteration.
constexpr int fewest_turns_of_several = 3;
/// From this iteration on the weights at the leading edge are frozen. They jump when an element
/// comes into contact, so the force may jump across the required share, which no iterate then
/// meets.
constexpr int turns_until_kept = 5;
constexpr int most_wheel_rounds = 8;
/// Step of the derivatives by the sinking, relative: a power law keeps four digits, and the step
/// smooths over elements that enter the contact.
constexpr double sinking_step = 0.05;
constexpr double pressure_tolerance_of_steps = 1e-7;

/// Thrown where friction changes the pressure so much that a patch needs another grid.
struct LeavesGrids {};

}  // namespace

QuickWheel::QuickWheel(const InfluenceTables& tables, bool any,
                       const contact::CombinedMaterial& material)
    : any_(any), material_(material), normal_(material) {
  for (std::size_t k = 0; k < most_patches; ++k)
    all_.push_back(std::make_unique<QuickPatch>(tables, material));
}

QuickOutcome QuickWheel::solve(const std::vector<QuickContact>& contacts,
                               const QuickLoad& load) try {
  if (contacts.empty() || contacts.size() > most_patches) return QuickOutcome::unfit;
  given_sinking_ = load.sinking;
  loaded_.clear();
  reserve_.clear();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    all_[k]->begin(contacts[k]);
    (contacts[k].reserve ? reserve_ : loaded_).push_back(all_[k].get());
  }
  if (loaded_.empty()) return QuickOutcome::unfit;
  double pressed = load.force;
  constexpr int most_grids = 4;
  for (int grids = 0; grids < most_grids; ++grids) {
    const double found_for = pressed;
    if (!find_patches(pressed)) return QuickOutcome::unfit;
    if (!reach_only(&contact::PatchGeometry::within_limits, 0.0)) return QuickOutcome::conformal;
    if (!lay_on_patches()) return QuickOutcome::unfit;
    set_problem();
    try {
      share_load(load, pressed);
    } catch (const LeavesGrids&) {
      constexpr double somewhat = 1.1;
      // Contacts grow with the cube root of their load.
      const double factor = given_sinking_ ? somewhat : std::cbrt(pressed / found_for);
      for (QuickPatch* patch : loaded_) patch->box.grow(factor);
      continue;
    }
    if (!reach_only(&contact::PatchGeometry::known, 1.0)) return QuickOutcome::unfit;
    if (!reach_only(&contact::PatchGeometry::within_limits, 1.0)) return QuickOutcome::conformal;
    check(load);
    return QuickOutcome::solved;
  }
  return QuickOutcome::unfit;
} catch (const contact::SolveError&) {
  return QuickOutcome::unfit;
}

/// Finds the frictionless patches, each on a few elements over the overlap of the bodies.
bool QuickWheel::find_patches(double force) {
  for (int round = 0; round < most_wheel_rounds; ++round) {
    for (QuickPatch* patch : loaded_)
      if (!patch->lay_over_box()) return false;
    set_problem();
    solve_normal(force, search_tolerance, true);
    loaded_.erase(std::remove_if(loaded_.begin(), loaded_.end(),
                                 [](const QuickPatch* patch) { return !patch->has_pressure(); }),
                  loaded_.end());
    if (loaded_.empty()) return false;
    const bool fits = !adjust_boxes();
    if (!take_reached() && fits) return true;
  }
  return false;
}

bool QuickWheel::lay_on_patches() {
  return std::all_of(loaded_.begin(), loaded_.end(), [&](QuickPatch* patch) {
    if (!any_ && !(patch->is_one_region() && patch->turn() < most_turn)) return false;
    return patch->lay_on_patch();
  });
}

bool QuickWheel::reach_only(bool (contact::PatchGeometry::*good)(double) const,
                            double elements) const {
  return std::all_of(loaded_.begin(), loaded_.end(),
                     [&](const QuickPatch* patch) { return patch->reaches_only(good, elements); });
}

/// Gives new boxes to patches that do not fit their grids; false if all fit.
bool QuickWheel::adjust_boxes() {
  constexpr double larger = 1.3;
  constexpr int fewest_elements = 6;
  bool any = false;
  for (QuickPatch* patch : loaded_) {
    const PatchSize size = patch->measure();
    if (patch->touches_border()) {
      patch->box.grow(larger);
      any = true;
    } else if (size.length < fewest_elements * patch->grid().dx ||
               size.width < fewest_elements * patch->grid().dy) {
      constexpr double room = 0.3;
      patch->box = {(1.0 + 2.0 * room) * size.length,
                    {size.y_lower - room * size.width, size.y_upper + room * size.width},
                    size.x_middle()};
      any = true;
    }
  }
  return any;
}

bool QuickWheel::stays_on_grids() const {
  return std::all_of(loaded_.begin(), loaded_.end(), [](const QuickPatch* patch) {
    return patch->has_pressure() && !patch->touches_border();
  });
}

/// Adds contacts that the sinking wheel has reached; false if there are none.
bool QuickWheel::take_reached() {
  const auto reached = std::stable_partition(
      reserve_.begin(), reserve_.end(),
      [&](const QuickPatch* patch) { return !(sinking() > patch->first_sinking()); });
  if (reached == reserve_.end()) return false;
  std::for_each(reached, reserve_.end(), [&](QuickPatch* patch) { patch->reach_to(sinking()); });
  loaded_.insert(loaded_.end(), reached, reserve_.end());
  reserve_.erase(reached, reserve_.end());
  return true;
}

void QuickWheel::set_problem() {
  joint_ = &joints_[loaded_.size() - 1];
  blocks_.clear();
  for (const QuickPatch* patch : loaded_) blocks_.push_back(patch->block());
  normal_.set(blocks_);
  joint_->distance.resize(place_of(loaded_.size()));
  set_distances();
}

void QuickWheel::set_distances() {
  for (std::size_t k = 0; k < loaded_.size(); ++k)
    joint_->distance.segment(place_of(k), place_of(1)) = loaded_[k]->distance();
}

/// Solves for the pressures that together carry `force`, or for those at a given sinking, starting
/// from the present ones or, with `anew`, from zero.
void QuickWheel::solve_normal(double force, double tolerance, bool anew) {
  static const contact::Field none;
  contact::NormalOptions options;
  options.tolerance = tolerance;
  contact::BoundConstrainedCg& solver = joint_->solver;
  const contact::Field& start = anew ? none : solver.pressure();
  if (given_sinking_)
    solver.solve_approach(normal_, joint_->distance, *given_sinking_, options, start);
  else
    solver.solve_sum(normal_, joint_->distance, force, options, start);
  for (std::size_t k = 0; k < loaded_.size(); ++k)
    loaded_[k]->set_forces(solver.pressure().data() + place_of(k));
}

/// Displacement and slip of every patch by the present tractions of the others.
void QuickWheel::feel_neighbours(const QuickLoad& load) {
  if (loaded_.size() == 1 || !load.friction) return;
  for (QuickPatch* patch : loaded_) {
    patch->forget_neighbours();
    for (const QuickPatch* other : loaded_)
      if (other != patch) patch->add_neighbour(*other, material_);
  }
  set_distances();
}

bool QuickWheel::solve_friction(const QuickLoad& load, int turn) {
  return std::all_of(loaded_.begin(), loaded_.end(), [&](QuickPatch* patch) {
    return patch->solve_friction(load.friction, turn == 0, turn >= turns_until_kept);
  });
}

/// Pressure that carries `share`, and friction under it.
void QuickWheel::solve_in_turn(const QuickLoad& load, double share, int turn) {
  if (turn > 0) feel_neighbours(load);
  solve_normal(share, pressure_tolerance, turn == 0);
  if (!stays_on_grids()) throw LeavesGrids();
  if (!solve_friction(load, turn)) throw contact::SolveError("too many elements in contact");
}

/// Iterates between pressure and friction until they carry the load together; at a given sinking,
/// where friction changes only the pressures of other contacts, until these settle. `share`:
/// expected part of the load carried by pressure, updated to the computed part.
void QuickWheel::share_load(const QuickLoad& load, double& share) {
  contact::PressureShare sharing;
  sharing.load = given_sinking_ ? 1.0 : load.force;
  sharing.tolerance = shared_to;
  sharing.most_turns = most_shared_turns;
  sharing.sliding = true;
  double of_friction = 0.0, carried = 0.0;
  sharing.solve(given_sinking_ ? 1.0 : share, [&, expected = share](double pressing, int turn) {
    constexpr double within_grid = 1.25;
    if (!given_sinking_) share = pressing;
    if (share > within_grid * expected || share * within_grid < expected) throw LeavesGrids();
    solve_in_turn(load, pressing, turn);
    const double before = std::exchange(carried, joint_->solver.pressure().sum());
    const bool steady = !given_sinking_ || std::abs(carried - before) <= shared_to * carried;
    sharing.settled = loaded_.size() == 1 || (turn + 1 >= fewest_turns_of_several && steady);
    if (given_sinking_) return pressing;
    of_friction = 0.0;
    for (const QuickPatch* patch : loaded_) of_friction += patch->load_of_friction();
    return load.force - of_friction;
  });
  if (given_sinking_) return;
  for (QuickPatch* patch : loaded_) patch->scale(load.force / (share + of_friction));
}

/// Resultants of every patch at another sinking, starting from the present solution.
bool QuickWheel::sums_at(double sinking, const QuickLoad& load, std::vector<PatchSums>& sums) {
  given_sinking_ = sinking;
  feel_neighbours(load);
  solve_normal(0.0, pressure_tolerance_of_steps, false);
  if (!stays_on_grids() || !solve_friction(load, 1)) return false;
  sums.clear();
  for (const QuickPatch* patch : loaded_) sums.push_back(patch->sums());
  return true;
}

bool QuickWheel::respond(const QuickLoad& load, std::vector<PatchResponse>& responses) {
  responses.resize(loaded_.size());
  for (std::size_t k = 0; k < loaded_.size(); ++k) {
    responses[k] = {};
    if (load.friction && !loaded_[k]->respond(responses[k].by_creepage)) return false;
  }
  const double stands = sinking(), step = sinking_step * stands;
  try {
    if (!sums_at(stands - step, load, below_) || !sums_at(stands + step, load, above_))
      return false;
  } catch (const contact::SolveError&) {
    return false;
  }
  for (std::size_t k = 0; k < loaded_.size(); ++k)
    responses[k].by_sinking = (above_[k] - below_[k]) / (2.0 * step);
  return true;
}

void QuickWheel::check(const QuickLoad& load) {
  const contact::BoundConstrainedCg& solver = joint_->solver;
  for (std::size_t k = 0; k < loaded_.size(); ++k) {
    QuickPatch* patch = loaded_[k];
    patch->finish(load.friction, solver.gap().data() + place_of(k),
                  solver.displacement().data() + place_of(k), solver.approach());
    if (load.heat && load.friction) patch->warm(*load.heat);
    contact::NormalLoad own;
    if (loaded_.size() == 1 && !given_sinking_) {
      own.force = load.force;
      own.direction = patch->direction();
    }
    contact::check_point({patch->grid(), patch->point(), own});
  }
}

}  // namespace rollfem::halfspace

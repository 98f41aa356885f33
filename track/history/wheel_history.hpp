// SPDX-License-Identifier: LGPL-2.1-or-later
// A wheel whose positions follow each other: every step inherits the state of the material from the
// steps before, on one lattice of elements for the wheel and its rail. Steps are given one by one.
#pragma once

#include "base/checkpoint.hpp"
#include "result/result.hpp"
#include "scene/step_past.hpp"
#include "track/balance/balance.hpp"
#include "track/balance/springs.hpp"

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace rollfem::track {

/// Cells along x and y, mm.
using CellSize = std::array<double, 2>;

/// The cells of a wheel's levels, the coarsest first: those of the case or as many across as it
/// asks for, and of twice and four times the size for error bars. `scenes`: of all its steps.
std::vector<CellSize> cells_of_levels(const contact::Case& input,
                                      const std::vector<contact::Scene>& scenes);

/// Each step: begin, solve (as often as its loads and rotation ask), end.
class WheelHistory {
 public:
  /// Solves a scene with its past (Scene::past) by the half-space; the checkpoint may be null.
  using Solve = std::function<contact::ModelResult(
      const contact::Scene&, const std::vector<contact::Note>& notes, contact::Checkpoint*)>;

  /// With one level steps are solved without error bars. `notes`: for every step.
  WheelHistory(const std::vector<CellSize>& levels, std::vector<contact::Note> notes, Solve solve,
               contact::Checkpoint* checkpoint = nullptr);

  /// `here`: case_at of the step. `contacts`: of this wheel, balanced without friction, at one
  /// position, at least one. `placed`, which the step needs until it ends, holds what they were
  /// made of.
  void begin(contact::Case here, std::vector<contact::Scene> contacts, const PlacedWheels& placed);

  /// Puts the wheel where the springs under its rail hold it.
  void settle();

  /// Gives the contacts the creepages of a rotation of the wheel.
  void turn(double rotation);

  /// F_x of the wheel times minus its radius, or the moment about its axle, N mm, on the finest
  /// elements; the load of the wheel, N.
  std::array<double, 2> torque();

  /// Shares a load that several contacts carry anew with the friction that it finds. Without
  /// results, if none is left, the rail has given way.
  std::vector<contact::ModelResult> solve(bool finest_alone = false);

  /// Hands on what the step has left.
  void end(const std::vector<contact::ModelResult>& results);

  /// A step in which the wheel does not touch its rail leaves nothing.
  void miss(double length);

  int steps() const { return past_.steps; }
  const contact::Case& here() const { return here_; }
  /// Of the last solution, with their shares of the load.
  const std::vector<contact::Scene>& contacts() const { return contacts_; }
  const RailVector& rail_moved() const { return rail_; }
  /// What they were made of.
  const std::vector<PlacedScene>& placed() const {
    return settled_.empty() ? placed_->scenes : settled_;
  }

 private:
  using Interval = std::array<double, 2>;

  /// The origin of a contact in the material of the rail: mm along the way and along the profile,
  /// in the direction of the contact's y.
  struct Origin {
    double x = 0.0, y = 0.0;
  };

  /// What lies on elements of one size, in the material of the rail.
  struct Level {
    CellSize cell{};
    contact::PastPatches last{}, before_last{};
    std::array<double, 2> lengths{};
    double way = 0.0;  ///< mm rolled up to the last step
    std::vector<contact::PastHeat> heat{};
  };

  void take(std::vector<contact::Scene> contacts);
  Origin origin_of(const contact::Scene& scene) const;
  bool doubles() const;
  const Level& coarse() const { return levels_[levels_.size() - 2]; }
  std::shared_ptr<const contact::StepPast> past_of(std::size_t own, bool finest_alone) const;
  contact::Creepage mean_creepage(std::size_t own, double part) const;
  static contact::PastPatches inherited(const contact::PastPatches& earlier,
                                        const std::vector<Interval>& ranges, std::size_t own,
                                        const Origin& origin);
  void hand_on(Level& level, std::size_t from_end) const;
  static void extend_steady(double length, Level& level);
  bool share(double load, const std::vector<contact::ModelResult>& results);

  std::vector<contact::Note> notes_;
  Solve solve_;
  contact::Checkpoint* checkpoint_;
  std::vector<Level> levels_;     ///< the coarsest first
  std::array<Level, 2> doubled_;  ///< in double steps, which end at even and odd ones
  std::optional<Origin> first_;   ///< a corner of the lattice, once a contact is known
  double way_ = 0.0;              ///< mm rolled
  RailVector rail_{};             ///< where its springs hold the rail
  contact::StepPast past_;        ///< sums of the steps so far; without levels
  int began_ = 0;                 ///< the step in which the wheel has touched its rail
  bool from_steady_ = false;      ///< that step is steady
  /// Of the step before, with the place of the contacts across.
  std::vector<std::pair<double, contact::Creepage>> creepages_;

  // The step that is being solved.
  const PlacedWheels* placed_ = nullptr;
  std::vector<PlacedScene> settled_{};  ///< on springs
  contact::Case here_;
  std::vector<contact::Scene> contacts_;
  bool steady_ = false;  ///< as the last step was, until the next one begins
  double length_ = 0.0;
};

/// Turns wheels together so that they transmit what the case asks of them, after they have begun a
/// step; returns the rotation (Wheelset::rotation_change).
double find_rotation(const std::vector<WheelHistory*>& wheels, double start);

}  // namespace rollfem::track

// SPDX-License-Identifier: LGPL-2.1-or-later
// Implementation of rollfem.h: a wheel on its rail, prepared once and solved for one state after
// another. Units mm, N, MPa, s, rad; track frame: x along the track, y to the right, z down.
#pragma once

#include "capi/quick_wheel.hpp"
#include "contact/case/case.hpp"
#include "track/motion/placed_scenes.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace rollfem::capi {

/// Position and motion of the wheelset relative to the ground; signs as in contact::Wheelset.
struct WheelState {
  double lateral_shift = 0.0;
  double yaw = 0.0;
  double roll = 0.0;  ///< NaN: both wheels touch
  double forward_speed = 0.0;
  double lateral_velocity = 0.0;
  double yaw_rate = 0.0;
  double rotation_speed = 0.0;
  double vertical_force = 0.0;
};

/// Results of a patch; signs and frame as in contact::PointResult.
struct PatchForces {
  contact::Creepage creepage;
  double normal_force = 0.0, longitudinal_force = 0.0, lateral_force = 0.0;  ///< N
  double lateral_pressure = 0.0;                                             ///< N
  double spin_moment = 0.0;                                                  ///< N mm
  double length = 0.0, width = 0.0;                                          ///< mm
  double area = 0.0, adhesion_area = 0.0;                                    ///< mm^2
  double max_pressure = 0.0, max_pressure_bar = 0.0;                         ///< MPa
};

struct SolvedPatch {
  PatchForces forces;
  std::array<double, 3> origin{};  ///< contact point, track frame, mm
  double contact_angle = 0.0;      ///< rad
  double rolling_radius = 0.0;     ///< mm
  std::array<double, 3> force{};   ///< on the wheel, track frame, N
};

struct SolvedWheel {
  static constexpr std::size_t most_patches = 4;
  std::size_t count = 0;
  std::array<SolvedPatch, most_patches>
      patches;  ///< the most loaded first; further ones count in the sums
  std::array<double, 3> force{};
  std::array<double, 3> moment{};  ///< about the middle of the axle
  double height = 0.0;             ///< at which the wheel just touches, unloaded
};

class WheelRailPair {
 public:
  /// `input`: a case with profiles, one position, one wheel and a vertical force; values given by
  /// the state are ignored. Throws contact::InputError.
  explicit WheelRailPair(contact::Case input);

  /// Throws contact::InputError for values out of bounds, contact::SolveError if there is no
  /// solution. Results do not depend on earlier calls. Thread-safe.
  SolvedWheel solve(const WheelState& state) const;

 private:
  /// Working memory of a call, kept for later calls of any thread.
  struct Workspace {
    contact::Case input;
    std::vector<std::unique_ptr<QuickWheel>> wheels;  ///< tried in this order
    std::vector<track::WheelRailContact> found;
    std::vector<QuickContact> contacts;
  };
  class Borrowed;

  bool solve_quickly(Workspace& workspace, SolvedWheel& wheel) const;
  QuickOutcome solve_quickly_on(Workspace& workspace, SolvedWheel& wheel) const;
  static void take(const QuickWheel& quick, SolvedWheel& wheel);
  void solve_with_care(const contact::Case& input, SolvedWheel& wheel) const;
  bool solve_curved(contact::Case input, SolvedWheel& wheel) const;

  contact::Case input_;
  track::SearchScene search_;
  contact::CombinedMaterial material_;
  contact::Friction friction_;
  /// Empty if materials are unlike or the grid is too fine.
  std::vector<std::unique_ptr<halfspace::InfluenceTables>> tables_;  ///< coarser grids first
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Workspace>> idle_;
};

}  // namespace rollfem::capi

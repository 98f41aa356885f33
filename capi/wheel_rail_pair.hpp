// A wheel on its rail, prepared once and solved for one state after another: the implementation of
// rollfem.h. mm, N, MPa, s, rad; track frame: x along the track, y to the right, z down.
#pragma once

#include "contact/case/case.hpp"
#include "contact/result/result.hpp"
#include "meshes/track/scenes.hpp"

#include <array>
#include <vector>

namespace rollfem::capi {

/// Where the wheelset is and how it moves over the ground; signs as in contact::Wheelset.
struct WheelState {
  double lateral_shift = 0.0;
  double yaw = 0.0;
  double roll = 0.0;  ///< NaN: such that both wheels touch
  double forward_speed = 0.0;
  double lateral_velocity = 0.0;
  double yaw_rate = 0.0;
  double rotation_speed = 0.0;
  double vertical_force = 0.0;
};

struct SolvedPatch {
  meshes::WheelRailContact contact;
  contact::PointResult point;
  std::array<double, 3> force{};  ///< on the wheel, track frame
};

struct SolvedWheel {
  std::vector<SolvedPatch> patches;  ///< the most loaded first
  std::array<double, 3> force{};
  std::array<double, 3> moment{};  ///< about the middle of the axle
  double height = 0.0;             ///< where the wheel touches unloaded
};

class WheelRailPair {
 public:
  /// `input`: a case with profiles and one position, one wheel and a vertical force; what a state
  /// gives is not read. Throws contact::InputError.
  explicit WheelRailPair(contact::Case input);

  /// Throws contact::InputError for values that are not allowed, contact::SolveError where there is
  /// no solution. Changes nothing.
  SolvedWheel solve(const WheelState& state) const;

 private:
  contact::Case input_;
  meshes::SearchScene search_;
};

}  // namespace rollfem::capi

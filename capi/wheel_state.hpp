// SPDX-License-Identifier: LGPL-2.1-or-later
// The state of a wheelset that rollfem.h solves for, and its variables by number: mm, N, s, rad.
#pragma once

#include "contact/case/case.hpp"

#include <array>
#include <cstddef>

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
  /// The load on this wheel. height: z of the axle's middle plus the rolling radius;
  /// penetration: that less the height at which the wheel first touches.
  enum class Given { vertical_force, height, penetration };
  Given given = Given::vertical_force;
  double load = 0.0;  ///< N or mm
};

/// Variables of the derivatives, in the order of rollfem.h.
inline constexpr std::array<double WheelState::*, 8> state_variables{&WheelState::lateral_shift,
                                                                     &WheelState::yaw,
                                                                     &WheelState::roll,
                                                                     &WheelState::forward_speed,
                                                                     &WheelState::lateral_velocity,
                                                                     &WheelState::yaw_rate,
                                                                     &WheelState::rotation_speed,
                                                                     &WheelState::load};
/// The first variable that changes the motion alone, and the load.
inline constexpr std::size_t first_velocity = 3, load_variable = 7;

/// Checks every number of a state against the bounds of case files. Throws contact::InputError.
void check(const WheelState& state, double rolling_radius);

/// Writes a state into a case. A given height or penetration goes to the search (SearchOptions).
void set(const WheelState& state, contact::Case& input);

}  // namespace rollfem::capi

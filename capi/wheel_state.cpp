// SPDX-License-Identifier: LGPL-2.1-or-later
#include "capi/wheel_state.hpp"

#include "contact/base/errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::capi {

void check(const WheelState& state, double rolling_radius) {
  const auto within = [](const char* name, double value, double limit) {
    if (std::abs(value) <= limit) return;  // false for NaN
    throw contact::InputError(
        fmt::format("{} = {:g}: is out of bounds; allowed: magnitudes up to {:g}; do: correct it",
                    name, value, limit));
  };
  const auto positive = [](const char* name, double value, double limit) {
    if (value > 0.0 && value <= limit) return;
    throw contact::InputError(
        fmt::format("{} = {:g}: is out of bounds; allowed: above 0, up to {:g}; do: correct it",
                    name, value, limit));
  };
  const double speed = state.forward_speed;
  positive("forward_speed in mm/s", speed, 1e9);
  switch (state.given) {
    case WheelState::Given::vertical_force:
      positive("vertical_force in N", state.load, 1e12);
      break;
    case WheelState::Given::height:
      within("height in mm", state.load, 1e3);
      break;
    case WheelState::Given::penetration:
      within("penetration in mm", state.load, 1e3);
      break;
  }
  within("lateral_shift in mm", state.lateral_shift, 1e3);
  within("yaw in rad", state.yaw, 0.2);
  if (!std::isnan(state.roll)) within("roll in rad", state.roll, 0.2);
  within("lateral_velocity over forward_speed", state.lateral_velocity / speed, 1.0);
  within("yaw_rate over forward_speed in rad/mm", state.yaw_rate / speed, 1.0);
  within("rotation_speed times rolling_radius over forward_speed, less 1,",
         state.rotation_speed * rolling_radius / speed - 1.0, 1.0);
}

void set(const WheelState& state, contact::Case& input) {
  contact::Wheelset& wheelset = input.wheelset;
  wheelset.lateral_shift.assign(1, state.lateral_shift);
  wheelset.yaw.assign(1, state.yaw);
  wheelset.roll.clear();
  if (!std::isnan(state.roll)) wheelset.roll.push_back(state.roll);
  wheelset.lateral_velocity = state.lateral_velocity / state.forward_speed;
  wheelset.yaw_velocity = state.yaw_rate / state.forward_speed;
  wheelset.rotation_change.assign(
      1, state.rotation_speed * input.wheel.rolling_radius / state.forward_speed - 1.0);
  input.rolling.speed = state.forward_speed;
  input.load = {};
  if (state.given == WheelState::Given::vertical_force)
    input.load.vertical_force = state.load;
  else
    input.load.approach = 1.0;  // a placeholder: the search overrides it
}

}  // namespace rollfem::capi

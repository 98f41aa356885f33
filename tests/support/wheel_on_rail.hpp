// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs and states for tests of rollfem.h: mm, N, mm/s, rad.
#pragma once

#include "case/reading/case_reader.hpp"

#include "rollfem/rollfem.h"
#include "support/temporary_folder.hpp"
#include "support/test.hpp"
#include <functional>

namespace rollfem::testing {

template <class T>
T sized() {
  T value{};
  value.struct_size = sizeof value;
  return value;
}

using Pair = std::unique_ptr<rollfem_pair, void (*)(rollfem_pair*)>;

inline rollfem_definition defaults(rollfem_side side = ROLLFEM_LEFT,
                                   rollfem_units units = ROLLFEM_MM_N) {
  auto definition = sized<rollfem_definition>();
  rollfem_defaults(&definition, units);
  definition.side = side;
  return definition;
}

inline Pair make(const rollfem_definition& definition) {
  char message[1000];
  Pair pair(rollfem_create(&definition, message, sizeof message), rollfem_destroy);
  EXPECT_NE(pair, nullptr) << message;
  return pair;
}

inline rollfem_result solve(const Pair& pair, const rollfem_state& state) {
  char message[1000];
  auto result = sized<rollfem_result>();
  EXPECT_EQ(rollfem_solve(pair.get(), &state, &result, message, sizeof message), ROLLFEM_OK)
      << message;
  return result;
}

/// mm, rad, mm/s, N.
inline rollfem_state state_at(double shift, double yaw) {
  auto state = sized<rollfem_state>();
  state.lateral_shift = shift;
  state.yaw = yaw;
  state.forward_speed = 20e3;
  state.lateral_velocity = 30.0;
  state.yaw_rate = 0.02;
  state.rotation_speed = 20e3 / 460.0 * 1.001;
  state.vertical_force = 50e3;
  return state;
}

/// The right wheel of state_at as a case, 32 elements across; `friction`: lines that follow
/// the coefficient of friction.
inline contact::Case case_at(double shift, double yaw, const std::string& friction = {}) {
  contact::Case input = contact::parse_case(R"(
    [load]
    vertical_force = 50e3
    [wheel]
    rolling_radius = 460.0
    profile = "S1002"
    [rail]
    profile = "60E1"
    [track]
    inclination = "1:40"
    [wheelset]
    side = "right"
    roll = 0.0
    lateral_velocity = 0.0015
    yaw_velocity = 1e-6
    rotation_change = 0.001
    [contact_grid]
    elements_across = 32
    [friction]
    coefficient = 0.3
  )" + friction,
                                            "case");
  input.wheelset.lateral_shift = {shift};
  input.wheelset.yaw = {yaw};
  return input;
}

inline constexpr double sphere_radius = 300.0;

/// A wheel without a taper on a rail whose head has the wheel's radius, upright: locally a sphere
/// of sphere_radius on a plane.
inline Pair sphere_on_plane(const TemporaryFolder& folder, double poisson_ratio,
                            rollfem_side side = ROLLFEM_LEFT, int elements_across = 12,
                            const std::function<void(rollfem_definition&)>& change = {}) {
  std::string wheel = "# y z, mm\n", rail = wheel;
  for (double y = -40.0; y <= 40.0; y += 0.25) wheel += std::to_string(y) + " 0.0\n";
  for (double y = -36.0; y <= 36.0; y += 0.25)
    rail += std::to_string(y) + " " +
            std::to_string(sphere_radius - std::sqrt(sphere_radius * sphere_radius - y * y)) + "\n";
  rollfem_definition definition = defaults(side);
  const std::string wheel_file = folder.file("wheel.txt", wheel),
                    rail_file = folder.file("rail.txt", rail);
  definition.wheel_profile = wheel_file.c_str();
  definition.rail_profile = rail_file.c_str();
  definition.rolling_radius = sphere_radius;
  definition.elements_across = elements_across;
  definition.inclination = 0.0;
  definition.gauge = 1451.0;
  definition.gauge_height = 1.0;  // 24.5 mm beside the middle of the rail
  definition.wheel_poisson_ratio = definition.rail_poisson_ratio = poisson_ratio;
  if (change) change(definition);
  return make(definition);
}

}  // namespace rollfem::testing

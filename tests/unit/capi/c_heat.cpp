// SPDX-License-Identifier: LGPL-2.1-or-later
// Temperatures in rollfem.h against the closed form of an ellipse in full sliding and the model
// halfspace, and friction that follows them.
#include "base/pi.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "track/balance/balance.hpp"

#include "rollfem/rollfem.h"
#include "support/wheel_on_rail.hpp"

namespace {

constexpr double steel = 13.288;  // sqrt(50 * 7.85e-9 * 450e6), N/(mm K s^0.5)

rollfem_definition heated(rollfem_side side = ROLLFEM_RIGHT) {
  rollfem_definition definition = defaults(side);
  definition.has_heat = 1;
  return definition;
}

/// Bodies of unlike temperature and steel.
void make_unlike(rollfem_definition& definition) {
  definition.has_heat = 1;
  definition.wheel_heat = {50.0, 450.0, 7850.0, 90.0};
  definition.rail_heat = {25.0, 900.0, 7850.0 / 4.0, 30.0};
}

TEST(CHeat, OfASphereInFullSlidingIsTheClosedForm) {
  const TemporaryFolder folder;
  for (const rollfem_side side : {ROLLFEM_LEFT, ROLLFEM_RIGHT}) {
    const Pair pair = sphere_on_plane(folder, 0.3, side, 20, make_unlike);
    rollfem_state state = state_at(0.0, 0.0);
    state.lateral_velocity = state.yaw_rate = 0.0;
    state.rotation_speed = state.forward_speed / sphere_radius * 1.1;
    const rollfem_patch patch = solve(pair, state).patch[0];
    const double modulus = 210e3 / (2.0 * (1.0 - 0.09));
    const double a = std::cbrt(0.75 * 50e3 * sphere_radius / modulus), v = state.forward_speed;
    const double flow = 0.3 * 1.5 * 50e3 / (pi * a * a) * 0.1 * v;
    const double of_rail = 0.5 * steel, both = steel + of_rail;
    const double rise = flow * std::sqrt(a / v) / (both * std::sqrt(pi)) * 2.1883;
    EXPECT_NEAR(patch.max_temperature, (steel * 90.0 + of_rail * 30.0) / both + rise, 0.015 * rise);
    EXPECT_NEAR(patch.heat_wheel + patch.heat_rail, patch.creepage_work,
                1e-4 * patch.creepage_work);
  }
}

TEST(CHeat, IsThatOfTheModelHalfspaceInPartialSlipAndUnderFrictionByTemperature) {
  for (const bool follows : {false, true}) {
    rollfem_definition definition = heated();
    make_unlike(definition);
    if (follows) {
      definition.friction_law = ROLLFEM_TEMPERATURE;
      definition.law_constants[0] = 60.0;
      definition.law_constants[1] = 120.0;
      definition.law_constants[2] = 0.05;
    }
    contact::Case input = case_at(3.0, 0.002,
                                  std::string(follows ? R"(
    law = "temperature"
    cold_temperature = 60.0
    hot_temperature = 120.0
    hot_coefficient = 0.05)"
                                                      : "") +
                                      R"(
    [rolling]
    speed = 20e3
    [wheel_heat]
    temperature = 90.0
    [rail_heat]
    temperature = 30.0
    conductivity = 25.0
    heat_capacity = 900.0
  )");
    input.rail.material.density = 7.85e-9 / 4.0;
    for (const double change : {0.001, 0.005}) {
      rollfem_state state = state_at(3.0, 0.002);
      state.rotation_speed = 20e3 / 460.0 * (1.0 + change);
      input.wheelset.rotation_change = {change};
      const rollfem_patch patch = solve(make(definition), state).patch[0];
      const auto scenes = rollfem::track::balance(input).scenes;
      const auto point = rollfem::halfspace::run_halfspace(scenes.front(), {}).points.front();
      const double rise = *point.max_temperature - 70.0;
      EXPECT_GT(rise, change > 0.002 ? 30.0 : 5.0);
      EXPECT_NEAR(patch.max_temperature, *point.max_temperature, 0.03 * rise) << change << follows;
      // What unlike bodies exchange on few elements is too much by a part of the first one.
      const double moved = std::abs(*point.heat_wheel) + std::abs(*point.heat_rail);
      EXPECT_NEAR(patch.heat_wheel, *point.heat_wheel, 0.05 * moved);
      EXPECT_NEAR(patch.heat_wheel + patch.heat_rail, *point.frictional_work,
                  0.02 * *point.frictional_work);
      EXPECT_LT(std::hypot(patch.longitudinal_force - point.longitudinal_force,
                           patch.lateral_force - point.lateral_force),
                0.012 * 0.3 * 50e3)
          << change << follows;
      const rollfem_patch cold = solve(make(defaults(ROLLFEM_RIGHT)), state).patch[0];
      EXPECT_EQ(cold.max_temperature, 0.0);
      if (!follows) {
        EXPECT_EQ(cold.longitudinal_force, patch.longitudinal_force);
      }
    }
  }
}

TEST(CHeat, OfTheOtherWheelIsTheMirrorImageInEveryUnit) {
  rollfem_definition other = heated(ROLLFEM_LEFT);
  rollfem_definition in_m = defaults(ROLLFEM_LEFT, ROLLFEM_M_N);
  make_unlike(other);
  make_unlike(in_m);
  rollfem_definition right = heated();
  make_unlike(right);
  rollfem_state state = state_at(2.0, 0.001);
  const rollfem_patch patch = solve(make(right), state).patch[0];
  for (double rollfem_state::*sideways :
       {&rollfem_state::lateral_shift, &rollfem_state::yaw, &rollfem_state::lateral_velocity,
        &rollfem_state::yaw_rate})
    state.*sideways *= -1.0;
  const rollfem_patch mirrored = solve(make(other), state).patch[0];
  for (double rollfem_state::*length :
       {&rollfem_state::lateral_shift, &rollfem_state::forward_speed,
        &rollfem_state::lateral_velocity})
    state.*length *= 1e-3;
  const rollfem_patch scaled = solve(make(in_m), state).patch[0];
  for (double rollfem_patch::*value :
       {&rollfem_patch::max_temperature, &rollfem_patch::heat_wheel, &rollfem_patch::heat_rail}) {
    EXPECT_NEAR(patch.*value, mirrored.*value, 2e-3 * std::abs(patch.*value));
    EXPECT_NEAR(scaled.*value, mirrored.*value, 1e-6 * std::abs(patch.*value));
  }
}

TEST(CHeat, RefusesWhatALawByTemperatureLacks) {
  rollfem_definition definition = heated();
  definition.friction_law = ROLLFEM_TEMPERATURE;
  char message[1000];
  EXPECT_EQ(rollfem_create(&definition, message, sizeof message), nullptr);
  EXPECT_NE(std::string(message).find("friction.hot_"), std::string::npos) << message;
  definition = heated();
  definition.rail_heat.conductivity = -1.0;
  EXPECT_EQ(rollfem_create(&definition, message, sizeof message), nullptr);
  EXPECT_NE(std::string(message).find("rail_heat.conductivity"), std::string::npos) << message;
}

}  // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Falling friction and a layer in rollfem.h against the law itself, the model halfspace, and
// refusals.
#include "halfspace/model/halfspace_model.hpp"
#include "track/balance/balance.hpp"

#include "rollfem/rollfem.h"
#include "support/wheel_on_rail.hpp"
#include <cstddef>

namespace {

rollfem_definition falling(rollfem_units units = ROLLFEM_MM_N) {
  const double mm = units == ROLLFEM_M_N ? 1e-3 : 1.0;
  rollfem_definition definition = defaults(ROLLFEM_RIGHT, units);
  definition.friction_law = ROLLFEM_EXPONENTIAL;
  definition.kinetic_coefficient = 0.1;
  definition.half_velocity = 100.0 * mm;
  return definition;
}

TEST(CFriction, InFullSlidingIsThatOfTheSlipVelocity) {
  rollfem_state state = state_at(0.0, 0.0);
  state.lateral_velocity = state.yaw_rate = 0.0;
  for (const double speed : {2e3, 20e3}) {
    state.forward_speed = speed;
    state.rotation_speed = speed / 460.0 * 1.05;
    const rollfem_result result = solve(make(falling()), state);
    ASSERT_EQ(result.patch_count, 1);
    const rollfem_patch& patch = result.patch[0];
    const double slip = speed * std::hypot(patch.longitudinal_creepage, patch.lateral_creepage);
    const double mu = 0.1 + 0.2 * std::exp2(-slip / 100.0);
    EXPECT_NEAR(std::hypot(patch.longitudinal_force, patch.lateral_force) / patch.normal_force, mu,
                0.005)
        << speed;
  }
}

/// The wheel of state_at(3.0, 0.002).
rollfem::contact::Case falling_case(double rotation_change, int across) {
  rollfem::contact::Case input = case_at(3.0, 0.002, R"(
    law = "exponential"
    kinetic_coefficient = 0.1
    half_velocity = 100.0
    memory_distance = 0.003
    [layer]
    thickness = 1.0
    shear_modulus = 8200.0
    [rolling]
    speed = 20e3
  )");
  input.wheelset.rotation_change = {rotation_change};
  input.contact_grid.elements_across = across;
  return input;
}

TEST(CFriction, WithMemoryAndALayerIsTheModelHalfspaceOnAsManyElements) {
  rollfem_definition definition = falling();
  definition.memory_distance = 0.003;
  definition.layer_thickness = 1.0;
  definition.layer_shear_modulus = 8200.0;
  for (const double change : {0.001, 0.01}) {
    rollfem_state state = state_at(3.0, 0.002);
    state.rotation_speed = 20e3 / 460.0 * (1.0 + change);
    const rollfem_patch patch = solve(make(definition), state).patch[0];
    const auto scenes = rollfem::track::balance(falling_case(change, 12)).scenes;
    ASSERT_EQ(scenes.size(), 1u);
    const auto point = rollfem::halfspace::run_halfspace(scenes.front(), {}).points.front();
    EXPECT_LT(std::hypot(patch.longitudinal_force - point.longitudinal_force,
                         patch.lateral_force - point.lateral_force),
              0.01 * 0.3 * 50e3)
        << change;
  }
}

TEST(CFriction, OfALayerThatYieldsIsThatOfTheCaseFile) {
  rollfem_definition definition = defaults(ROLLFEM_RIGHT);
  definition.layer_thickness = 0.5;
  definition.layer_shear_modulus = 8200.0;
  definition.layer_yield_stress = 120.0;
  definition.layer_hardening = 2000.0;
  const rollfem_result quick = solve(make(definition), state_at(3.0, 0.002));
  contact::Case input = case_at(3.0, 0.002, R"(
    [layer]
    thickness = 0.5
    shear_modulus = 8200.0
    yield_stress = 120.0
    hardening = 2000.0
  )");
  input.contact_grid.elements_across = 24;
  const auto scenes = rollfem::track::balance(input).scenes;
  ASSERT_EQ(scenes.size(), 1u);
  const auto point = rollfem::halfspace::run_halfspace(scenes.front(), {}).points.front();
  const rollfem_patch& patch = quick.patch[0];
  EXPECT_LT(std::hypot(patch.longitudinal_force - point.longitudinal_force,
                       patch.lateral_force - point.lateral_force),
            0.015 * 0.3 * 50e3);
  const rollfem_patch without = solve(make(defaults(ROLLFEM_RIGHT)), state_at(3.0, 0.002)).patch[0];
  EXPECT_GT(std::hypot(patch.longitudinal_force - without.longitudinal_force,
                       patch.lateral_force - without.lateral_force),
            0.1 * 0.3 * 50e3);
}

TEST(CFriction, IsInTheUnitsOfThePair) {
  const rollfem_state state = state_at(3.0, 0.002);
  rollfem_state in_m = state;
  for (double rollfem_state::*length :
       {&rollfem_state::lateral_shift, &rollfem_state::forward_speed,
        &rollfem_state::lateral_velocity})
    in_m.*length *= 1e-3;
  rollfem_definition definition = falling(), definition_in_m = falling(ROLLFEM_M_N);
  using Member = double rollfem_definition::*;
  for (const auto& [member, value, in_mm] :
       {std::tuple<Member, double, double>{&rollfem_definition::second_part, 0.05, 1.0},
        {&rollfem_definition::second_half_velocity, 30.0, 1e-3},
        {&rollfem_definition::memory_distance, 0.003, 1e-3},
        {&rollfem_definition::memory_velocity, 5.0, 1e-3},
        {&rollfem_definition::layer_thickness, 1.0, 1e-3},
        {&rollfem_definition::layer_shear_modulus, 8200.0, 1e6},
        {&rollfem_definition::layer_yield_stress, 250.0, 1e6},
        {&rollfem_definition::layer_hardening, 2000.0, 1e9}}) {
    definition.*member = value;
    definition_in_m.*member = value * in_mm;
  }
  const rollfem_result one = solve(make(definition), state),
                       other = solve(make(definition_in_m), in_m);
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(one.force[d], other.force[d], 1e-6 * 50e3);
}

TEST(CFriction, RefusesMissingAndUnusedMembers) {
  const auto refusal = [](const rollfem_definition& definition) {
    char message[1000];
    EXPECT_EQ(rollfem_create(&definition, message, sizeof message), nullptr);
    return std::string(message);
  };
  rollfem_definition definition = falling();
  definition.kinetic_coefficient = 0.0;
  EXPECT_NE(refusal(definition).find("kinetic_coefficient"), std::string::npos);
  definition = falling();
  definition.half_velocity = -1.0;
  EXPECT_NE(refusal(definition).find("half_velocity"), std::string::npos);
  definition = falling();
  definition.friction_law = ROLLFEM_CONSTANT;
  EXPECT_NE(refusal(definition).find("but friction.law is constant"), std::string::npos);
  definition = defaults();
  definition.layer_thickness = 1.0;
  EXPECT_NE(refusal(definition).find("layer.shear_modulus"), std::string::npos);
  definition = defaults();
  definition.law_constants[1] = 2.0;
  EXPECT_NE(refusal(definition).find("law_constants[1] = 2: the law constant"), std::string::npos);
  definition = defaults();
  definition.friction_law = static_cast<rollfem_law>(7);
  EXPECT_NE(refusal(definition).find("friction_law = 7"), std::string::npos);
}

TEST(CFriction, AProgramOfAnEarlierHeaderHasConstantFriction) {
  rollfem_definition earlier = falling();
  earlier.struct_size = offsetof(rollfem_definition, kinetic_coefficient);
  const rollfem_state state = state_at(3.0, 0.002);
  EXPECT_EQ(solve(make(earlier), state).force[0],
            solve(make(defaults(ROLLFEM_RIGHT)), state).force[0]);
}

}  // namespace

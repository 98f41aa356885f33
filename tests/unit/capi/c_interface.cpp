// SPDX-License-Identifier: LGPL-2.1-or-later
// rollfem.h against Hertz, full sliding, the model halfspace on a fine grid, and itself: units,
// sides, threads, refusals.
#include "halfspace/model/halfspace_model.hpp"
#include "track/balance/balance.hpp"

#include "rollfem/rollfem.h"
#include "support/wheel_on_rail.hpp"
#include <cstring>
#include <thread>

namespace {

TEST(CInterface, CrownedRailUnderACylindricalWheelIsHertz) {
  const TemporaryFolder folder;
  const Pair pair = sphere_on_plane(folder, 0.3);
  rollfem_state state = state_at(0.0, 0.0);
  state.rotation_speed = 20e3 / 300.0 * 1.1;  // slides all over
  state.lateral_velocity = state.yaw_rate = 0.0;
  const rollfem_result result = solve(pair, state);
  ASSERT_EQ(result.patch_count, 1);
  // A sphere of 300 mm on a plane.
  const double modulus = 210e3 / (2.0 * (1.0 - 0.09));
  const double a = std::cbrt(0.75 * 50e3 * 300.0 / modulus);
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(result.patch[0].max_pressure / (1.5 * 50e3 / (pi * a * a)), 1.0, 0.01);
  EXPECT_NEAR(result.patch[0].length / (2.0 * a), 1.0, 0.01);
  EXPECT_NEAR(result.patch[0].width / (2.0 * a), 1.0, 0.01);
  // Its surface moves backwards over the rail, which pushes it forwards by mu N, with the arm of
  // the radius about the axle.
  EXPECT_NEAR(result.force[0], 0.3 * 50e3, 1e-3 * 15e3);
  EXPECT_NEAR(result.force[2], -50e3, 1e-3);
  EXPECT_NEAR(result.moment[1] / (300.0 * result.force[0]), 1.0, 2e-3);
}

/// Of the forces from those of a patch by itself, over mu F_n.
double difference(const rollfem_result& quick, const rollfem::contact::Case& input,
                  double of_pressure = 0.01) {
  const auto scenes = rollfem::track::balance(input).scenes;
  EXPECT_EQ(scenes.size(), 1u);
  const auto fine = rollfem::halfspace::run_halfspace(scenes.front(), {}).points.front();
  EXPECT_NEAR(quick.patch[0].max_pressure / fine.max_pressure, 1.0, of_pressure);
  return std::hypot(quick.patch[0].longitudinal_force - fine.longitudinal_force,
                    quick.patch[0].lateral_force - fine.lateral_force) /
         (0.3 * fine.normal_force);
}

double largest_difference(double shift, double yaw) {
  return difference(solve(make(defaults(ROLLFEM_RIGHT)), state_at(shift, yaw)),
                    case_at(shift, yaw));
}

TEST(CInterface, ForcesAreWithinOnePercentOfTheModelHalfspace) {
  EXPECT_LT(largest_difference(-2.0, -0.001), 0.01);
  EXPECT_LT(largest_difference(3.0, 0.002), 0.01);
  EXPECT_LT(largest_difference(6.0, 0.0), 0.01);
}

TEST(CInterface, FrictionBoundsWhatThePressureDoesNotHaveOfTheLateralForce) {
  rollfem_definition definition = defaults(ROLLFEM_RIGHT);
  definition.friction_coefficient = 1e-9;
  rollfem_state state = state_at(2.03, -0.0215);
  state.roll = -0.0075;
  const rollfem_result result = solve(make(definition), state);
  ASSERT_GT(result.patch_count, 0);
  double pressed = 0.0;
  for (int k = 0; k < result.patch_count; ++k) {
    const rollfem_patch& patch = result.patch[k];
    pressed = std::max(pressed, std::abs(patch.lateral_pressure));
    EXPECT_LT(std::hypot(patch.longitudinal_force, patch.lateral_force - patch.lateral_pressure),
              1.01e-9 * patch.normal_force + 1e-9);
  }
  EXPECT_GT(pressed, 10.0) << "the patch climbs";
}

TEST(CInterface, APatchOfTwoRegionsIsAsCloseOnItsFinerGrid) {
  const rollfem_result quick = solve(make(defaults(ROLLFEM_RIGHT)), state_at(5.0, 0.004));
  // The peak of the pressure is narrower than the elements of both.
  EXPECT_LT(difference(quick, case_at(5.0, 0.004), 0.2), 0.01);
}

TEST(CInterface, ContactsInPlanesOfTheirOwnShareTheLoadAsInTheModelHalfspace) {
  const double shift = 5.9, yaw = 0.03, roll = -2.5e-5 * shift * shift;
  rollfem_state state = state_at(shift, yaw);
  state.roll = roll;
  const rollfem_result quick = solve(make(defaults(ROLLFEM_RIGHT)), state);
  rollfem::contact::Case input = case_at(shift, yaw);
  input.wheelset.roll = {roll};
  const auto scenes = rollfem::track::balance(input).scenes;
  ASSERT_EQ(scenes.size(), 2u);
  ASSERT_EQ(quick.patch_count, 2);
  const double all = quick.patch[0].normal_force + quick.patch[1].normal_force;
  for (int k = 0; k < 2; ++k) {
    const auto fine =
        rollfem::halfspace::run_halfspace(scenes[static_cast<std::size_t>(k)], {}).points.front();
    const rollfem_patch& patch = quick.patch[k];
    EXPECT_NEAR(patch.normal_force, fine.normal_force, 0.01 * all);
    EXPECT_NEAR(patch.longitudinal_force, fine.longitudinal_force, 0.01 * 0.3 * all);
    EXPECT_NEAR(patch.lateral_force, fine.lateral_force, 0.01 * 0.3 * all);
    EXPECT_NEAR(patch.max_pressure, fine.max_pressure, patch.max_pressure_bar);
  }
  EXPECT_NEAR(quick.force[2], -50e3, 1e-3);
}

TEST(CInterface, TheLargestPressureIsWithinItsBar) {
  // Where arcs of S1002 join, where the patch falls into two regions, and where it is smooth.
  const Pair pair = make(defaults(ROLLFEM_RIGHT));
  for (const double shift : {-2.0, -0.2, 0.0, 0.4, 0.8, 3.0, 4.8, 5.0}) {
    rollfem::contact::Case input = case_at(shift, 0.0);
    input.contact_grid.elements_across = 64;
    const auto scenes = rollfem::track::balance(input).scenes;
    const auto fine = rollfem::halfspace::run_halfspace(scenes.front(), {}).points.front();
    const rollfem_patch patch = solve(pair, state_at(shift, 0.0)).patch[0];
    EXPECT_NEAR(patch.max_pressure, fine.max_pressure, patch.max_pressure_bar) << shift;
    EXPECT_LT(patch.max_pressure_bar, 0.2 * patch.max_pressure) << shift;
    if (shift == -2.0 || shift == 3.0) {
      EXPECT_LT(patch.max_pressure_bar, 0.02 * patch.max_pressure) << shift;
    }
  }
}

TEST(CInterface, ContactsThatMeetAreOneOnACurvedSurface) {
  rollfem::contact::Case input = case_at(6.6, 0.005);
  input.surface = rollfem::contact::SurfaceForm::curved;
  const rollfem_result quick = solve(make(defaults(ROLLFEM_RIGHT)), state_at(6.6, 0.005));
  EXPECT_NEAR(quick.force[2], -50e3, 5.0);
  EXPECT_LT(difference(quick, input), 0.02);
}

TEST(CInterface, LeftMirrorsRight) {
  rollfem_state state = state_at(3.0, 0.002);
  const rollfem_result right = solve(make(defaults(ROLLFEM_RIGHT)), state);
  state.lateral_shift = -3.0;
  state.yaw = -0.002;
  state.lateral_velocity = -30.0;
  state.yaw_rate = -0.02;
  const rollfem_result left = solve(make(defaults(ROLLFEM_LEFT)), state);
  const double of_force = 1e-6 * 50e3;
  EXPECT_NEAR(left.force[0], right.force[0], of_force);
  EXPECT_NEAR(left.force[1], -right.force[1], of_force);
  EXPECT_NEAR(left.force[2], -50e3, of_force);
  EXPECT_NEAR(left.moment[0], -right.moment[0], 750.0 * of_force);
  EXPECT_NEAR(left.moment[2], -right.moment[2], 750.0 * of_force);
  EXPECT_NEAR(left.patch[0].position[1], -right.patch[0].position[1], 1e-6);
}

TEST(CInterface, UnitsAreOnlyUnits) {
  const rollfem_result mm = solve(make(defaults()), state_at(2.0, 0.001));
  const struct {
    rollfem_units units;
    double length, force;  // what one of them is in mm, N
  } others[] = {{ROLLFEM_M_N, 1e3, 1.0}, {ROLLFEM_MM_KN, 1.0, 1e3}};
  for (const auto& [units, length, force] : others) {
    rollfem_state state = state_at(2.0, 0.001);
    state.lateral_shift /= length;
    state.forward_speed /= length;
    state.lateral_velocity /= length;
    state.vertical_force /= force;
    const rollfem_result other = solve(make(defaults(ROLLFEM_LEFT, units)), state);
    const rollfem_patch &a = mm.patch[0], &b = other.patch[0];
    EXPECT_NEAR(b.longitudinal_force * force / a.longitudinal_force, 1.0, 1e-6);
    EXPECT_NEAR(b.max_pressure * force / (length * length) / a.max_pressure, 1.0, 1e-6);
    EXPECT_NEAR(b.spin / length / a.spin, 1.0, 1e-6);
    EXPECT_NEAR(b.area * length * length / a.area, 1.0, 1e-6);
    EXPECT_NEAR(other.moment[2] * force * length / mm.moment[2], 1.0, 1e-6);
    EXPECT_NEAR(other.touching_height * length / mm.touching_height, 1.0, 1e-6);
  }
}

TEST(CInterface, ThreadsSolveWithOnePair) {
  const Pair pair = make(defaults());
  const rollfem_result alone[] = {solve(pair, state_at(1.0, 0.0)),
                                  solve(pair, state_at(4.0, 0.001))};
  rollfem_result found[2];
  std::thread first([&] { found[0] = solve(pair, state_at(1.0, 0.0)); });
  std::thread second([&] { found[1] = solve(pair, state_at(4.0, 0.001)); });
  first.join();
  second.join();
  for (int k = 0; k < 2; ++k)
    for (int d = 0; d < 3; ++d) EXPECT_EQ(found[k].force[d], alone[k].force[d]);
}

TEST(CInterface, RefusesWithAReasonAndAZeroResult) {
  char message[1000];
  rollfem_definition definition = defaults();
  definition.friction_coefficient = -1.0;
  EXPECT_EQ(rollfem_create(&definition, message, sizeof message), nullptr);
  EXPECT_TRUE(says(message, "friction.coefficient = -1"));
  definition = defaults();
  definition.wheel_profile = "no\"such";
  EXPECT_EQ(rollfem_create(&definition, message, sizeof message), nullptr);
  definition.wheel_profile = nullptr;
  EXPECT_EQ(rollfem_create(&definition, nullptr, 0), nullptr);
  definition = defaults();
  definition.units = static_cast<rollfem_units>(7);
  EXPECT_EQ(rollfem_create(&definition, message, sizeof message), nullptr);

  const Pair pair = make(defaults());
  auto result = sized<rollfem_result>();
  for (double rollfem_state::*member :
       {&rollfem_state::lateral_shift, &rollfem_state::yaw, &rollfem_state::forward_speed,
        &rollfem_state::rotation_speed, &rollfem_state::vertical_force}) {
    rollfem_state state = state_at(0.0, 0.0);
    state.*member = std::nan("");
    EXPECT_EQ(rollfem_solve(pair.get(), &state, &result, message, sizeof message), ROLLFEM_REFUSED);
    EXPECT_TRUE(says(message, "out of bounds"));
    EXPECT_EQ(result.patch_count, 0);
  }
  rollfem_state state = state_at(200.0, 0.0);  // between the rails
  EXPECT_NE(rollfem_solve(pair.get(), &state, &result, message, 10), ROLLFEM_OK);
  EXPECT_EQ(std::strlen(message), 9u);
  EXPECT_EQ(result.force[2], 0.0);
}

TEST(CInterface, NullIsRefusedWithAMessageByEveryCall) {
  char message[1000];
  const auto says = [&](const char* what) {
    return std::strstr(message, what) != nullptr && std::strstr(message, "do: ") != nullptr;
  };
  const auto state = sized<rollfem_state>();
  auto result = sized<rollfem_result>();
  rollfem_defaults(nullptr, ROLLFEM_MM_N);
  EXPECT_EQ(rollfem_create(nullptr, message, sizeof message), nullptr);
  EXPECT_TRUE(says("definition is NULL")) << message;
  EXPECT_EQ(rollfem_solve(nullptr, &state, &result, message, sizeof message), ROLLFEM_REFUSED);
  EXPECT_TRUE(says("pair is NULL; allowed: what rollfem_create returned")) << message;
  const Pair pair = make(defaults());
  EXPECT_EQ(rollfem_solve(pair.get(), nullptr, &result, message, sizeof message), ROLLFEM_REFUSED);
  EXPECT_TRUE(says("state is NULL")) << message;
  EXPECT_EQ(rollfem_solve(pair.get(), &state, nullptr, message, sizeof message), ROLLFEM_REFUSED);
  EXPECT_TRUE(says("result is NULL")) << message;
  auto forces = sized<rollfem_creep_forces>();
  const auto ellipse = sized<rollfem_ellipse>();
  EXPECT_EQ(rollfem_table_forces(nullptr, &ellipse, &forces, message, sizeof message),
            ROLLFEM_REFUSED);
  EXPECT_TRUE(says("table is NULL")) << message;
  auto of_wheel = sized<rollfem_wheel_forces>();
  const auto wheel = sized<rollfem_shifted_wheel>();
  EXPECT_EQ(rollfem_table_wheel_forces(nullptr, &wheel, &of_wheel, message, sizeof message),
            ROLLFEM_REFUSED);
  EXPECT_TRUE(says("table is NULL")) << message;
  rollfem_destroy(nullptr);
  rollfem_table_close(nullptr);
}

TEST(CInterface, AnUnknownSideIsRefused) {
  char message[1000];
  rollfem_definition definition = defaults();
  definition.side = static_cast<rollfem_side>(9);
  EXPECT_EQ(rollfem_create(&definition, message, sizeof message), nullptr);
  EXPECT_TRUE(says(message, "side = 9: is not known; allowed: ROLLFEM_LEFT"));
}

}  // namespace

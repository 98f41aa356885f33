// SPDX-License-Identifier: LGPL-2.1-or-later
// A wheelset in balance, checked by its conditions: vertical forces with friction add up to the
// load on every wheel, free rolling has no torque or no force, patches of one wheel share its load;
// and a missing balance is reported.
#include "base/errors.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "track/balance/balance.hpp"
#include "track/motion/placed_scenes.hpp"

#include "support/temporary_folder.hpp"
#include "support/worn_wheels.hpp"

namespace {

constexpr double load = 60e3;
constexpr double mu = 0.3;

Case scene_at(double shift, double yaw) {
  Case input;
  input.file = "wheelset";
  input.load.vertical_force = load;
  input.friction_coefficient = mu;
  input.wheel.rolling_radius = 460.0;
  input.wheel.profile.name = "S1002";
  input.rail.profile.name = "60E1";
  input.track.inclination = 1.0 / 40.0;
  input.wheelset.side = WheelSide::both;
  input.wheelset.lateral_shift = {shift};
  input.wheelset.yaw = {yaw};
  return input;
}

struct Solved {
  double vertical = 0.0;  ///< N, of the wheel
  double torque = 0.0;    ///< N mm about the axle, F_x rho
  int patches = 0;
};

/// On a finer grid than the one that the balance was found with.
std::map<bool, Solved> solved(const std::vector<contact::Scene>& scenes) {
  std::map<bool, Solved> wheels;
  for (contact::Scene scene : scenes) {
    scene.contact_grid.elements_across = 40;
    const auto result = halfspace::run_halfspace(scene, {});
    const auto& point = result.points.front();
    Solved& wheel = wheels[scene.place->left];
    wheel.vertical += track::vertical_force(point.normal_force, point.lateral_force, *scene.place);
    wheel.torque += point.longitudinal_force * scene.place->rolling_radius;
    ++wheel.patches;
  }
  return wheels;
}

}  // namespace

TEST(WheelsetBalance, VerticalForcesAddUpToTheLoadAlsoOnTheFlange) {
  // At 8 mm the right wheel stands on its flange at 54 degrees and slides: 27 % of its normal force
  // more than the load. Every model finds its normal force with its own friction.
  for (const double shift : {3.0, 8.0}) {
    const auto wheels = solved(track::balance(scene_at(shift, 0.0024 * shift)).scenes);
    ASSERT_EQ(wheels.size(), 2U);
    for (const auto& [left, wheel] : wheels)
      EXPECT_NEAR(wheel.vertical, load, 1e-6 * load) << shift << ' ' << left;
  }
}

TEST(WheelsetBalance, TwoContactsOfOneWheelShareItsLoad) {
  // Tread and flange, whose planes have nothing in common.
  const auto balanced = track::balance(steep_flange(-4.29));
  const auto wheels = solved(balanced.scenes);
  EXPECT_EQ(wheels.at(true).patches, 2);
  EXPECT_NEAR(wheels.at(true).vertical, load, 1e-6 * load);
  // The more loaded one comes first.
  double last = 0.0;
  for (const contact::Scene& scene : balanced.scenes) {
    if (scene.place->patch == 2) {
      EXPECT_LT(*scene.points[0].load.force, last);
    }
    last = *scene.points[0].load.force;
  }
}

TEST(WheelsetBalance, FreeRollingHasNoTorqueOfTheWheelset) {
  Case input = scene_at(3.0, 0.004);
  input.wheelset.free_rolling = FreeRolling::torque;
  const auto wheels = solved(track::balance(input).scenes);
  const double scale = mu * load * 460.0;
  // Each wheel alone has one: the radii differ.
  EXPECT_GT(std::abs(wheels.at(true).torque), 0.05 * scale);
  // Forces at 24 elements across, with which the rotation was found, are good to half a percent of
  // mu F_z on each wheel.
  EXPECT_NEAR(wheels.at(true).torque + wheels.at(false).torque, 0.0, 1e-2 * scale);
}

TEST(WheelsetBalance, FreeRollingByForceHasNoneOnEachWheel) {
  // Not the torque: on the flange and under yaw, moment and lateral force of friction have one too.
  for (const auto& [shift, yaw] : {std::pair{3.0, 0.004}, {6.3, 0.0}, {6.78, 0.0}}) {
    Case input = scene_at(shift, yaw);
    input.wheelset.free_rolling = FreeRolling::force;
    const track::BalancedCase balanced = track::balance(input);
    EXPECT_EQ(balanced.notes.back().about, "free_rolling");
    std::map<bool, double> force;
    for (const contact::Scene& scene : balanced.scenes)
      force[scene.place->left] +=
          halfspace::run_halfspace(halfspace::on_few_elements(scene, 24), {})
              .points.front()
              .longitudinal_force;
    ASSERT_EQ(force.size(), 2U);
    for (const auto& [left, sum] : force) EXPECT_NEAR(sum, 0.0, 1e-4 * mu * load) << shift << left;
    for (const auto& [left, wheel] : solved(balanced.scenes))
      EXPECT_NEAR(wheel.torque, 0.0, 5e-3 * mu * load * 460.0) << shift << left;
  }
}

TEST(WheelsetBalance, CreepagesThatAreGivenStand) {
  Case input = scene_at(2.0, 0.003);
  input.rolling.creepages = {{0.001, 0.0, 0.0}, {0.002, 0.0, 0.0}};
  input.rolling.given.longitudinal = true;
  for (const contact::Scene& scene : track::balance(input).scenes) {
    EXPECT_EQ(scene.points[0].creepage.longitudinal, 0.001);
    EXPECT_EQ(scene.points[1].creepage.longitudinal, 0.002);
    // Yaw turns the wheels against their way: eta = yaw / cos(angle).
    EXPECT_NEAR(scene.points[1].creepage.lateral, 0.003 / std::cos(scene.place->contact_angle),
                2e-5);
  }
}

TEST(WheelsetBalance, FrictionOnTheFlangeSettlesWhereAnElementComesIntoContact) {
  // The elements in contact depend on the load carried by friction, and friction on the elements in
  // contact: at these places either state leads to the other.
  constexpr double heavy = 80e3;
  for (const double shift : {-7.32, -7.321, -8.51}) {
    SCOPED_TRACE(shift);
    Case input = scene_at(shift, 0.0);
    input.load.vertical_force = heavy;
    input.wheel.material = input.rail.material = {209920.0, 0.28};
    input.wheelset.side = WheelSide::left;
    input.wheelset.roll = {0.0};
    const auto wheels = solved(track::balance(input).scenes);
    ASSERT_EQ(wheels.size(), 1U);
    EXPECT_NEAR(wheels.at(true).vertical, heavy, 1e-6 * heavy);
  }
}

TEST(WheelsetBalance, FrictionThatLiftsTheWheelIsReported) {
  // A flange at 54 degrees that slides down is carried upwards by friction: cos - mu sin < 0.
  Case input = scene_at(8.0, 0.02);
  input.wheelset.side = WheelSide::right;
  input.friction_coefficient = 2.0;
  // The other way round friction holds the wheel down, and there is a balance.
  const auto balanced = track::balance(input);
  ASSERT_EQ(balanced.scenes.size(), 1U);
  EXPECT_LT(halfspace::run_halfspace(balanced.scenes.front(), {}).points[0].normal_force, load);
  input.wheelset.yaw = {-0.02};
  EXPECT_TRUE(
      says(refusal<contact::SolveError>([&] { solved(track::balance(input).scenes); }), "Nadal"));
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// A wheel that is pressed without friction: creep forces under its normal forces, of one contact as
// the model halfspace has them and of two in other planes as sums on the track.
#include "track/balance/pressed_wheel.hpp"

#include "base/errors.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "track/balance/position.hpp"

#include "support/worn_wheels.hpp"

namespace {

using track::FrictionForce;
using track::PressedWheel;

PressedWheel pressed(const contact::Case& input) {
  return PressedWheel(input, track::search_scene_of(input));
}

contact::Case on_grid(contact::Case input, int across = 16) {
  input.contact_grid.elements_across = across;
  return input;
}

TEST(PressedWheel, OfOneContactIsTheModelHalfspace) {
  contact::Case input = on_grid(hollow_tread(1.0));
  input.load = {};
  input.load.normal_force = 80e3;
  input.rolling.given = {true, true, true};
  input.rolling.creepages = {{0.001, -0.0005, 2e-4}, {-0.002, 0.001, 1e-4}};
  const auto scenes = track::make_scenes(input);
  ASSERT_EQ(scenes.size(), 1U);
  const contact::ModelResult whole = halfspace::run_halfspace(scenes[0].scene, {});
  const PressedWheel wheel = pressed(input);
  const auto found = wheel.forces(input.rolling.creepages, contact::friction_of(input));
  for (std::size_t k = 0; k < 2; ++k) {
    const contact::PointResult& point = whole.points[k];
    EXPECT_NEAR(found[k].longitudinal, point.longitudinal_force, 1e-10 * 24e3);
    EXPECT_NEAR(found[k].lateral, point.lateral_force, 1e-10 * 24e3);
    EXPECT_NEAR(found[k].spin_moment, point.spin_moment, 1e-10 * 24e3 * 5.0);
    EXPECT_NEAR(found[k].normal, 0.0, 1e-10 * 80e3);
    EXPECT_NEAR(found[k].moment_bar, point.error_estimate.at("spin_moment"), 1e-9);
  }
  const track::PressedState& state = wheel.state();
  EXPECT_EQ(state.contacts, 1);
  EXPECT_EQ(state.normal_force, 80e3);
  EXPECT_NEAR(state.max_pressure, whole.points[0].max_pressure, 1e-6);
  // Axes of the load, to the 1 % of the coarse search.
  EXPECT_NEAR(state.semi_axis_x / whole.points[0].semi_axis_x, 1.0, 0.1);
}

/// On the track: along it, to the side and upwards; the moment is that of the contact alone.
struct OnTrack {
  double along = 0.0, side = 0.0, up = 0.0;

  void add(double x, double y, double z, const contact::ContactPlace& place) {
    const double angle = place.contact_angle;
    along += x;
    side += z * std::sin(angle) - y * std::cos(angle);
    up += z * std::cos(angle) + y * std::sin(angle);
  }
};

TEST(PressedWheel, OfTwoPlanesIsTheSumOfBothUnderOneMotion) {
  contact::Case input = on_grid(steep_flange(-4.3));
  const PressedWheel wheel = pressed(input);
  ASSERT_EQ(wheel.state().contacts, 2);
  // The wheelset's motion gives both contacts their creepages.
  contact::Case moving = input;
  moving.friction_coefficient = 0.0;
  moving.wheelset.rotation_change = {0.002};
  moving.wheelset.lateral_velocity = 0.001;
  moving.wheelset.yaw_velocity = 2e-5;
  track::SearchOptions options;
  options.with_reserve = true;
  auto scenes = track::balanced_position(moving, track::make_scenes(moving, options));
  ASSERT_EQ(scenes.size(), 2U);
  OnTrack sum;
  double normal_force = 0.0;
  for (contact::Scene& scene : scenes) {
    const contact::PointResult without = halfspace::run_halfspace(scene, {}).points.front();
    scene.points.front().load = {without.normal_force, {}};
    scene.friction_law = contact::coulomb(0.3);
    const contact::PointResult with = halfspace::run_halfspace(scene, {}).points.front();
    sum.add(with.longitudinal_force, with.lateral_force - without.lateral_force,
            with.normal_force - without.normal_force, *scene.place);
    normal_force += without.normal_force;
  }
  const FrictionForce found =
      wheel.forces({scenes.front().points.front().creepage}, contact::coulomb(0.3)).front();
  OnTrack turned;
  turned.add(found.longitudinal, found.lateral, found.normal, wheel.state().place);
  const double bound = 0.3 * normal_force;
  EXPECT_NEAR(wheel.state().normal_force, normal_force, 1e-6 * normal_force);
  EXPECT_NEAR(turned.along, sum.along, 1e-6 * bound);
  EXPECT_NEAR(turned.side, sum.side, 1e-6 * bound);
  EXPECT_NEAR(turned.up, sum.up, 1e-6 * bound);
  EXPECT_GT(std::abs(found.normal), 1e-3 * bound);  // the flange's friction
}

TEST(PressedWheel, IsOddWhereItsSurfaceBringsNoSlip) {
  const Creepage creepage{0.0007, -0.0004, 1.5e-4};
  const std::vector<Creepage> both{creepage,
                                   {-creepage.longitudinal, -creepage.lateral, -creepage.spin}};
  contact::Case input = on_grid(hollow_tread(1.0));
  const auto sum_of = [&] {
    const auto found = pressed(input).forces(both, contact::coulomb(0.3));
    return std::hypot(found[0].longitudinal + found[1].longitudinal,
                      found[0].lateral + found[1].lateral);
  };
  EXPECT_GT(sum_of(), 1e-3 * 0.3 * 80e3);  // rolling radii of the rim
  input.rolling.extra_slip = contact::ExtraSlip::none;
  EXPECT_LT(sum_of(), 1e-6 * 0.3 * 80e3);
}

TEST(PressedWheel, ThatHasLeftItsRailIsRefused) {
  EXPECT_ANY_THROW(pressed(hollow_tread(90.0)));
}

}  // namespace

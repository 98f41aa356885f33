// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction that varies over the inclination of the rail or along the track: full sliding over a
// crowned rail against the integral of mu times Hertz's pressure, equal points against one law,
// mirrored wheels, and the models that refuse it.
#include "base/errors.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "scene/scene.hpp"
#include "track/motion/placed_scenes.hpp"

#include "support/half_space_models.hpp"
#include "support/test.hpp"

namespace {

constexpr double load = 80e3, rail_radius = 300.0, wheel_radius = 460.0;

/// A wheel of this slope, straight across, on a crowned rail; creepages as given, no other slip.
Case crowned(double slope, const contact::Creepage& creepage, bool left = true) {
  Case input;
  input.file = "crowned rail";
  input.load.normal_force = load;
  input.friction_coefficient = 0.3;
  input.wheel.rolling_radius = wheel_radius;
  input.wheel.profile.name = input.rail.profile.name = "arcs";
  input.wheel.profile.radii = {contact::infinity};
  input.wheel.profile.ends = {-60.0, 60.0};
  input.wheel.profile.slope = slope;
  input.rail.profile.radii = {rail_radius, 20.0};
  input.rail.profile.ends = {22.0, 39.9};
  input.rail.profile.symmetric = true;
  input.wheelset.flange_back_position = -76.0;
  input.wheelset.side = left ? contact::WheelSide::left : contact::WheelSide::right;
  input.wheelset.roll = {0.0};
  input.rolling.given = {true, true, true};
  input.rolling.creepages = {creepage};
  input.rolling.extra_slip = contact::ExtraSlip::none;
  input.contact_grid.elements_across = 24;
  return input;
}

void set_points(Case& input, const std::vector<double>& inclination,
                const std::vector<double>& coefficient) {
  input.friction_variation.inclination = inclination;
  for (const double mu : coefficient) {
    input.friction_variation.points.push_back({mu, input.friction_fall});
    input.friction_coefficient = std::max(input.friction_coefficient, mu);
  }
}

PointResult solved(const Case& input) {
  const auto scenes = track::make_scenes(input);
  EXPECT_EQ(scenes.size(), 1U);
  return halfspace::run_halfspace(scenes.at(0).scene, {}).points.at(0);
}

TEST(FrictionOverRail, SlidingForceIsTheIntegralOfMuAndHertzsPressure) {
  // mu = 0.1 on the side of the gauge face, and rises by 10 per rad from the top to the field. With
  // the pressure of the ellipse summed along x, 1 - (y/b)^2, and an inclination of y/R:
  // F = (0.1 + 10 (3 b/16)/R) F_n, and F times its lever is 10 (b^2/10)/R F_n.
  const double modulus = contact::combine(contact::Material(), contact::Material()).contact_modulus;
  const double b =
      halfspace::hertz_from_force(0.5 / wheel_radius, 0.5 / rail_radius, modulus, load).semi_axis_y;
  const double force = (0.1 + 10.0 * 3.0 * b / (16.0 * rail_radius)) * load;
  const double moment = b * b / rail_radius * load;
  for (const auto surface : {contact::SurfaceForm::planar, contact::SurfaceForm::curved})
    for (const bool left : {true, false}) {
      Case input = crowned(0.0, {0.05, 0.0, 0.0}, left);
      input.halfspace.surface = surface;
      set_points(input, {-0.04, 0.0, 0.04}, {0.1, 0.1, 0.5});
      const PointResult point = solved(input);
      EXPECT_NEAR(-point.longitudinal_force / force, 1.0, 1e-3);
      // y points to the field on the left and to the middle on the right.
      EXPECT_NEAR(point.spin_moment / (left ? moment : -moment), 1.0, 5e-3);
    }
}

TEST(FrictionOverRail, IsThatOfTheRailBelowTheRowWhereTheGridFollowsTheSurface) {
  // Circles of 50 and -60 mm: the grid lies along their mean, on which y = R sin(s/R), and the
  // rail's inclination there is asin(y/50). With s in place of y, mu is off by up to 3e-3.
  Case input = crowned(0.0, {0.05, 0.0, 0.0});
  input.load.normal_force = 400e3;
  input.rail.profile.radii = {50.0};
  input.rail.profile.ends = {42.0};
  input.wheel.profile.radii = {-60.0};
  input.wheel.profile.ends = {-42.0, 42.0};
  input.wheelset.flange_back_position = -72.1987;  // above the middle of the rail
  input.halfspace.surface = contact::SurfaceForm::curved;
  set_points(input, {-0.5, 0.5}, {0.1, 5.1});
  const auto result = halfspace::run_halfspace(track::make_scenes(input).at(0).scene, {});
  const contact::ContactFields& fields = result.points.at(0).fields;
  const double radius = 2.0 / (1.0 / 50.0 + 1.0 / 60.0);
  double farthest = 0.0;
  for (int j = 0; j < result.grid.ny; ++j) {
    const Eigen::Index k = result.grid.index(result.grid.nx / 2, j);
    if (!(fields.traction.n[k] > 0.0)) continue;
    const double s = result.grid.y(j), y = radius * std::sin(s / radius);
    farthest = std::max(farthest, std::abs(s));
    EXPECT_NEAR(fields.traction_bound[k] / fields.traction.n[k], 2.6 + 5.0 * std::asin(y / 50.0),
                5e-4);
  }
  EXPECT_GT(farthest, 7.0);
}

void expect_same(const Case& one, const Case& points) {
  const PointResult a = solved(one), b = solved(points);
  EXPECT_EQ(a.longitudinal_force, b.longitudinal_force);
  EXPECT_EQ(a.lateral_force, b.lateral_force);
  EXPECT_EQ(a.spin_moment, b.spin_moment);
  EXPECT_EQ((a.fields.traction_bound - b.fields.traction_bound).norm(), 0.0);
}

TEST(FrictionOverRail, EqualPointsAreOneLawToTheLastBit) {
  const contact::Creepage partial{0.001, 0.0005, 1e-4};
  const Case one = crowned(-0.03, partial);
  Case points = one;
  set_points(points, {-0.05, -0.03, -0.01}, {0.3, 0.3, 0.3});
  expect_same(one, points);
  Case falling = one;
  falling.rolling.speed = 10e3;
  falling.friction_fall.shape = contact::FallShape::exponential;
  falling.friction_fall.kinetic_coefficient = 0.15;
  falling.friction_fall.half_velocity = 200.0;
  falling.friction_fall.memory_distance = 5e-3;
  points = falling;
  set_points(points, {-0.05, -0.01}, {0.3, 0.3});
  expect_same(falling, points);
}

TEST(FrictionOverRail, MirroredWheelsHaveMirroredForces) {
  const auto on = [](bool left) {
    const double side = left ? 1.0 : -1.0;
    Case input = crowned(-0.03, {0.001, side * 0.0005, side * 1e-4}, left);
    set_points(input, {-0.05, -0.03, -0.01}, {0.1, 0.2, 0.5});
    return solved(input);
  };
  const PointResult left = on(true), right = on(false);
  EXPECT_NEAR(left.longitudinal_force, right.longitudinal_force, 1e-6 * load);
  EXPECT_NEAR(left.lateral_force, -right.lateral_force, 1e-6 * load);
  EXPECT_NEAR(left.spin_moment, -right.spin_moment, 1e-6 * load);
}

TEST(FrictionOverRail, APrescribedForceMayReachTheMeanBound) {
  // 90 % of the sliding force, of which the largest coefficient allows 2.5 times as much.
  Case input = crowned(0.0, {0.05, 0.0, 0.0});
  set_points(input, {-0.04, 0.0, 0.04}, {0.1, 0.1, 0.5});
  const double sliding = solved(input).longitudinal_force;
  const auto with_force = [&](double force) {
    input.rolling.creepages = {{}};
    input.rolling.forces = {{force, {}}};
    return solved(input).longitudinal_force;
  };
  EXPECT_NEAR(with_force(0.9 * sliding), 0.9 * sliding, 1e-5 * load);
  EXPECT_THROW(with_force(1.1 * sliding), contact::SolveError);
}

TEST(FrictionOverRail, IsLinearBetweenPlacesAlongTheTrack) {
  Case input = crowned(0.0, {0.001, 0.0, 0.0});
  set_points(input, {}, {0.1, 0.5});
  input.friction_variation.track_position = {0.0, 1000.0};
  input.wheelset.track_position = {-5.0, 250.0, 2000.0};
  input.wheelset.lateral_shift = {0.0, 0.0, 0.0};
  input.wheelset.yaw = {0.0, 0.0, 0.0};
  input.wheelset.roll = {0.0, 0.0, 0.0};
  const auto scenes = track::make_scenes(input);
  ASSERT_EQ(scenes.size(), 3U);
  EXPECT_EQ(scenes[0].scene.friction_coefficient(), 0.1);
  EXPECT_NEAR(scenes[1].scene.friction_coefficient(), 0.2, 1e-15);
  EXPECT_EQ(scenes[2].scene.friction_coefficient(), 0.5);
  EXPECT_FALSE(scenes[1].scene.friction()->varies());
}

TEST(FrictionOverRail, OverYSlidingTurnsBySecondMomentOfThePressure) {
  // mu = 0.3 + 0.02 y on a Hertzian ellipse, which holds F_n b^2/5 as its second moment.
  Case input;
  input.file = "over y";
  input.load.normal_force = load;
  input.wheel.rolling_radius = wheel_radius;
  input.rail.transverse_radius = rail_radius;
  input.contact_grid.elements_across = 24;
  input.rolling.creepages = {{0.05, 0.0, 0.0}};
  input.friction_variation.lateral_position = {-10.0, 10.0};
  for (const double mu : {0.1, 0.5})
    input.friction_variation.points.push_back({mu, input.friction_fall});
  input.friction_coefficient = 0.5;
  EXPECT_FALSE(contact::Scene(input).is_symmetric());
  const PointResult point = halfspace::run_halfspace(input, {}).points.at(0);
  const double b = halfspace::hertz_of_scene(input).semi_axis_y;
  const double moment = 0.02 * load * b * b / 5.0;
  EXPECT_NEAR(point.longitudinal_force, -0.3 * load, 0.005 * 0.3 * load);
  EXPECT_NEAR(point.spin_moment, moment, 0.01 * moment);
}

TEST(FrictionOverRail, TheoriesOfOneCoefficientRefuseIt) {
  Case input = crowned(0.0, {0.001, 0.0, 0.0});
  set_points(input, {-0.04, 0.04}, {0.1, 0.5});
  const contact::Scene scene = track::make_scenes(input).at(0).scene;
  for (const char* name : {"fastsim", "strip", "linear", "vermeulen-johnson"})
    EXPECT_EQ(contact::first_beyond(half_space_models().at(name).takes, scene),
              "friction.inclination or lateral_position: it cannot handle friction that varies "
              "over the rail");
}

}  // namespace

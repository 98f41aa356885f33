// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes: one case for each patch, with load, creepages and geometry of its own.
#include "track/motion/placed_scenes.hpp"

#include "base/errors.hpp"

#include "support/temporary_folder.hpp"
#include "support/wheel_rail_cases.hpp"
#include "support/worn_wheels.hpp"

namespace {

using track::PlacedScene;

std::vector<PlacedScene> scenes_of(const contact::Case& input,
                                   const track::SearchOptions& options = {}) {
  return make_scenes(input, track::make_search_scene(input, manchester_pair()), options);
}

/// Tread and flange root of S1002, whose normals differ by 0.16 rad, as contacts of their own.
track::SearchOptions apart() {
  track::SearchOptions options;
  options.merge_angle = 0.1;
  return options;
}

std::vector<contact::Creepage> creepages_of(const PlacedScene& placed) {
  std::vector<contact::Creepage> all;
  for (const contact::LoadPoint& point : placed.scene.points) all.push_back(point.creepage);
  return all;
}

TEST(Scenes, ComeByPositionWheelAndPatch) {
  contact::Case input = manchester_case(0.0, 0.0);
  input.wheelset.side = contact::WheelSide::both;
  input.wheelset.lateral_shift = {0.0, 5.0};
  input.wheelset.yaw = {0.0, 0.012};
  const auto scenes = scenes_of(input, apart());
  // At 5 mm the right wheel touches twice, tread and flange root.
  ASSERT_EQ(scenes.size(), 5u);
  const char* labels[] = {"left, position 1", "right, position 1", "left, position 2",
                          "right, position 2, patch 1 of 2", "right, position 2, patch 2 of 2"};
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    EXPECT_EQ(scenes[k].scene.place->label(), labels[k]);
    ASSERT_TRUE(scenes[k].scene.has_profiles());
    EXPECT_TRUE(scenes[k].scene.geometry.surface.profiles->known(0.0));
  }
}

TEST(Scenes, PatchesOfNearlyOnePlaneAreOneScene) {
  const auto scenes = scenes_of(manchester_case(-5.0, -0.012));
  ASSERT_EQ(scenes.size(), 1u);
  EXPECT_EQ(scenes[0].contact.touching.size(), 2u);
  EXPECT_EQ(*scenes[0].scene.points[0].load.force, 10e3);
}

TEST(Scenes, FollowTheSurfaceAsFarAsTheirNormalsSpread) {
  const auto followed = [](const contact::Case& input) {
    const auto scenes = track::make_scenes(input);
    EXPECT_EQ(scenes.size(), 1u);
    return scenes.at(0).scene.follows_surface;
  };
  contact::Case root = shallow_root(-13.88);  // normals 0.35 rad apart
  EXPECT_EQ(followed(root), 1.0);
  root.surface = contact::SurfaceForm::planar;
  EXPECT_EQ(followed(root), 0.0);
  root.surface = contact::SurfaceForm::automatic;
  root.output.stress_maxima = true;
  EXPECT_EQ(followed(root), 0.0);
  contact::Case one_rim = hollow_tread(1.2);
  EXPECT_EQ(followed(one_rim), 0.0);
  one_rim.surface = contact::SurfaceForm::curved;
  EXPECT_EQ(followed(one_rim), 1.0);
  // Rims of 0.1 rad, the more evenly loaded the farther.
  const double uneven = followed(hollow_tread(-0.4));
  const double even = followed(hollow_tread(-0.1));
  EXPECT_GT(uneven, 0.0);
  EXPECT_GT(even, uneven);
  EXPECT_LT(even, 1.0);
}

TEST(Scenes, OnePatchCarriesTheVerticalForceByItsNormal) {
  const auto scenes = scenes_of(manchester_case(0.0, 0.0));
  ASSERT_EQ(scenes.size(), 1u);
  // Which part of it is normal is a matter of friction: the load asks for the vertical itself.
  const contact::NormalLoad& load = scenes[0].scene.points[0].load;
  const double angle = scenes[0].scene.place->contact_angle;
  EXPECT_EQ(*load.force, 10e3);
  EXPECT_DOUBLE_EQ(load.direction[1], std::cos(angle));
  EXPECT_DOUBLE_EQ(load.direction[0], (scenes[0].scene.place->left ? 1 : -1) * std::sin(angle));
}

TEST(Scenes, SeveralPatchesShareTheVerticalForce) {
  contact::Case input = manchester_case(-5.0, -0.012);
  const auto scenes = scenes_of(input, apart());
  ASSERT_EQ(scenes.size(), 2u);
  double sum = 0.0;
  for (const PlacedScene& scene : scenes)
    sum += *scene.scene.points[0].load.force * std::cos(scene.scene.place->contact_angle);
  EXPECT_NEAR(sum, 10e3, 1e-6);
  EXPECT_GT(*scenes[0].scene.points[0].load.force, *scenes[1].scene.points[0].load.force);
  // One of them touches first, the other after some sinking.
  EXPECT_NEAR(std::min(scenes[0].contact.place.separation, scenes[1].contact.place.separation), 0.0,
              1e-9);
  EXPECT_GT(std::max(scenes[0].contact.place.separation, scenes[1].contact.place.separation), 1e-4);
}

TEST(Scenes, NormalForceCannotBeSharedByTwoPatches) {
  contact::Case input = manchester_case(-5.0, -0.012);
  input.load = {};
  input.load.normal_force = 10e3;
  EXPECT_TRUE(says(refusal<contact::InputError>([&] { scenes_of(input, apart()); }), "2 patches",
                   "vertical_force = 10000"));
}

TEST(Scenes, ApproachIsThatOfTheFirstPatchAndOneSinking) {
  contact::Case input = manchester_case(-5.0, -0.012);
  input.load = {};
  input.load.approach = 0.03;
  const auto scenes = scenes_of(input, apart());
  ASSERT_EQ(scenes.size(), 2u);
  for (const PlacedScene& scene : scenes) {
    EXPECT_FALSE(scene.scene.points[0].load.force);
    // Both at one sinking, which the patch that touched first tells.
    EXPECT_GT(*scene.scene.points[0].load.approach, 0.0);
  }
  const auto sinking = [](const PlacedScene& scene) {
    return (*scene.scene.points[0].load.approach + scene.contact.place.separation) /
           std::cos(scene.contact.place.contact_angle);
  };
  EXPECT_NEAR(sinking(scenes[0]), sinking(scenes[1]), 0.02 * sinking(scenes[0]));
}

TEST(Scenes, RotationChangesMakeACreepCurve) {
  contact::Case input = manchester_case(2.0, 0.0048);
  input.rolling.creepages.resize(3);
  input.wheelset.rotation_change = {-0.002, 0.0, 0.002};
  const auto scenes = scenes_of(input);
  ASSERT_EQ(scenes.size(), 1u);
  const auto curve = creepages_of(scenes[0]);
  ASSERT_EQ(curve.size(), 3u);
  const double radius = scenes[0].contact.place.rolling_radius;
  for (std::size_t k = 0; k < 3; ++k) {
    const double change = input.wheelset.rotation_change[k];
    EXPECT_NEAR(curve[k].longitudinal, 1.0 - (1.0 + change) * radius / 460.0 * std::cos(0.0048),
                1e-6);
    EXPECT_NEAR(curve[k].lateral, (1.0 + change) * std::sin(0.0048), 3e-5);
  }
  PlacedScene free = scenes[0];
  set_rotation_changes(free, input, {-0.002, -0.002, -0.002});
  for (const auto& creepage : creepages_of(free))
    EXPECT_EQ(creepage.longitudinal, curve[0].longitudinal);
}

TEST(Scenes, GivenCreepagesStayAndTheOthersFollowFromTheMotion) {
  contact::Case input = manchester_case(2.0, 0.0048);
  input.rolling.creepages = {{0.001, 0.0, 0.0}, {0.002, 0.0, 0.0}};
  input.rolling.given.longitudinal = true;
  const auto curve = creepages_of(scenes_of(input).at(0));
  ASSERT_EQ(curve.size(), 2u);
  EXPECT_EQ(curve[0].longitudinal, 0.001);
  EXPECT_EQ(curve[1].longitudinal, 0.002);
  EXPECT_NEAR(curve[1].lateral, 0.0048, 3e-5);
  EXPECT_NEAR(curve[1].spin, -0.0134 / 460.0, 1e-6);
}

TEST(Scenes, PrescribedForceStandsInPlaceOfItsCreepage) {
  contact::Case input = manchester_case(2.0, 0.0048);
  input.rolling.forces.resize(1);
  input.rolling.forces[0].longitudinal = -100.0;
  const auto creepage = creepages_of(scenes_of(input).at(0)).at(0);
  EXPECT_EQ(creepage.longitudinal, 0.0);
  EXPECT_GT(creepage.lateral, 0.004);
}

/// What is given makes no wheel that stands on a rail: an input to correct, by its key.
TEST(MakeScenes, RefuseAWheelWithoutASurfaceAtItsContact) {
  contact::Case input;
  input.file = "scene.toml";
  input.load.vertical_force = 100e3;
  input.wheel.rolling_radius = 450.0;
  input.wheel.profile.name = "S1002";
  input.rail.profile.name = "UIC60-manchester";
  input.wheelset.roll = {0.0};
  input.wheel.profile.rotation = -1.55;
  const std::string said = refusal<contact::InputError>([&] { track::make_scenes(input); });
  EXPECT_TRUE(says(said, "[wheel_profile]"));
}

}  // namespace

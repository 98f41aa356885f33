// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes of S1002 on UIC60: the study's left wheel, and a wheel at its flange.
#pragma once

#include "case/case.hpp"
#include "track/motion/placed_scenes.hpp"

#include "support/test.hpp"
#include "support/thesis_cases.hpp"

namespace rollfem::testing {

/// All patches of the left wheel (R = 450 mm, mu 0.55, 100 kN) at this shift to the right (mm).
inline std::vector<contact::Scene> left_wheel_scenes(double lateral_shift,
                                                     const std::vector<double>& creepages = {0.0}) {
  contact::Case input;
  input.file = "scene.toml";
  input.models = {"halfspace", "fem"};
  input.load.vertical_force = 100e3;
  input.friction_coefficient = 0.55;
  input.wheel.rolling_radius = 450.0;
  input.wheel.profile.name = "S1002";
  input.rail.profile.name = "UIC60-manchester";
  input.track.inclination = 1.0 / 40.0;
  input.wheelset.lateral_shift = {lateral_shift};
  input.wheelset.roll = {0.0};
  input.rolling.given.longitudinal = true;
  input.rolling.creepages = along(creepages);
  std::vector<contact::Scene> scenes;
  for (const track::PlacedScene& placed : track::make_scenes(input)) scenes.push_back(placed.scene);
  return scenes;
}

/// 2 mm to the right: one patch of 12.7 by 16.2 mm that is no ellipse.
inline contact::Scene left_wheel_scene(const std::vector<double>& creepages = {0.0}) {
  return left_wheel_scenes(2.0, creepages).at(0);
}

/// The steepest patch of a wheel that is pushed against its rail, under 40 kN.
inline contact::Scene flange_scene() {
  std::optional<contact::Scene> steepest;
  const auto tilt = [](const contact::Scene& scene) {
    return std::abs(scene.geometry.surface.axle_tilt());
  };
  for (const contact::Scene& scene : left_wheel_scenes(-7.0))
    if (!steepest || tilt(scene) > tilt(*steepest)) steepest = scene;
  for (contact::LoadPoint& point : steepest->points) point.load = {40e3, {}};
  return *steepest;
}

}  // namespace rollfem::testing

// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheels of tangent arcs that touch their rails at two places: on a hollow tread, whose rims lie in
// nearly one plane, at tread and flange, whose normals differ by 67 degrees, and at tread and root,
// whose normals differ by 20.
#pragma once

#include "case/case.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

/// Left wheel over a rail of radius 200 mm, 80 kN: a hollow of radius 150 mm, 20 mm wide, between
/// rims of radius 50 mm. In the middle (shift 0) both rims carry the same; 1 mm beside it one
/// carries all.
inline contact::Case hollow_tread(double lateral_shift) {
  contact::Case input;
  input.file = "hollow tread";
  input.models = {"halfspace"};
  input.load.vertical_force = 80e3;
  input.friction_coefficient = 0.3;
  input.wheel.rolling_radius = 460.0;
  input.wheel.profile.name = input.rail.profile.name = "arcs";
  input.wheel.profile.radii = {50.0, -150.0, 50.0};
  input.wheel.profile.ends = {-50.0, -10.0, 10.0, 50.0};
  input.rail.profile.radii = {200.0, 20.0};
  input.rail.profile.ends = {22.0, 39.0};
  input.rail.profile.symmetric = true;
  // The hollow is over the middle of the rail.
  input.wheelset.flange_back_position = -76.0;
  input.wheelset.lateral_shift = {lateral_shift};
  input.wheelset.roll = {0.0};
  return input;
}

/// Left wheel with a root of radius 10 mm, less than the gauge corner of 60E1 has, and a flange of
/// 70 degrees. Near a shift of -4.3 mm it touches at the tread and at the flange.
inline contact::Case steep_flange(double lateral_shift) {
  contact::Case input;
  input.file = "steep flange";
  input.models = {"halfspace"};
  input.load.vertical_force = 60e3;
  input.friction_coefficient = 0.3;
  input.wheel.rolling_radius = 460.0;
  input.wheel.profile.name = "arcs";
  input.wheel.profile.radii = {12.0, contact::infinity, -10.0, contact::infinity};
  input.wheel.profile.ends = {-52.5, -37.5, -34.898, -26.0, 60.0};
  input.wheel.profile.slope = -0.05;
  input.rail.profile.name = "60E1";
  input.track.inclination = 1.0 / 40.0;
  input.wheelset.lateral_shift = {lateral_shift};
  input.wheelset.roll = {0.0};
  return input;
}

/// The same, 80 kN, with a root of radius 37 mm and a flange of 60 degrees. At a shift of -13.9 mm
/// it touches at the tread and in the root, whose normals are 0.35 rad apart.
inline contact::Case shallow_root(double lateral_shift) {
  contact::Case input = steep_flange(lateral_shift);
  input.file = "shallow root";
  input.load.vertical_force = 80e3;
  constexpr double tread_end = -26.0, radius = 37.0, flange = 1.0471975511965976;
  const double root_end = tread_end - radius * (std::sin(flange) - std::sin(std::atan(0.05)));
  input.wheel.profile.radii = {12.0, contact::infinity, -radius, contact::infinity};
  input.wheel.profile.ends = {root_end - 18.0, root_end - 3.0, root_end, tread_end, 60.0};
  return input;
}

}  // namespace rollfem::testing

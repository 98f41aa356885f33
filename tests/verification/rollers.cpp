// SPDX-License-Identifier: LGPL-2.1-or-later
// Rollers in place of rails: two spheres, bodies exchanged, lengths scaled.
#include "halfspace/model/halfspace_model.hpp"

#include "support/committed_cases.hpp"

namespace {

/// A wheel on a roller, both curved, with creepages in all directions.
contact::Case roller_case(double scale = 1.0) {
  contact::Case input = thesis_case('a', 24);
  input.load.normal_force = 50e3 * scale * scale;
  input.wheel.rolling_radius = 300.0 * scale;
  input.wheel.transverse_radius = 200.0 * scale;
  input.rail.rolling_radius = 500.0 * scale;
  input.rail.transverse_radius = 120.0 * scale;
  input.rolling.creepages = {{0.0012, 0.0008, 2e-4 / scale}};
  return input;
}

PointResult solved(const contact::Case& input) {
  return halfspace::run_halfspace(contact::Scene(input), {}).points.at(0);
}

TEST(Rollers, TwoSpheresCarryWhatTheTrueDistanceGives) {
  // 583 850 N by an independent half-space on the distance of two spheres along the normal.
  contact::Case input = thesis_case('a', 60);
  input.load = {};
  input.load.approach = 4.0;
  input.friction_coefficient = 0.0;
  input.rolling.problem = contact::Problem::frictionless;
  input.halfspace.surface = contact::SurfaceForm::curved;
  input.wheel.rolling_radius = input.wheel.transverse_radius = 50.0;
  input.rail.rolling_radius = input.rail.transverse_radius = 50.0;
  for (contact::Material* material : {&input.wheel.material, &input.rail.material})
    *material = {20e3, 0.3, material->density};
  const PointResult spheres = solved(input);
  EXPECT_NEAR(spheres.normal_force / 583850.0, 1.0, 1e-3);
  EXPECT_NEAR(spheres.contact_length / spheres.contact_width, 1.0, 1e-3);
}

TEST(Rollers, ExchangedBodiesMirrorAllResults) {
  // Half a turn about x: slip changes its sign, y and z too. V is then the other surface's speed, a
  // difference of second order in the creepage.
  const contact::Case input = roller_case();
  contact::Case other = input;
  std::swap(other.wheel.rolling_radius, other.rail.rolling_radius);
  std::swap(other.wheel.transverse_radius, other.rail.transverse_radius);
  const contact::Creepage& given = input.rolling.creepages[0];
  other.rolling.creepages = {{-given.longitudinal, given.lateral, given.spin}};
  const PointResult a = solved(input), b = solved(other);
  const double within = 1e-4 * input.friction_coefficient * a.normal_force;
  EXPECT_NEAR(b.max_pressure, a.max_pressure, 1e-6 * a.max_pressure);
  EXPECT_NEAR(b.longitudinal_force, -a.longitudinal_force, within);
  EXPECT_NEAR(b.lateral_force, a.lateral_force, within);
  EXPECT_NEAR(b.spin_moment, a.spin_moment, 5.0 * within);
  EXPECT_NEAR(b.adhesion_area, a.adhesion_area, 2e-3 * a.contact_area);
}

TEST(Rollers, EveryLengthScales) {
  const PointResult a = solved(roller_case()), b = solved(roller_case(10.0));
  EXPECT_NEAR(b.max_pressure, a.max_pressure, 1e-9 * a.max_pressure);
  EXPECT_NEAR(b.longitudinal_force, 100.0 * a.longitudinal_force, 1e-6 * b.normal_force);
  EXPECT_NEAR(b.lateral_force, 100.0 * a.lateral_force, 1e-6 * b.normal_force);
  EXPECT_NEAR(b.contact_length, 10.0 * a.contact_length, 1e-9 * b.contact_length);
}

TEST(Rollers, LineContactHasTheRelativeRadius) {
  contact::Case input = roller_case();
  input.geometry.shape = contact::ContactShape::line;
  const contact::Geometry geometry(input);
  EXPECT_NEAR(geometry.surface.rolling_radius, 1.0 / (1.0 / 300.0 + 1.0 / 500.0), 1e-9);
  EXPECT_NEAR(contact::relative_curvatures(geometry).A, 0.5 * (1.0 / 300.0 + 1.0 / 500.0), 1e-12);
}

}  // namespace

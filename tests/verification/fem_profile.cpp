// SPDX-License-Identifier: LGPL-2.1-or-later
// The model fem on patches of true profiles: circles given as profiles against radii, a sphere
// about a tilted axle, S1002 on UIC60 against the half-space on the same grid.
#include "fem/elasticity/run_level.hpp"
#include "fem/fem_options.hpp"
#include "fem/mesh/run_layout.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "scene/contact_surface.hpp"

#include "support/mpi_environment.hpp"
#include "support/patch_case.hpp"
#include "support/profile_patches.hpp"
#include "support/profile_scenes.hpp"

namespace {

contact::ModelResult solve(const contact::Scene& input, double cell) {
  return fem::run_level(input, {cell, "", false}, {});
}

contact::Case plain_case(double creepage) {
  contact::Case input;
  input.file = "test.toml";
  input.models = {"fem"};
  input.load.normal_force = 50e3;
  input.friction_coefficient = 0.55;
  input.rolling.creepages = {{creepage, 0.0, 0.0}};
  input.options.set<fem::FemOptions>().mesh = fem::MeshFamily::structured;
  input.body_extent = 36.0;
  return input;
}

void set_patch(PatchCase& input, contact::PatchGeometry geometry) {
  input.patch = std::make_shared<contact::PatchGeometry>(std::move(geometry));
}

}  // namespace

TEST(FemOnProfiles, OfCirclesIsThatOfTheRadii) {
  contact::Case radii = plain_case(0.002);
  radii.wheel.rolling_radius = 405.0;
  radii.rail.transverse_radius = 500.0;
  PatchCase curves = radii;
  set_patch(curves, circle_pair(405.0, 1e9, 500.0, 60.0));
  const contact::PointResult one = solve(radii, 1.5).points.front();
  const contact::PointResult other = solve(curves, 1.5).points.front();
  // The fine regions differ by an element at most, and a full body replaces two halves.
  EXPECT_NEAR(other.max_pressure / one.max_pressure, 1.0, 1e-3);
  EXPECT_NEAR(other.semi_axis_x / one.semi_axis_x, 1.0, 2e-3);
  EXPECT_NEAR(other.semi_axis_y / one.semi_axis_y, 1.0, 2e-3);
  EXPECT_NEAR(other.approach / one.approach, 1.0, 3e-3);
  EXPECT_NEAR(other.traction_coefficient / one.traction_coefficient, 1.0, 3e-3);
  EXPECT_LT(std::abs(other.lateral_force), 1e-3 * 50e3);
}

TEST(FemOnProfiles, OfASphereIsTheSameAboutAnyAxle) {
  std::vector<contact::PointResult> results;
  for (const double tilt : {0.0, 0.6}) {
    PatchCase input = plain_case(0.0);
    input.rolling.problem = contact::Problem::frictionless;
    set_patch(input, sphere_on_circle(405.0, 500.0, {0.0, std::cos(tilt), std::sin(tilt)}, 60.0));
    results.push_back(solve(input, 1.5).points.front());
  }
  // The chart's lines are other circles on the same sphere.
  EXPECT_NEAR(results[1].max_pressure / results[0].max_pressure, 1.0, 1e-3);
  EXPECT_NEAR(results[1].approach / results[0].approach, 1.0, 2e-3);
  EXPECT_NEAR(results[1].contact_area / results[0].contact_area, 1.0, 5e-3);
}

namespace {

/// mm, a quarter of the patch's half length.
constexpr double coarse_cell = 1.6;

contact::Scene left_wheel(fem::MeshFamily family) {
  contact::Scene scene = left_wheel_scene({0.002});
  scene.options.set<fem::FemOptions>().mesh = family;
  scene.options.set<fem::FemOptions>().linear_solver = fem::LinearMethod::factorisation;
  scene.body_extent = 30.0;
  return scene;
}

contact::PointResult half_space() {
  contact::Scene scene = left_wheel_scene({0.002});
  scene.contact_grid.cell_size = {{coarse_cell, coarse_cell}};
  return halfspace::run_halfspace(scene, {}).points.front();
}

}  // namespace

TEST(FemOnTheStudysLeftWheel, WithBoxesHasPressureAndForcesOfTheHalfSpace) {
  const contact::PointResult fem =
      solve(left_wheel(fem::MeshFamily::structured), coarse_cell).points.front();
  const contact::PointResult half = half_space();
  // Grid and cells are coarse: both are 1 to 2 % off their limit in p0.
  EXPECT_NEAR(fem.max_pressure / half.max_pressure, 1.0, 0.02);
  EXPECT_NEAR(fem.approach / half.approach, 1.0, 0.01);
  EXPECT_NEAR(fem.longitudinal_force, half.longitudinal_force, 0.02 * 0.55e5);
  EXPECT_NEAR(fem.lateral_force, half.lateral_force, 0.02 * 0.55e5);
}

/// 6 mm to the left the profiles become steeper than 56 degrees beside the patch; the box follows
/// them.
TEST(FemNearTheFlange, ASteepBoxHasThePressureOfTheHalfSpace) {
  contact::Scene scene = left_wheel_scenes(-6.0).at(0);
  EXPECT_TRUE(halfspace::is_steep(scene));
  scene.problem = contact::Problem::frictionless;
  const double cell = 3.0 * fem::default_cell_size(scene);
  const contact::PointResult fem = solve(scene, cell).points.front();
  scene.contact_grid.cell_size = {{cell, cell}};
  const contact::PointResult half = halfspace::run_halfspace(scene, {}).points.front();
  // Five elements across: both are some per cent off in p0, and alike.
  EXPECT_NEAR(fem.max_pressure / half.max_pressure, 1.0, 0.03);
  EXPECT_NEAR(fem.approach / half.approach, 1.0, 0.03);
  EXPECT_NEAR(fem.contact_area / half.contact_area, 1.0, 0.05);
  EXPECT_NEAR(fem.semi_axis_x / half.semi_axis_x, 1.0, 0.05);
}

TEST(FemOnTheStudysLeftWheel, WithTrueSectionsHasThePressureOfTheHalfSpace) {
  contact::Scene scene = left_wheel(fem::MeshFamily::gmsh);
  scene.problem = contact::Problem::frictionless;
  const contact::PointResult fem = solve(scene, 2.0).points.front();
  const contact::PointResult half = half_space();
  EXPECT_NEAR(fem.max_pressure / half.max_pressure, 1.0, 0.03);
  // Rail and rim are held 30 and 65 mm away and bend: the approach differs by a few per cent.
  EXPECT_NEAR(fem.approach / half.approach, 1.0, 0.1);
}

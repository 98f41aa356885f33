// SPDX-License-Identifier: LGPL-2.1-or-later
// Difficult patches: conforming gauge corners, two merging regions, profiles that end.
#include "support/profile_patches.hpp"

#include "base/errors.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/patch/patch_search.hpp"

#include "support/half_space_models.hpp"
#include "support/patch_case.hpp"
#include "support/temporary_folder.hpp"
#include "support/thesis_cases.hpp"

namespace {

PatchCase plain(double force) {
  PatchCase input = thesis_case('b');
  input.load.normal_force = force;
  input.rolling.creepages = {{1e-3, 0.0, 1e-3}};
  input.contact_grid.elements_across = 24;
  return input;
}

/// Rail with two crests at y = +-d, each of curvature 1/R, under a cylinder:
/// h(0, y) = (y^2 - d^2)^2 / (8 R d^2).
PatchCase two_crests(double force, double d, double radius) {
  PatchCase input = plain(force);
  const auto rail = sampled_curve(-25.0, 25.0, 0.05, [&](double y) {
    const double q = y * y - d * d;
    return HeightAndSlope{-q * q / (8.0 * radius * d * d), -q * y / (2.0 * radius * d * d)};
  });
  input.patch = std::make_shared<contact::PatchGeometry>(
      rail, contact::HeightCurve({{-30.0, 405.0, 0.0}, {30.0, 405.0, 0.0}}),
      contact::Axle{{0.0, 0.0, 405.0}, {0.0, 1.0, 0.0}}, -25.0, 25.0);
  return input;
}

/// Runs of loaded elements along the row of elements nearest to x = 0.
int regions(const contact::ModelResult& result) {
  const auto& p = result.points.front().fields.traction.n;
  const int i = result.grid.nx / 2;
  int count = 0;
  bool inside = false;
  for (int j = 0; j < result.grid.ny; ++j) {
    const bool loaded = p[result.grid.index(i, j)] > 0.0;
    count += loaded && !inside;
    inside = loaded;
  }
  return count;
}

}  // namespace

TEST(ProfilePatches, GaugeCornerConformsAndIsSolved) {
  // R13 in a hollow of 14 and 15 mm: 20 kN.
  double last_pressure = 0.0;
  for (const double hollow : {14.0, 15.0, 17.0}) {
    SCOPED_TRACE(hollow);
    PatchCase input = plain(20e3);
    input.wheel.transverse_radius = -hollow;
    input.rail.transverse_radius = 13.0;
    const auto hertz = halfspace::hertz_of_scene(input);
    input.patch = circles(405.0, -hollow, 13.0, 11.0);
    const auto point = half_space_models().run("halfspace", input, {}).points.front();
    EXPECT_NEAR(point.normal_force, 20e3, 1.0);
    // Concentric arcs part faster than their parabolas: narrower and higher than Hertz.
    const double error = point.error_estimate.at("max_pressure");
    EXPECT_GT(point.max_pressure + error, hertz.max_pressure);
    EXPECT_LT(point.contact_width, 2.0 * hertz.semi_axis_y);
    EXPECT_GT(point.max_pressure, last_pressure);
    last_pressure = point.max_pressure;
    EXPECT_NO_THROW(half_space_models().run("strip", input, {}));
    EXPECT_NO_THROW(half_space_models().run("fastsim", input, {}));
  }
}

TEST(ProfilePatches, FullyConformingCornerReachesTheEndOfItsProfiles) {
  PatchCase input = plain(20e3);
  input.patch = circles(405.0, -13.0, 13.0, 6.0);
  for (const char* model : {"halfspace", "strip", "fastsim"})
    EXPECT_THROW(half_space_models().run(model, input, {}), contact::InputError) << model;
  EXPECT_THROW(half_space_models().run("hertz", input, {}), contact::InputError);
}

TEST(ProfilePatches, TwoRegionsBecomeOne) {
  const double d = 4.0, radius = 60.0;
  const auto light = half_space_models().run("halfspace", two_crests(12e3, d, radius), {});
  // The undeformed bodies overlap from crest to crest, the deformed ones touch at the crests.
  EXPECT_EQ(regions(light), 2);
  // Two contacts of half the load each; one raises and tilts the surface under the other.
  PatchCase half = plain(6e3);
  half.rail.transverse_radius = radius;
  const auto hertz = halfspace::hertz_of_scene(half);
  EXPECT_NEAR(light.points.front().max_pressure, hertz.max_pressure, 0.03 * hertz.max_pressure);
  EXPECT_NEAR(light.points.front().contact_width, 2.0 * (d + hertz.semi_axis_y), 0.05 * 2.0 * d);
  EXPECT_NEAR(light.points.front().patch_y_middle.value(), 0.0, 0.02);
  const auto heavy = half_space_models().run("halfspace", two_crests(200e3, d, radius), {});
  EXPECT_EQ(regions(heavy), 1);
  EXPECT_NEAR(heavy.points.front().normal_force, 200e3, 1.0);
}

TEST(ProfilePatches, PatchAtTheEndOfAProfileIsRefused) {
  const auto hertz = halfspace::hertz_of_scene(plain(50e3));
  PatchCase input = plain(50e3);
  input.patch = circles(405.0, contact::infinity, 500.0, 0.95 * hertz.semi_axis_y);
  for (const char* model : {"linear", "vermeulen-johnson", "fastsim", "strip", "halfspace"})
    EXPECT_TRUE(
        says(refusal<contact::InputError>([&] { half_space_models().run(model, input, {}); }),
             "profile too short for the contact"))
        << model;
}

TEST(ProfilePatches, ModelsWithoutProfilesSaySo) {
  PatchCase input = plain(50e3);
  input.patch = circles(405.0, contact::infinity, 500.0);
  input.rolling.creepages = {{1e-3, 0.0, 0.0}};
  EXPECT_THROW(half_space_models().run("carter", input, {}), contact::InputError);
  EXPECT_NO_THROW(half_space_models().run("fastsim", input, {}));
  EXPECT_NO_THROW(half_space_models().run("strip", input, {}));
  EXPECT_NO_THROW(half_space_models().run("halfspace", input, {}));
}

TEST(ProfilePatches, HollowContactHasNoEllipseButAHalfSpaceSolution) {
  // Between two crests: curvature across is negative at the contact point.
  const PatchCase input = two_crests(6e3, 4.0, 60.0);
  EXPECT_THROW(half_space_models().run("hertz", input, {}), contact::InputError);
  EXPECT_NO_THROW(half_space_models().run("halfspace", input, {}));
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// The extent of a patch found before any grid is laid. References: Hertz for bodies that the radii
// describe too, and mirror images.
#include "halfspace/patch/patch_search.hpp"

#include "base/errors.hpp"
#include "base/pi.hpp"
#include "case/reading/case_reader.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "result/patch_size.hpp"
#include "track/motion/placed_scenes.hpp"

#include "support/patch_case.hpp"
#include "support/places.hpp"
#include "support/profile_patches.hpp"
#include "support/temporary_folder.hpp"
#include "support/thesis_cases.hpp"
#include "support/two_humps.hpp"
#include "support/worn_wheels.hpp"

using halfspace::ExpectedPatch;
using halfspace::PatchSearch;

namespace {

/// Accuracy of the coarse search stated in the header.
constexpr double of_extents = 0.01;
constexpr double of_area = 0.02;
constexpr double of_pressure = 0.005;

PatchCase with_circles(char name, double reach = 30.0) {
  PatchCase input = thesis_case(name);
  input.patch = rollfem::testing::circles(input.wheel.rolling_radius, contact::infinity,
                                          input.rail.transverse_radius, reach);
  return input;
}

void expect_like(const ExpectedPatch& found, const ExpectedPatch& exact) {
  EXPECT_NEAR(found.length, exact.length, of_extents * exact.length);
  EXPECT_NEAR(found.width, exact.width, of_extents * exact.width);
  EXPECT_NEAR(found.max_pressure, exact.max_pressure, of_pressure * exact.max_pressure);
  EXPECT_NEAR(found.approach, exact.approach, of_pressure * exact.approach);
  EXPECT_NEAR(found.normal_force, exact.normal_force, 2.0 * of_pressure * exact.normal_force);
  EXPECT_NEAR(found.area, exact.area, of_area * exact.area);
  // Exact for an ellipse: smoother than the extents, for the border counts little.
  EXPECT_NEAR(found.carrying_length, exact.length, of_pressure * exact.length);
  EXPECT_NEAR(found.carrying_width, exact.width, of_pressure * exact.width);
}

}  // namespace

TEST(ExpectedPatch, OfRadiiIsHertzs) {
  const PatchCase input = thesis_case('a');
  const auto hertz = halfspace::hertz_of_scene(input);
  const ExpectedPatch patch = PatchSearch(input).patch();
  EXPECT_DOUBLE_EQ(patch.x_upper, hertz.semi_axis_x);
  EXPECT_DOUBLE_EQ(patch.y_lower, -hertz.semi_axis_y);
  EXPECT_DOUBLE_EQ(patch.max_pressure, hertz.max_pressure);
  EXPECT_DOUBLE_EQ(patch.normal_force, 50e3);
}

TEST(ExpectedPatch, OfCirclesIsThatOfTheirRadii) {
  for (const char name : {'a', 'b', 'c'}) {
    SCOPED_TRACE(name);
    expect_like(PatchSearch(with_circles(name)).patch(), PatchSearch(thesis_case(name)).patch());
  }
}

TEST(ExpectedPatch, TakesAnApproach) {
  PatchCase circles = with_circles('b');
  PatchCase radii = thesis_case('b');
  circles.load = radii.load = {};
  circles.load.approach = radii.load.approach = 0.05;
  expect_like(PatchSearch(circles).patch(), PatchSearch(radii).patch());
}

TEST(ExpectedPatch, HoldsOverManyOrdersOfTheLoad) {
  for (const double force : {1.0, 1e3, 1e6}) {
    SCOPED_TRACE(force);
    PatchCase circles = with_circles('c', 60.0);
    PatchCase radii = thesis_case('c');
    circles.load.normal_force = radii.load.normal_force = force;
    // At 1 MN the patch is 35 mm long and 14 mm wide: circle and parabola differ by 2e-3.
    expect_like(PatchSearch(circles).patch(), PatchSearch(radii).patch());
  }
}

TEST(ExpectedPatch, TakesTheLargestOfTheLoads) {
  PatchCase input = with_circles('b');
  const ExpectedPatch single = PatchSearch(input).patch();
  input.load.normal_force = 30e3;
  input.rolling.creepages.resize(3);
  input.normal_forces = {40e3, 50e3, 20e3};
  EXPECT_DOUBLE_EQ(PatchSearch(input).patch().width, single.width);
}

TEST(ExpectedPatch, IsOffTheContactPointWhereProfilesAreLopsided) {
  // S1002 on UIC60: stiffer on the side of R80, so that the patch lies on the other.
  PatchCase input = thesis_case('b');
  input.load.normal_force = 100e3;
  input.wheel.rolling_radius = 450.0;
  input.patch = s1002_on_uic60(-3.95, 8.58);
  const ExpectedPatch patch = PatchSearch(input).patch();
  EXPECT_LT(patch.y_middle(), -1.0);
  EXPECT_NEAR(patch.x_middle(), 0.0, 1e-9);
  EXPECT_GT(patch.y_centre, patch.y_middle());
}

TEST(ExpectedPatch, IsSearchedOnceForTheSameContact) {
  const contact::Scene scene = with_circles('b');
  contact::Scene other_grid = scene, other_load = scene;
  other_grid.contact_grid.elements_across = 7;
  other_load.points.front().load = {1.01 * *scene.points.front().load.force, {}};
  const PatchSearch search(scene), again(other_grid), heavier(other_load);
  EXPECT_EQ(&search.patch(), &again.patch());
  EXPECT_GT(heavier.patch().area, search.patch().area);
  const contact::Scene other_bodies = with_circles('a');
  const PatchSearch on_others(other_bodies);
  EXPECT_NE(on_others.patch().width, search.patch().width);
}

TEST(ExpectedPatch, RefusesAProfileThatEndsWithinThePatch) {
  // Hertz's patch of case b is 6.1 mm wide to each side.
  const double half = halfspace::hertz_of_scene(thesis_case('b')).semi_axis_y;
  EXPECT_NO_THROW(PatchSearch(with_circles('b', 1.1 * half)).patch());
  EXPECT_TRUE(says(
      refusal<contact::InputError>([&] { PatchSearch(with_circles('b', 0.9 * half)).patch(); }),
      "profile too short for the contact"));
}

TEST(ExpectedPatch, RefusesAnApproachThatDoesNotTouch) {
  PatchCase input = with_circles('b');
  input.load = {};
  input.load.approach = -0.01;
  EXPECT_THROW(PatchSearch(input).patch(), contact::SolveError);
}

TEST(ExpectedPatch, SaysWhichRowsOfSeveralPatchesAreLoaded) {
  // Two equal humps, 30 mm apart, under a cylinder: each carries half, and is as wide as Hertz has
  // it under half the load.
  const contact::Scene input = two_humps(0.0, 50e3);
  const ExpectedPatch patch = PatchSearch(input).patch();
  ASSERT_EQ(patch.loaded.size(), 2U);
  const auto half = halfspace::hertz_from_force(0.5 / wheel_over_humps, 0.5 / hump_radius,
                                                contact::combine({}, {}).contact_modulus, 25e3);
  EXPECT_NEAR(patch.covered_width(), 4.0 * half.semi_axis_y, 0.03 * 4.0 * half.semi_axis_y);
  EXPECT_NEAR(patch.loaded[0][0], -15.0 - half.semi_axis_y, 0.05 * half.semi_axis_y);
  EXPECT_NEAR(patch.loaded[1][0], 15.0 - half.semi_axis_y, 0.08 * half.semi_axis_y);
  EXPECT_NEAR(patch.max_pressure, half.max_pressure, 0.01 * half.max_pressure);
  EXPECT_NEAR(patch.carrying_width, 4.0 * half.semi_axis_y, 0.005 * 4.0 * half.semi_axis_y);
}

TEST(ExpectedPatch, ABoxForGivenElementsIsThatOfThePatch) {
  for (const char name : {'a', 'c', 'f'}) {
    const contact::Scene scene = with_circles(name);
    const PatchSearch coarse(scene, halfspace::SearchDetail::box), fine(scene);
    const ExpectedPatch &box = coarse.patch(), &patch = fine.patch();
    EXPECT_NE(&box, &patch) << name;
    EXPECT_NEAR(box.x_lower, patch.x_lower, of_extents * patch.length) << name;
    EXPECT_NEAR(box.x_upper, patch.x_upper, of_extents * patch.length) << name;
    EXPECT_NEAR(box.y_lower, patch.y_lower, of_extents * patch.width) << name;
    EXPECT_NEAR(box.y_upper, patch.y_upper, of_extents * patch.width) << name;
    EXPECT_NEAR(box.carrying_length, patch.carrying_length, of_extents * patch.length) << name;
    EXPECT_NEAR(box.carrying_width, patch.carrying_width, of_extents * patch.width) << name;
  }
}

TEST(ExpectedPatch, WhatCarriesTheLoadChangesSteadily) {
  // A second patch comes, and the search goes through boxes that jump: elements are counted in
  // these lengths, and every jump of them would be one of the forces.
  double length = 0.0, width = 0.0;
  bool one = false, two = false;
  for (int k = 0; k <= 20; ++k) {
    const contact::Case input = hollow_tread(-1.05 + 0.01 * k);
    const ExpectedPatch patch = PatchSearch(track::make_scenes(input).at(0).scene).patch();
    if (k > 0) {
      EXPECT_NEAR(patch.carrying_length, length, 0.01 * length) << k;
      EXPECT_NEAR(patch.carrying_width, width, 0.02 * width) << k;
    }
    length = patch.carrying_length;
    width = patch.carrying_width;
    (patch.loaded.size() > 1 ? two : one) = true;
  }
  EXPECT_TRUE(one && two);
}

/// S1002 over a concave rail of arcs that ends here.
contact::Case in_a_trough(const std::string& ends) {
  return contact::parse_case(
      "[load]\nvertical_force = 80e3\n[friction]\ncoefficient = 0.3\n[wheel]\n"
      "rolling_radius = 460.0\nprofile = \"S1002\"\n[rail]\nprofile = \"arcs\"\n"
      "[rail_profile]\nradii = [-20.0]\n" +
          ends + "[placement]\nlateral_position = 0.0\n",
      "case");
}

TEST(ExpectedPatch, OnTheEdgeOfABodyIsRefused) {
  const contact::Case input = in_a_trough("ends = [-15.0, 15.0]\nfree_ends = true\n");
  const contact::Scene scene = track::make_scenes(input).at(0).scene;
  EXPECT_TRUE(says(refusal<contact::SolveError>([&] { PatchSearch(scene).patch(); }),
                   "do not face each other", "do: check the profiles"));
}

TEST(ExpectedPatch, RailsThatAreTooSteepAtTheTopEndThere) {
  // Up to 85 degrees, where the arc is at y = 20 sin(atan(12)).
  EXPECT_TRUE(says(refusal<contact::InputError>(
                       [&] { track::make_scenes(in_a_trough("ends = [-5.0, 20.0]\n")); }),
                   "field-side end of the rail profile, 19.93 mm"));
}

TEST(ExpectedPatch, CoarseElementsMayReachWhereThereIsNoSurface) {
  // Beside the edge of a head, on a curved surface; the pressure is that of fine elements.
  contact::Case input = contact::parse_case(
      "[load]\nvertical_force = 80e3\n[friction]\ncoefficient = 0.3\n[wheel]\n"
      "rolling_radius = 460.0\nprofile = \"S1002\"\n[rail]\n"
      "profile = \"profiles/crossing.sections\"\n[placement]\nside = \"right\"\n"
      "lateral_position = 34.0919\ntrack_position = 102.4\n",
      std::string(ROLLFEM_SOURCE_DIR) + "/cases/case");
  const auto pressure = [&](int across) {
    input.contact_grid.elements_across = across;
    const contact::Scene scene = track::make_scenes(input).at(0).scene;
    return halfspace::run_halfspace(scene, {}).points.at(0).max_pressure;
  };
  EXPECT_NEAR(pressure(6), pressure(16), 0.03 * pressure(16));
}

TEST(ExpectedPatch, BodiesAreLaidOutAroundNearMissesToo) {
  // Two humps 12 mm apart. One carries the load alone if the other is lower by more than Hertz's
  // approach less what a point load displaces at that distance.
  constexpr double force = 20e3, half_distance = 6.0;
  const double modulus = contact::combine({}, {}).contact_modulus;
  const auto hertz =
      halfspace::hertz_from_force(0.5 / wheel_over_humps, 0.5 / hump_radius, modulus, force);
  const double displaced = force / (contact::pi * modulus * 2.0 * half_distance);
  const auto search = [&](double lower) {
    const contact::Scene scene = two_humps(lower, force, half_distance);
    const PatchSearch found(scene);
    EXPECT_EQ(found.patch().loaded.size(), 1U) << lower;
    EXPECT_NEAR(found.box().smaller(), hertz.semi_axis_y, 0.02 * hertz.semi_axis_y) << lower;
    return found.box();
  };
  // Half-spaces miss by a tenth of what is displaced, or by all of it and more.
  const halfspace::PatchBox near = search(hertz.approach - 0.9 * displaced);
  EXPECT_GT(near.middle + near.half_width, half_distance);
  const halfspace::PatchBox far = search(hertz.approach + 0.1 * displaced);
  EXPECT_NEAR(far.half_width, hertz.semi_axis_y, 0.02 * hertz.semi_axis_y);
  EXPECT_NEAR(far.middle, -half_distance, 0.1);
}

TEST(ExpectedPatch, BodiesAreLaidOutAroundAPatchOfTheCurvedSurfaceAlone) {
  // S1002 at the root of its flange: a second patch carries 1 % of the load on the curved surface
  // and nothing in the plane of the search.
  const contact::Case input = contact::parse_case(
      "[load]\nvertical_force = 103e3\n[wheel]\nrolling_radius = 460.0\nprofile = \"S1002\"\n"
      "[rail]\nprofile = \"60E1\"\n[track]\ninclination = \"1:40\"\n[wheelset]\nside = \"right\"\n"
      "lateral_shift = 5.55\n[friction]\ncoefficient = 0.13\n[contact_grid]\n"
      "elements_across = 12\n",
      "case");
  contact::Scene scene = track::make_scenes(input).at(0).scene;
  scene.follows_surface = 1.0;
  const auto result = halfspace::run_halfspace(scene, {});
  const auto parts = contact::patch_parts(result.grid, result.points.front().fields);
  ASSERT_EQ(parts.size(), 2U);
  const contact::ChartedGeometry arc = halfspace::halfspace_geometry(scene);
  const PatchSearch search(scene);
  EXPECT_EQ(search.patch().loaded.size(), 1U);
  const halfspace::PatchBox box = search.box();
  for (const double end : {-0.5, 0.5})
    EXPECT_NEAR(arc.lateral_place(parts[1].y + end * parts[1].width), box.middle, box.half_width);
}

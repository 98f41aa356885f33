// SPDX-License-Identifier: LGPL-2.1-or-later
// Several patches of one wheel share its load by one vertical sinking. References: symmetry and the
// closed form of Hertz's law N = C approach^(3/2).
#include "halfspace/patch/load_sharing.hpp"

#include "base/errors.hpp"
#include "halfspace/closed_forms/hertz.hpp"

#include "support/patch_case.hpp"
#include "support/profile_patches.hpp"
#include "support/thesis_cases.hpp"

namespace {

/// Forces of the coarse solutions: 0.3 % against Hertz.
constexpr double coarse = 3e-3;

PatchCase scene(double rail_radius, double separation, double angle) {
  PatchCase input = thesis_case('b');
  input.load = {};
  input.rail.transverse_radius = rail_radius;
  input.patch = circles(405.0, contact::infinity, rail_radius);
  input.place.emplace();
  input.place->separation = separation;
  input.place->contact_angle = angle;
  // Too far from each other to be felt.
  static int count = 0;
  input.place->way_across = 1e15 * count++;
  return input;
}

/// N at an approach by Hertz.
double hertz_force(double rail_radius, double approach) {
  PatchCase input = thesis_case('b');
  input.rail.transverse_radius = rail_radius;
  input.load = {};
  input.load.approach = approach;
  return halfspace::hertz_of_scene(input).normal_force;
}

}  // namespace

TEST(PressureShare, OnePatchCarriesAll) {
  const auto shared = halfspace::share_load({scene(300.0, 0.0, 0.3)}, 50e3);
  ASSERT_EQ(shared.shares.size(), 1u);
  EXPECT_NEAR(shared.shares[0].normal_force * std::cos(0.3), 50e3, 1.0);
}

TEST(PressureShare, TwoEqualPatchesShareEqually) {
  const auto shared = halfspace::share_load({scene(300.0, 0.0, 0.0), scene(300.0, 0.0, 0.0)}, 60e3);
  EXPECT_NEAR(shared.shares[0].normal_force, 30e3, 1.0);
  EXPECT_DOUBLE_EQ(shared.shares[0].normal_force, shared.shares[1].normal_force);
}

TEST(PressureShare, NearMissIsLoadedOnlyBeyondItsSeparation) {
  // Sinking of the first patch alone at 50 kN, by Hertz: 0.0666 mm.
  PatchCase alone = thesis_case('b');
  alone.rail.transverse_radius = 300.0;
  const double approach = halfspace::hertz_of_scene(alone).approach;
  const auto beyond =
      halfspace::share_load({scene(300.0, 0.0, 0.0), scene(300.0, 1.02 * approach, 0.0)}, 50e3);
  EXPECT_EQ(beyond.shares[1].normal_force, 0.0);
  EXPECT_NEAR(beyond.shares[0].normal_force, 50e3, 1.0);
  EXPECT_NEAR(beyond.sinking, approach, coarse * approach);
  const auto within =
      halfspace::share_load({scene(300.0, 0.0, 0.0), scene(300.0, 0.9 * approach, 0.0)}, 50e3);
  EXPECT_GT(within.shares[1].normal_force, 100.0);
  EXPECT_NEAR(within.shares[0].normal_force + within.shares[1].normal_force, 50e3, 1.0);
}

TEST(PressureShare, UnequalTiltedPatchesFollowHertzsLaw) {
  const double separation = 0.03, angle = 0.5;
  const auto shared =
      halfspace::share_load({scene(300.0, 0.0, 0.02), scene(80.0, separation, angle)}, 80e3);
  const double w = shared.sinking;
  EXPECT_NEAR(shared.shares[0].normal_force / hertz_force(300.0, w * std::cos(0.02)), 1.0, coarse);
  EXPECT_NEAR(shared.shares[1].normal_force / hertz_force(80.0, w * std::cos(angle) - separation),
              1.0, coarse);
  EXPECT_NEAR(shared.shares[0].normal_force * std::cos(0.02) +
                  shared.shares[1].normal_force * std::cos(angle),
              80e3, 3.0);
}

TEST(PressureShare, RefusesScenesWithoutPlaceOrLoad) {
  EXPECT_THROW(halfspace::share_load({thesis_case('b')}, 50e3), contact::InputError);
  EXPECT_THROW(halfspace::share_load({}, 50e3), contact::InputError);
  EXPECT_THROW(halfspace::share_load({scene(300.0, 0.0, 0.0)}, 0.0), contact::InputError);
}

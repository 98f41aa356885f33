// SPDX-License-Identifier: LGPL-2.1-or-later
// The strip model: Hertz as its exact limit, profiles beyond the parabola.
#include "theories/strip.hpp"

#include "base/errors.hpp"
#include "halfspace/closed_forms/hertz.hpp"

#include "support/test.hpp"

namespace rollfem::theories {

using namespace halfspace;
namespace {

constexpr double modulus = 115384.6;
const StripLaw law{modulus};

StripProfile profile_of(double (*distance)(double), double half_width, int strips) {
  StripProfile profile;
  profile.width = 2.0 * half_width / strips;
  profile.y_first = -half_width + 0.5 * profile.width;
  for (int j = 0; j < strips; ++j) {
    profile.distance.push_back(distance(profile.y(j)));
    profile.curvature.push_back(1.0 / 810.0);
  }
  return profile;
}

double crowned(double y) {
  return y * y / 4000.0;
}
double flat_in_the_middle(double y) {
  return 1e-7 * y * y * y * y;
}
double two_humps(double y) {
  return std::pow((y * y - 400.0) / 800.0, 2);
}

TEST(StripNormal, OfAParabolaIsHertz) {
  const HertzContact hertz = hertz_from_force(1.0 / 810, 1.0 / 4000, modulus, 50e3);
  double before = 0.0;
  for (const int strips : {50, 100, 200}) {
    const StripProfile profile = profile_of(crowned, 15.0, strips);
    const StripNormalSolution s = strips_for_force(profile, law, 50e3);
    EXPECT_NEAR(s.normal_force, 50e3, 1e-3);
    const StripSection middle = strip_section(profile, s, 0.0);
    const double error = std::abs(middle.max_pressure / hertz.max_pressure - 1.0);
    EXPECT_LT(error, 6.0 / (strips * strips));
    EXPECT_NEAR(middle.half_length / hertz.semi_axis_x, 1.0, 6.0 / (strips * strips));
    EXPECT_NEAR(s.approach / hertz.approach, 1.0, 6.0 / (strips * strips));
    EXPECT_NEAR(s.patches[0].y_upper / hertz.semi_axis_y, 1.0, 6.0 / (strips * strips));
    before = error;
  }
  EXPECT_LT(before, 2e-4);
}

TEST(StripNormal, ApproachAndForceAgree) {
  const StripProfile profile = profile_of(flat_in_the_middle, 40.0, 400);
  const StripNormalSolution by_force = strips_for_force(profile, law, 80e3);
  const StripNormalSolution by_approach = strips_for_approach(profile, law, by_force.approach);
  EXPECT_NEAR(by_approach.normal_force / by_force.normal_force, 1.0, 1e-6);
}

TEST(StripNormal, FindsTwoPatches) {
  const StripProfile profile = profile_of(two_humps, 40.0, 400);
  const StripNormalSolution s = strips_for_force(profile, law, 40e3);
  ASSERT_EQ(s.patches.size(), 2u);
  EXPECT_NEAR(s.patches[0].y_lower, -s.patches[1].y_upper, 1e-9);
  EXPECT_NEAR(s.patches[0].max_pressure, s.patches[1].max_pressure, 1e-9);
  EXPECT_EQ(strip_section(profile, s, 0.0).half_length, 0.0);
  // Near each minimum z = (y -+ 20)^2/400: each patch is nearly Hertz's under half of the force.
  const HertzContact hertz = hertz_from_force(1.0 / 810, 1.0 / 400, modulus, 20e3);
  EXPECT_NEAR(s.patches[0].max_pressure / hertz.max_pressure, 1.0, 0.02);
}

/// Hertz's ellipse penetrates by b^2 B of its approach: with that share the virtual penetration
/// gives its extents, force and pressure back, though from an integral of the pressure.
TEST(StripNormal, VirtualPenetrationOfItsOwnShareIsHertz) {
  for (const double B : {1.0 / 4000, 1.0 / 1000, 1.0 / 200}) {
    const HertzContact hertz = hertz_from_force(1.0 / 810, B, modulus, 50e3);
    StripProfile profile;
    profile.width = 2.5 * hertz.semi_axis_y / 200;
    profile.y_first = -99.5 * profile.width;
    for (int j = 0; j < 200; ++j) {
      profile.distance.push_back(B * profile.y(j) * profile.y(j));
      profile.curvature.push_back(1.0 / 810.0);
    }
    const double share = B * hertz.semi_axis_y * hertz.semi_axis_y / hertz.approach;
    const StripNormalSolution s = strips_for_force(profile, {modulus, share}, 50e3);
    EXPECT_NEAR(s.patches[0].max_pressure / hertz.max_pressure, 1.0, 3e-3) << B;
    EXPECT_NEAR(s.patches[0].semi_axis_x / hertz.semi_axis_x, 1.0, 3e-3) << B;
    EXPECT_NEAR(s.patches[0].semi_axis_y / hertz.semi_axis_y, 1.0, 3e-3) << B;
    EXPECT_NEAR(s.approach / hertz.approach, 1.0, 3e-3) << B;
  }
}

double flank_on_one_side(double y) {
  return y > 0.0 ? 3.5e-3 * y * y : std::min(3.5e-3 * y * y, 0.03 + 5.5e-3 * (-y - 2.93));
}

/// A flank that the profiles nearly share touches first in the virtual penetration.
TEST(StripNormal, VirtualPenetrationReachesFurtherIntoAFlank) {
  const StripProfile profile = profile_of(flank_on_one_side, 20.0, 800);
  const StripNormalSolution plain = strips_for_force(profile, law, 100e3);
  const StripNormalSolution more = strips_for_force(profile, {modulus, 0.55}, 100e3);
  const StripNormalSolution most = strips_for_force(profile, {modulus, 0.84}, 100e3);
  EXPECT_LT(more.patches[0].y_lower, plain.patches[0].y_lower - 1.0);
  EXPECT_LT(most.patches[0].y_lower, more.patches[0].y_lower - 2.0);
  EXPECT_LT(most.patches[0].max_pressure, more.patches[0].max_pressure);
  EXPECT_LT(more.patches[0].max_pressure, plain.patches[0].max_pressure);
  for (const StripNormalSolution* s : {&plain, &more, &most}) {
    double force = 0.0;
    for (int j = 0; j < profile.size(); ++j)
      force += 0.5 * M_PI * s->max_pressure[j] * s->half_length[j] * profile.width;
    EXPECT_NEAR(force, 100e3, 1e-2);
  }
}

TEST(StripNormal, SaysThatTheProfilesAreTooNarrow) {
  const StripProfile profile = profile_of(crowned, 8.0, 80);
  EXPECT_THROW(strips_for_force(profile, law, 50e3), contact::SolveError);
}

}  // namespace
}  // namespace rollfem::theories

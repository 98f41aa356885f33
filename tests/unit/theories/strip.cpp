// SPDX-License-Identifier: LGPL-2.1-or-later
// The strip model: Hertz and Vermeulen-Johnson as its exact limits, profiles beyond the parabola.
#include "theories/strip.hpp"

#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"
#include "theories/closed_forms.hpp"

#include <fmt/format.h>

#include "support/contact_laws.hpp"
#include "support/thesis_cases.hpp"

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

/// Radii: an ellipse of Hertz's ratio as wide as the undeformed overlap, whose pressure gives the
/// approach at its middle; on patches up to six times as long as wide too.
TEST(StripNormal, VirtualPenetrationOfRadiiNeedsNoProfiles) {
  for (const double radius : {300.0, 80.0, 30.0, 13.0})
    for (const char* given : {"approach = 0.0181818", "normal_force = 5e3"}) {
      SCOPED_TRACE(fmt::format("{} mm, {}", radius, given));
      const contact::Scene scene = contact::parse_case(
          fmt::format("[load]\n{}\n[friction]\ncoefficient = 0.3\n[wheel]\nrolling_radius = "
                      "460.0\ntransverse_radius = inf\n[rail]\ntransverse_radius = {:e}\n"
                      "[strip]\nvirtual_penetration = 0.55\n",
                      given, radius),
          "a.toml");
      const contact::ModelResult result = run_strip(scene, {});
      const contact::PointResult& point = result.points[0];
      const HertzContact unit =
          hertz_from_force(0.5 / 460.0, 0.5 / radius, scene.material.contact_modulus, 1.0);
      const double b = std::sqrt(0.55 * point.approach * 2.0 * radius);
      const double scale = b / unit.semi_axis_y;
      const double pressure = unit.max_pressure * point.approach / (unit.approach * scale);
      EXPECT_NEAR(point.semi_axis_y / b, 1.0, 2e-3);
      EXPECT_NEAR(point.semi_axis_x / (scale * unit.semi_axis_x), 1.0, 1e-2);
      EXPECT_NEAR(point.max_pressure / pressure, 1.0, 1e-2);
      EXPECT_NEAR(point.normal_force /
                      (2.0 / 3.0 * M_PI * point.semi_axis_x * point.semi_axis_y * pressure),
                  1.0, 1e-2);
      EXPECT_GT(result.grid.nx * result.grid.dx, point.contact_length);
      EXPECT_GT(result.grid.ny * result.grid.dy, point.contact_width);
    }
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

TEST(StripModel, OnAnEllipseIsVermeulenJohnson) {
  // A strip with a parabola of force mu P(y) slips over the same share of every strip, and the sum
  // is 1 - (1 - tau/3)^3: Vermeulen and Johnson's law, for any creepage without spin.
  contact::Case input =
      thesis_case('a', 40, {{1e-4, 0, 0}, {1e-3, 0, 0}, {0, 3e-3, 0}, {0.02, 0, 0}});
  const contact::ModelResult strip = run_strip(input, {});
  const contact::ModelResult closed = run_vermeulen_johnson(input, {});
  for (std::size_t k = 0; k < strip.points.size(); ++k) {
    EXPECT_NEAR(strip.points[k].longitudinal_force, closed.points[k].longitudinal_force,
                3e-4 * 27500);
    EXPECT_NEAR(strip.points[k].lateral_force, closed.points[k].lateral_force, 3e-4 * 27500);
  }
}

TEST(StripModel, LargestTractionIsThreePiOverEightOfMuP0) {
  contact::Case input = thesis_case('a', 40, {{0.02, 0, 0}});
  const contact::PointResult point = run_strip(input, {}).points[0];
  const double expected = 3.0 * std::acos(-1.0) / 8.0 * 0.55 * point.max_pressure;
  EXPECT_NEAR(point.max_traction / expected, 1.0, 1e-3);
}

TEST(StripModel, ForcesAreThoseOfItsFields) {
  contact::Case input = thesis_case('c', 80, {{0, 0, 0}, {1e-3, 5e-4, 1e-4}});
  const contact::ModelResult result = run_strip(input, {});
  expect_forces_of_fields(result, 2e-3 * 27500);
  const double area = result.grid.element_area();
  for (const contact::PointResult& point : result.points) {
    EXPECT_NEAR(area * point.fields.traction.n.sum(), 50e3, 1e-3 * 50e3);
    EXPECT_NEAR(point.contact_area / (std::acos(-1.0) * point.semi_axis_x * point.semi_axis_y), 1.0,
                1e-3);
  }
}

TEST(StripModel, RunsForAGivenApproach) {
  contact::Case input = thesis_case('a');
  input.load.normal_force.reset();
  input.load.approach = 0.0473108;
  EXPECT_NEAR(run_strip(input, {}).points[0].normal_force, 50e3, 50.0);
}

}  // namespace
}  // namespace rollfem::theories

// SPDX-License-Identifier: LGPL-2.1-or-later
// Models of the half-space family on true profiles. References: the same bodies by radii, Hertz,
// and CONTACT on S1002 over UIC60 (reference/wheelrail_left_*.csv).
#include "support/profile_patches.hpp"

#include "halfspace/closed_forms/hertz.hpp"

#include "support/half_space_models.hpp"
#include "support/patch_case.hpp"
#include "support/thesis_cases.hpp"

namespace {

ModelResult run(const std::string& model, const PatchCase& input) {
  return half_space_models().run(model, input, {});
}

PatchCase with_circles(char name) {
  PatchCase input = thesis_case(name);
  input.patch = rollfem::testing::circles(input.wheel.rolling_radius, contact::infinity,
                                          input.rail.transverse_radius, 40.0);
  return input;
}

/// Left wheel, R0 = 450 mm, 2 mm to the right, no roll, UIC60 inclined 1:40, 100 kN, mu = 0.55.
/// Rail and wheel coordinates of the rigid contact differ by 12.53 mm in CONTACT's output: it
/// gives the place on the rail, -4.91 mm (towards the gauge) at -755.62 mm of the track, where the
/// wheel, whose running circle is at -750 + 2 mm, has 7.62 mm. Slopes agree at -3.95 and 8.58 mm,
/// 0.96 mm from the reference point of CONTACT.
constexpr double rail_place = -3.95, wheel_place = 8.58, from_reference = 0.96;

PatchCase s1002_left() {
  PatchCase input = thesis_case('b');
  input.load.normal_force = 100e3;
  input.wheel.rolling_radius = 450.0;
  input.patch = s1002_on_uic60(rail_place, wheel_place);
  input.contact_grid.cell_size = {0.2, 0.2};
  // CONTACT lays the patch in a plane and knows creepages and spin alone.
  input.rolling.extra_slip = contact::ExtraSlip::none;
  return input;
}

struct CreepPoint {
  double longitudinal, spin;  ///< at CONTACT's reference point
  double longitudinal_force;  ///< N
};
/// wheelrail_left_creep.csv: cells of 0.4 mm, upwind differences of first order.
constexpr CreepPoint contact_curve[] = {{-4.401e-3, -3.634e-5, 46790.0},
                                        {-2.395e-3, -3.638e-5, 31670.0},
                                        {-1.394e-3, -3.639e-5, 20340.0},
                                        {1.605e-3, -3.645e-5, -22920.0},
                                        {3.599e-3, -3.649e-5, -41700.0}};

void add_creep_curve(PatchCase& input) {
  input.rolling.creepages.clear();
  for (const CreepPoint& point : contact_curve)
    input.rolling.creepages.push_back(
        {point.longitudinal - point.spin * from_reference, 0.0, point.spin});
}

}  // namespace

TEST(ProfilePatches, CirclesRollLikeTheirRadii) {
  for (const char name : {'a', 'c'}) {
    SCOPED_TRACE(name);
    PatchCase radii = thesis_case(name);
    PatchCase circles = with_circles(name);
    for (PatchCase* input : {&radii, &circles}) {
      const auto hertz = halfspace::hertz_of_scene(thesis_case(name));
      input->rolling.creepages = {{1e-3, 5e-4, 1e-4}};
      input->contact_grid.cell_size = {hertz.semi_axis_x / 16.0, hertz.semi_axis_y / 16.0};
      input->contact_grid.extent = {2.4 * hertz.semi_axis_x, 2.4 * hertz.semi_axis_y};
    }
    const PointResult a = run("halfspace", radii).points.front();
    const PointResult b = run("halfspace", circles).points.front();
    // A circle differs from its parabola by (y / 2R)^2: below 2e-4 at the edge of case c.
    EXPECT_NEAR(b.max_pressure, a.max_pressure, 3e-4 * a.max_pressure);
    EXPECT_NEAR(b.contact_width, a.contact_width, 1e-3 * a.contact_width);
    EXPECT_NEAR(b.approach, a.approach, 3e-4 * a.approach);
    const double bound = 0.55 * 50e3;
    EXPECT_NEAR(b.longitudinal_force, a.longitudinal_force, 5e-4 * bound);
    EXPECT_NEAR(b.lateral_force, a.lateral_force, 5e-4 * bound);
  }
}

TEST(ProfilePatches, TheoriesOfAnEllipseFindItAgain) {
  for (const char* model : {"hertz", "linear", "fastsim", "strip"}) {
    SCOPED_TRACE(model);
    PatchCase radii = thesis_case('a');
    PatchCase circles = with_circles('a');
    radii.rolling.creepages = circles.rolling.creepages = {{1e-3, 5e-4, 1e-4}};
    const PointResult a = run(model, radii).points.front();
    const PointResult b = run(model, circles).points.front();
    // The ellipse is taken from a half-space solution at 65 elements across, whose area is 0.13 %
    // too large.
    EXPECT_NEAR(b.max_pressure, a.max_pressure, 2e-3 * a.max_pressure);  // as the area
    EXPECT_NEAR(b.contact_length, a.contact_length, 1e-3 * a.contact_length);
    EXPECT_NEAR(b.longitudinal_force, a.longitudinal_force, 1e-3 * 0.55 * 50e3);
    EXPECT_NEAR(b.lateral_force, a.lateral_force, 1e-3 * 0.55 * 50e3);
  }
}

TEST(ProfilePatches, YawTurnsTheEllipseAndKeepsItsPressure) {
  // A torus on a plane makes Hertz's contact of its two radii, whichever way it is turned.
  PatchCase upright = thesis_case('b');
  upright.wheel.transverse_radius = 150.0;
  upright.rail.transverse_radius = contact::infinity;
  const auto hertz = halfspace::hertz_of_scene(upright);
  const auto plain = rollfem::testing::circles(405.0, 150.0, contact::infinity, 30.0);
  for (const double yaw : {0.1, -0.5}) {
    SCOPED_TRACE(yaw);
    PatchCase turned = upright;
    turned.patch = std::make_shared<contact::PatchGeometry>(
        plain->rail(), plain->wheel_radius(),
        contact::Axle{{0.0, 0.0, 405.0}, {std::sin(yaw), std::cos(yaw), 0.0}}, -25.0, 25.0);
    turned.rolling.problem = contact::Problem::frictionless;
    const PointResult point = run("halfspace", turned).points.front();
    EXPECT_NEAR(point.max_pressure, hertz.max_pressure, 2e-3 * hertz.max_pressure);
    EXPECT_NEAR(point.approach, hertz.approach, 1e-3 * hertz.approach);
    // Extents of a turned ellipse: sqrt(a^2 c^2 + b^2 s^2).
    const double c = std::cos(yaw), s = std::sin(yaw);
    const double length = 2.0 * std::hypot(hertz.semi_axis_x * c, hertz.semi_axis_y * s);
    const double width = 2.0 * std::hypot(hertz.semi_axis_x * s, hertz.semi_axis_y * c);
    EXPECT_NEAR(point.contact_length, length, 5e-3 * length);
    EXPECT_NEAR(point.contact_width, width, 5e-3 * width);
  }
}

TEST(ProfilePatches, S1002OnUic60HasContactsCreepCurve) {
  PatchCase input = s1002_left();
  add_creep_curve(input);
  const double bound = 0.55 * 100e3;
  PatchCase like_contact = input;
  like_contact.contact_grid.cell_size = {0.4, 0.4};
  like_contact.rolling.upwind_order = contact::UpwindOrder::first;
  const auto same = run("halfspace", like_contact).points;
  const auto better = run("halfspace", input).points;
  for (std::size_t k = 0; k < same.size(); ++k) {
    SCOPED_TRACE(contact_curve[k].longitudinal);
    EXPECT_NEAR(same[k].longitudinal_force, contact_curve[k].longitudinal_force, 0.01 * bound);
    // Effect of CONTACT's first-order differences at 32 elements along: 1 to 2 % of the force
    // (measured on benchmark 9, docs/theory.md).
    EXPECT_NEAR(better[k].longitudinal_force, contact_curve[k].longitudinal_force,
                0.005 * bound + 0.02 * std::abs(contact_curve[k].longitudinal_force));
  }
}

TEST(ProfilePatches, FourThousandElementsTakeFewSteps) {
  PatchCase input = s1002_left();
  input.rolling.creepages = {{1.4e-3, 0.0, 3.6e-5}};
  const ModelResult result = run("halfspace", input);
  EXPECT_GT(result.contact_elements, 3800);
  EXPECT_LE(result.points.at(0).iterations, 6);
}

TEST(ProfilePatches, StripModelIsNearTheHalfSpace) {
  PatchCase input = s1002_left();
  add_creep_curve(input);
  const auto exact = run("halfspace", input).points;
  const auto strips = run("strip", input).points;
  // The strip model shapes the patch by the overlap of rigid profiles, of one ellipse's depth and
  // volume: exact for an ellipse (the test above), first order in what the patch is off one. Width
  // and Hertz's differ by 10 % here, so that some per cent are to be expected.
  EXPECT_NEAR(strips[0].max_pressure, exact[0].max_pressure, 0.03 * exact[0].max_pressure);
  EXPECT_NEAR(strips[0].contact_length, exact[0].contact_length, 0.02 * exact[0].contact_length);
  EXPECT_NEAR(strips[0].contact_width, exact[0].contact_width, 0.07 * exact[0].contact_width);
  EXPECT_NEAR(strips[0].approach, exact[0].approach, 0.01 * exact[0].approach);
  for (std::size_t k = 0; k < exact.size(); ++k)
    EXPECT_NEAR(strips[k].longitudinal_force, exact[k].longitudinal_force, 0.03 * 0.55 * 100e3);
}

TEST(ProfilePatches, MirroredProfilesGiveMirroredForces) {
  // Mirrored at y = 0: y, lateral force, spin and moment change their signs.
  PatchCase input = s1002_left();
  input.contact_grid.cell_size.reset();
  input.contact_grid.elements_across = 24;
  input.rolling.creepages = {{1e-3, 4e-4, 1e-4}};
  const contact::PatchGeometry& left = *input.patch;
  const auto mirrored = [](const contact::HeightCurve& curve) {
    std::vector<contact::HeightKnot> knots(curve.knots().rbegin(), curve.knots().rend());
    for (contact::HeightKnot& knot : knots) knot = {-knot.y, knot.z, -knot.slope};
    return contact::HeightCurve(knots);
  };
  PatchCase other = input;
  contact::Axle axle = left.axle();
  axle.point[1] = -axle.point[1];
  axle.direction[2] = -axle.direction[2];
  other.patch = std::make_shared<contact::PatchGeometry>(
      mirrored(left.rail()), mirrored(left.wheel_radius()), axle, -40.0, 40.0);
  other.rolling.creepages = {{1e-3, -4e-4, -1e-4}};
  for (const char* model : {"linear", "fastsim", "strip", "halfspace"}) {
    SCOPED_TRACE(model);
    const PointResult a = run(model, input).points.front();
    const PointResult b = run(model, other).points.front();
    EXPECT_NEAR(b.max_pressure, a.max_pressure, 1e-4 * a.max_pressure);
    EXPECT_NEAR(b.longitudinal_force, a.longitudinal_force, 10.0);
    EXPECT_NEAR(b.lateral_force, -a.lateral_force, 10.0);
    EXPECT_NEAR(b.spin_moment, -a.spin_moment, 1e-3 * std::abs(a.spin_moment));
    EXPECT_NEAR(b.patch_y_middle.value(), -a.patch_y_middle.value(), 5e-3);
  }
}

TEST(ProfilePatches, EveryLoadPointHasItsNormalForce) {
  PatchCase input = s1002_left();
  input.contact_grid.cell_size.reset();
  input.contact_grid.elements_across = 20;
  input.rolling.creepages = {{1e-3, 0.0, 0.0}, {2e-3, 0.0, 0.0}};
  input.normal_forces = {90e3, 100e3};
  for (const char* model : {"linear", "vermeulen-johnson", "fastsim", "strip", "halfspace"}) {
    SCOPED_TRACE(model);
    const auto both = run(model, input).points;
    ASSERT_EQ(both.size(), 2u);
    EXPECT_NEAR(both[0].normal_force, 90e3, 1e-3 * 90e3);
    EXPECT_NEAR(both[1].normal_force, 100e3, 1e-3 * 100e3);
    EXPECT_LT(both[0].max_pressure, 0.99 * both[1].max_pressure);
  }
}

TEST(ProfilePatches, WorksOfFrictionAndCreepageAgree) {
  PatchCase input = s1002_left();
  input.rolling.creepages = {{2e-3, 1e-3, 1e-4}};
  const auto point = run("halfspace", input).points.front();
  EXPECT_GT(point.elastic_energy.value(), 0.0);
  EXPECT_NEAR(point.frictional_work.value(), point.creepage_work.value(),
              0.01 * point.creepage_work.value());
}

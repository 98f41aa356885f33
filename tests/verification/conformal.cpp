// SPDX-License-Identifier: LGPL-2.1-or-later
// Conformal contact on the curved half-space: CONTACT's deep groove, in which friction carries a
// part of the load, and its corner in a root, whose sum of pressure is not the force.
#include "base/errors.hpp"
#include "halfspace/model/halfspace_model.hpp"

#include "support/committed_cases.hpp"
#include "support/temporary_folder.hpp"

namespace {

contact::PointResult point_of(const contact::Case& input) {
  return halfspace::run_halfspace(input, {}).points.front();
}

/// The groove's ball under no longitudinal force.
contact::Case rolling_in_groove(double radius) {
  contact::Case input = committed_case("conformal_groove");
  input.rail.transverse_radius = -radius;
  input.rolling.problem = contact::Problem::steady;
  input.rolling.forces = {{0.0, {}}};
  return input;
}

}  // namespace

TEST(DeepGroove, RollsFreelyAsInContact) {
  // CONTACT, testbank/examples_conformal/groove_li (r2447), half-spaces, mu = 0.3, F_x = 0, on 64
  // by 23 elements: p0, approach and creepage. Spin about normals that lean makes lateral friction,
  // which carries 1.6 % of the load at 10.25 mm and 2.6 % at 10.10 mm.
  struct Groove {
    double radius, pressure, approach, creepage;
  };
  for (const auto& [radius, pressure, approach, creepage] :
       {Groove{10.25, 530.2, 0.022367, -2.3007e-4}, {10.10, 409.3, 0.019392, -4.4108e-4}}) {
    SCOPED_TRACE(radius);
    contact::Case input = rolling_in_groove(radius);
    const contact::PointResult point = point_of(input);
    EXPECT_NEAR(point.max_pressure, pressure, 2e-3 * pressure);
    EXPECT_NEAR(point.approach, approach, 1e-3 * approach);
    EXPECT_NEAR(point.creepage.longitudinal, creepage, 3e-3 * -creepage);
    EXPECT_NEAR(point.normal_force, 10e3, 1e-6 * 10e3);
    // Without friction 0.6 and 0.9 % more, which is no difference of half-spaces.
    input.rolling = committed_case("conformal_groove").rolling;
    EXPECT_GT(point_of(input).max_pressure, 1.004 * point.max_pressure);
  }
}

TEST(CornerInARoot, SumOfPressureIsNotTheForce) {
  // CONTACT's example `conformal`, case 2: 91.84 kN is the sum of its pressure, 89.25 kN its part
  // along the approach, 1012 MPa. Its distance grows as x^2 along the normal where here the wheel
  // closes along z: 0.8 % in force, 0.5 % in p0.
  const contact::ModelResult result =
      halfspace::run_halfspace(committed_case("conformal_corner"), {});
  const contact::PointResult& point = result.points.front();
  const double sum = point.fields.traction.n.sum() * result.grid.element_area();
  EXPECT_NEAR(sum, 91.84e3, 0.012 * 91.84e3);
  EXPECT_NEAR(point.normal_force, 89.25e3, 0.012 * 89.25e3);
  EXPECT_NEAR(point.normal_force / sum, 89.25 / 91.84, 2e-3);
  EXPECT_NEAR(point.max_pressure, 1012.0, 8e-3 * 1012.0);
}

TEST(DeepGroove, OfHalfAPatchOf44DegreesNeedsRounderBodies) {
  // The same of CONTACT in a groove of 10.02 mm: p0.
  contact::Case input = rolling_in_groove(10.02);
  input.wheel.round_to = input.rail.round_to = 0.85;
  const contact::PointResult point = point_of(input);
  EXPECT_NEAR(point.max_pressure, 296.8, 3e-3 * 296.8);
  EXPECT_NEAR(point.normal_force, 10e3, 1e-6 * 10e3);
}

TEST(DeepGroove, ThatFitsTooWellIsRefusedWithTheReason) {
  // Half the patch is 44 degrees in a groove of 10.02 mm, where circles go on as straight flanks.
  contact::Case input = committed_case("conformal_groove");
  input.rail.transverse_radius = -10.02;
  input.contact_grid.elements_across = 8;
  // Flanks touch along their whole length.
  EXPECT_TRUE(
      says(refusal<contact::SolveError>([&] { point_of(input); }), "straight flanks", "round_to"));
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// The curved contact surface: normals, undeformed distance of circles in closed form, rigid slip
// against velocities of rotating bodies, resultants.
#include "scene/contact_surface.hpp"

#include "case/reading/case_reader.hpp"
#include "result/result.hpp"
#include "scene/geometry.hpp"

#include "support/case_examples.hpp"

namespace {

constexpr double rolling_radius = 405.0;
const ContactSurface case_e{rolling_radius, -105.263, 100.0};
const ContactSurface case_f{rolling_radius, -51.282, 50.0};
const ContactSurface case_d{rolling_radius, 105.263, 2000.0};

/// Way from (y, z) along (-sin, cos) to the upper arc of the circle of signed radius about (0,
/// -radius).
double way_to_circle(double y, double z, double sine, double cosine, double radius) {
  const double along = -sine * y + cosine * (z + radius);
  const double square = y * y + (z + radius) * (z + radius) - radius * radius;
  // Roots of w^2 + 2 along w + square = 0; the near one.
  return -square / (along + std::copysign(std::sqrt(along * along - square), along));
}

TEST(ContactSurface, IsTheMeanOfBothProfilesWithTheSlopeOfItsHeight) {
  for (const ContactSurface& surface : {case_d, case_e, case_f})
    for (const double y : {-11.0, -2.0, 0.0, 7.0}) {
      const double step = 1e-5;
      EXPECT_NEAR((surface.height(y + step) - surface.height(y - step)) / (2 * step),
                  surface.climb(y), 1e-9);
    }
  // Sagitta of the two circles of case f at 11 mm.
  const double rail = 50.0 - std::sqrt(50.0 * 50.0 - 121.0);
  const double wheel = 51.282 - std::sqrt(51.282 * 51.282 - 121.0);
  EXPECT_NEAR(case_f.height(11.0), -0.5 * (rail + wheel), 1e-12);
  EXPECT_NEAR(case_f.local_rolling_radius(11.0), rolling_radius + wheel, 1e-12);
}

TEST(ContactSurface, IsRoundAsFarAsTheCaseSays) {
  Case input = parse_case(small_case, "s");
  input.wheel.transverse_radius = 10.0;
  input.wheel.round_to = 0.9;
  input.rail.transverse_radius = -10.25;
  const ContactSurface surface = Geometry(input).surface;
  const auto circle = [](double radius, double y) {
    return radius - std::sqrt(radius * radius - y * y);
  };
  EXPECT_NEAR(surface.local_rolling_radius(8.9), surface.rolling_radius - circle(10.0, 8.9), 1e-12);
  // The tangent at 9 mm of the wheel, that at 7.175 mm of the rail.
  EXPECT_NEAR(surface.wheel_drop(9.5).slope, 0.9 / std::sqrt(1.0 - 0.81), 1e-12);
  EXPECT_NEAR(surface.wheel_drop(9.5).value, circle(10.0, 9.0) + 0.5 * 0.9 / std::sqrt(0.19),
              1e-12);
  EXPECT_NEAR(surface.rail_drop(-9.5).slope, 0.7 / std::sqrt(1.0 - 0.49), 1e-12);
}

TEST(ContactSurface, ElementsTogetherHaveTheLengthOfTheArc) {
  // Wheel and rail of one circle: the arc between +-12 mm is 2 R asin(12/R).
  const ContactSurface circle{rolling_radius, -50.0, 50.0};
  const ContactGrid grid = ContactGrid::centred(1, 24, 1.0, 1.0);
  const PatchShape shape = patch_shape(circle, grid);
  EXPECT_NEAR(shape.stretch.sum(), 100.0 * std::asin(12.0 / 50.0), 1e-9);
  // The climb is the exact difference of heights over the element.
  EXPECT_NEAR(shape.climb[23], std::sqrt(2500.0 - 144.0) - std::sqrt(2500.0 - 121.0), 1e-10);
  const PatchShape plane = patch_shape({}, grid);
  EXPECT_NEAR((plane.stretch.array() - 1.0).abs().maxCoeff(), 0.0, 1e-15);
  EXPECT_EQ(plane.climb.norm(), 0.0);
}

TEST(UndeformedDistanceOfCircles, IsTheDifferenceOfTwoWaysAlongTheNormal) {
  for (const ContactSurface& surface : {case_d, case_e, case_f})
    for (const double y : {-11.0, 3.0, 0.5, 10.0}) {
      const double climb = surface.climb(y);
      const double length = std::hypot(1.0, climb);
      const double wheel = way_to_circle(y, surface.height(y), climb / length, 1.0 / length,
                                         -surface.wheel_transverse_radius);
      const double rail = way_to_circle(y, surface.height(y), climb / length, 1.0 / length,
                                        surface.rail_transverse_radius);
      EXPECT_NEAR(undeformed_distance(surface, 0.0, y), wheel - rail, 1e-12);
    }
}

TEST(UndeformedDistanceOfCircles, OfConformalOnesIsThatOfEccentricCircles) {
  // Two circles touching from inside, eccentric by e: e (1 - cos phi) along the radius at phi, to
  // the second order of e / R.
  const double e = 1.282;
  for (const double y : {2.0, 6.0, 11.0}) {
    const double phi = std::asin(y / 50.641);
    EXPECT_NEAR(undeformed_distance(case_f, 0.0, y) / (e * (1.0 - std::cos(phi))), 1.0, 3e-3);
  }
}

TEST(UndeformedDistanceOfCircles, AlongRollingIsTheWheelsCircleOfTheLocalRadius) {
  for (const double x : {-4.0, 1.0, 10.0})
    EXPECT_NEAR(undeformed_distance(case_f, x, 0.0),
                rolling_radius - std::sqrt(rolling_radius * rolling_radius - x * x), 1e-12);
  // At y = 10 the circle is larger and its rise is seen under the tilt of the normal.
  const double radius = case_f.local_rolling_radius(10.0);
  const double rise = radius - std::sqrt(radius * radius - 16.0);
  const double cosine = 1.0 / std::hypot(1.0, case_f.climb(10.0));
  const double change =
      undeformed_distance(case_f, 4.0, 10.0) - undeformed_distance(case_f, 0.0, 10.0);
  EXPECT_NEAR(change / (rise * cosine), 1.0, 2e-3);
}

TEST(UndeformedDistanceOfCircles, TendsToTheParabolaOfFlatBodies) {
  const Case input = parse_case(small_case, "s");
  const Curvatures curvatures = relative_curvatures(input);
  for (const double y : {0.0, 5.0, 11.0})
    EXPECT_NEAR(undeformed_distance(Geometry(input).surface, 3.0, y),
                undeformed_distance(curvatures, 3.0, y), 2e-6);
}

TangentialField rigid_slip_on(const ContactSurface& surface, const Creepage& creepage,
                              const ContactGrid& grid) {
  Geometry geometry;
  geometry.surface = surface;
  return ChartedGeometry(geometry, Chart::projected).rigid_slip(creepage, grid);
}

TEST(RigidSlipOfRotatingWheel, IsTheDifferenceOfVelocities) {
  const ContactGrid grid = ContactGrid::centred(5, 7, 1.0, 3.0);
  const Creepage creepage{0.002, 0.001, 3e-4};
  const TangentialField slip = rigid_slip_on(case_f, creepage, grid);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const double x = grid.x(i), y = grid.y(j);
      // Velocities in global axes at the wheel's surface: turning about the axle at z = R0,
      // sideways and about z, less the rail's (-1, 0, 0); then projected on the tangents.
      const double omega = (1.0 - creepage.longitudinal) / rolling_radius;
      const double radius = rolling_radius - (-51.282 + std::sqrt(51.282 * 51.282 - y * y));
      const double along = -omega * radius - creepage.spin * y + 1.0;
      const double lateral = creepage.lateral + creepage.spin * x;
      // Turning, the surface comes down ahead of the axle and goes up behind it.
      const double upwards = -omega * x;
      const double angle = std::atan(case_f.climb(y));
      EXPECT_NEAR(slip.x[grid.index(i, j)], along, 1e-14);
      EXPECT_NEAR(slip.y[grid.index(i, j)], lateral * std::cos(angle) + upwards * std::sin(angle),
                  1e-15);
    }
  // A concave wheel is larger beside the running circle and drives there.
  EXPECT_LT(slip.x[grid.index(2, 0)] - creepage.spin * 9.0, 0.001);
}

TEST(RigidSlipOfRotatingWheel, OfFlatProfilesIsThatOfThePlane) {
  Case input = parse_case(small_case, "s");
  input.rail.transverse_radius = infinity;
  const ContactGrid grid = ContactGrid::centred(4, 6, 1.0, 2.0);
  const Creepage creepage{0.002, 0.001, 3e-4};
  const TangentialField curved = rigid_slip_on(Geometry(input).surface, creepage, grid);
  const TangentialField plane = ChartedGeometry(input, Chart::plane).rigid_slip(creepage, grid);
  EXPECT_NEAR((curved.x - plane.x).norm(), 0.0, 1e-15);
  EXPECT_NEAR((curved.y - plane.y).norm(), 0.0, 1e-15);
}

TEST(TractionsOnACurvedPatch, OfUniformPressureGiveThePressureTimesTheProjection) {
  const ContactGrid grid = ContactGrid::centred(8, 20, 1.0, 1.0, 0.0, 3.0);
  const PatchShape shape = patch_shape(case_f, grid);
  PointResult point;
  const Field one = Field::Ones(grid.size());
  point.fields.traction = {Field::Zero(grid.size()), Field::Zero(grid.size()), one};
  integrate_tractions(grid, point, shape);
  EXPECT_NEAR(point.normal_force, 160.0, 1e-10);
  // Sideways: the length of the patch times the difference of heights at its ends.
  EXPECT_NEAR(point.lateral_force, -8.0 * (case_f.height(13.0) - case_f.height(-7.0)), 1e-8);
  // Tractions along the tangent lift with the climb.
  point.fields.traction = {one, one, one};
  integrate_tractions(grid, point, shape);
  EXPECT_NEAR(point.normal_force, 160.0 + 8.0 * (case_f.height(13.0) - case_f.height(-7.0)), 1e-8);
  EXPECT_NEAR(point.longitudinal_force, shape.stretch.sum(), 1e-10);
}

}  // namespace

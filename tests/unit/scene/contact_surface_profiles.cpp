// SPDX-License-Identifier: LGPL-2.1-or-later
// The common surface of true profiles: spheres and circles in closed form about tilted and yawed
// axles, the case of radii given as curves, rigid slip against velocities of a turning body.
#include "scene/geometry.hpp"

#include "support/profile_patches.hpp"

namespace {

TangentialField slip_of_the_surface(const ContactSurface& surface, const Creepage& creepage,
                                    const ContactGrid& grid) {
  Geometry geometry;
  geometry.surface = surface;
  return ChartedGeometry(geometry, Chart::projected).rigid_slip(creepage, grid);
}

ContactSurface surface_of(PatchGeometry geometry) {
  return ContactSurface::of(std::make_shared<PatchGeometry>(std::move(geometry)));
}

Vector3 direction(double tilt, double yaw) {
  return {std::sin(yaw), std::cos(yaw) * std::cos(tilt), std::cos(yaw) * std::sin(tilt)};
}

/// The nearer root of |start + way * normal - centre|^2 = radius^2.
double way_to_sphere(const Vector3& start, const Vector3& normal, const Vector3& centre,
                     double radius, bool circle) {
  double along = 0.0, square = -radius * radius;
  for (int d = circle ? 1 : 0; d < 3; ++d) {
    along += normal[d] * (start[d] - centre[d]);
    square += (start[d] - centre[d]) * (start[d] - centre[d]);
  }
  return -square / (along + std::copysign(std::sqrt(along * along - square), along));
}

}  // namespace

TEST(SurfaceOfProfiles, GivenAsCurvesIsThatOfTheRadii) {
  const double rolling = 405.0;
  for (const auto& [wheel, rail] : {std::pair{-105.263, 100.0}, std::pair{-51.282, 50.0}}) {
    const ContactSurface radii{rolling, wheel, rail};
    const ContactSurface curves = surface_of(circle_pair(rolling, wheel, rail));
    EXPECT_NEAR(curves.rolling_radius, rolling, 1e-9);
    EXPECT_EQ(curves.axle_tilt(), 0.0);
    for (const double y : {-11.0, -2.03, 0.0, 7.0}) {
      EXPECT_NEAR(curves.climb(y), radii.climb(y), 1e-8);
      EXPECT_NEAR(curves.height(y), radii.height(y), 1e-9);
      EXPECT_NEAR(curves.local_rolling_radius(y), radii.local_rolling_radius(y), 1e-9);
      for (const double x : {-6.0, 0.0, 2.0}) {
        EXPECT_NEAR(undeformed_distance(curves, x, y), undeformed_distance(radii, x, y), 2e-9);
        for (const bool of_wheel : {true, false})
          EXPECT_NEAR(surface_drop(curves, of_wheel, x, y), surface_drop(radii, of_wheel, x, y),
                      1e-9);
      }
    }
    const ContactGrid grid = ContactGrid::centred(3, 9, 1.0, 2.0);
    const Creepage creepage{0.002, 0.001, 3e-4};
    EXPECT_NEAR((slip_of_the_surface(curves, creepage, grid).x -
                 slip_of_the_surface(radii, creepage, grid).x)
                    .cwiseAbs()
                    .maxCoeff(),
                0.0, 1e-11);
  }
}

TEST(SurfaceOfProfiles, DistanceOfASphereIsTheSameAboutAnyAxle) {
  const double radius = 460.0, rail = 80.0;
  for (const auto& axle : {direction(0.0, 0.0), direction(0.4, 0.02), direction(1.1, -0.01)})
    for (const double follows : {1.0, 0.4, 0.0}) {
      ContactSurface surface = surface_of(sphere_on_circle(radius, rail, axle));
      surface.follows = follows;
      // The axle passes the centre, a radius above the origin.
      EXPECT_NEAR(surface.profiles->local_rolling_radius(0.0),
                  radius * std::sqrt(1.0 - axle[2] * axle[2]), 1e-9);
      EXPECT_NEAR(surface.profiles->tilt(), std::atan2(axle[2], axle[1]), 1e-12);
      for (const double x : {0.0, 3.0, -9.0})
        for (const double y : {-12.0, 0.0, 7.0}) {
          const double climb = surface.climb(y), length = std::hypot(1.0, climb);
          const Vector3 start{x, y, surface.height(y)};
          const Vector3 normal{0.0, -climb / length, 1.0 / length};
          const double exact = way_to_sphere(start, normal, {0.0, 0.0, radius}, radius, false) -
                               way_to_sphere(start, normal, {0.0, 0.0, -rail}, rail, true);
          EXPECT_NEAR(undeformed_distance(surface, x, y), exact, 1e-9) << x << ' ' << y;
        }
    }
}

TEST(SurfaceOfProfiles, FollowsTheBodiesAsFarAsItIsTold) {
  ContactSurface surface = surface_of(circle_pair(405.0, -51.282, 50.0));
  const double climb = surface.climb(7.0), height = surface.height(7.0);
  surface.follows = 0.25;
  EXPECT_DOUBLE_EQ(surface.climb(7.0), 0.25 * climb);
  EXPECT_DOUBLE_EQ(surface.height(7.0), 0.25 * height);
  // The plane, with the distance along z and its slip.
  surface.follows = 0.0;
  Geometry geometry;
  geometry.surface = surface;
  const ContactGrid grid = ContactGrid::centred(3, 9, 1.0, 2.0);
  const ChartedGeometry plane(geometry, Chart::plane), arc(geometry, Chart::arc);
  EXPECT_LT((plane.undeformed_distance(grid) - arc.undeformed_distance(grid)).norm(), 1e-9);
  const Creepage creepage{0.002, 0.001, 3e-4};
  EXPECT_LT((plane.rigid_slip(creepage, grid).x - arc.rigid_slip(creepage, grid).x).norm(), 1e-12);
  EXPECT_LT((plane.rigid_slip(creepage, grid).y - arc.rigid_slip(creepage, grid).y).norm(), 1e-12);
  EXPECT_EQ(arc.shape(grid).climb.norm(), 0.0);
}

TEST(SlipOfProfiles, IsThatOfABodyThatTurnsAboutItsTiltedAxle) {
  const double radius = 460.0, tilt = 0.7;
  const Vector3 axle = direction(tilt, 0.0);
  const ContactSurface surface = surface_of(sphere_on_circle(radius, 80.0, axle));
  const double rolling = radius * std::cos(tilt);
  EXPECT_NEAR(surface.rolling_radius, rolling, 1e-9);
  EXPECT_NEAR(surface.axle_tilt(), tilt, 1e-12);
  // Nothing but the turning: eta = 0, spin that of the axle about the normal.
  const double xi = 0.003, omega = (1.0 - xi) / rolling;
  const Creepage creepage{xi, 0.0, omega * std::sin(tilt)};
  const ContactGrid grid = ContactGrid::centred(5, 9, 2.0, 2.0);
  const TangentialField slip = slip_of_the_surface(surface, creepage, grid);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const double x = grid.x(i), y = grid.y(j), climb = surface.climb(y);
      // The point of the wheel's section runs with omega times its distance from the axle; across,
      // the velocity of the place itself, on the local tangent.
      const double z = radius - std::sqrt(radius * radius - y * y);
      const Vector3 lever{0.0, y, z - radius};
      Vector3 turned = cross(axle, lever);
      EXPECT_NEAR(slip.x[grid.index(i, j)], 1.0 + omega * turned[0], 1e-12);
      turned = cross(axle, {x, y, 0.0});
      const double across =
          omega * (turned[1] + climb * turned[2]) / std::sqrt(1.0 + climb * climb);
      EXPECT_NEAR(slip.y[grid.index(i, j)], across, 1e-12);
    }
}

TEST(SlipOfProfiles, HasTheGivenSpinAtTheOriginUnderAnyTilt) {
  const Creepage creepage{0.001, 5e-4, -2e-4};
  const double h = 1e-3;
  const ContactGrid grid = ContactGrid::centred(3, 3, h, h);
  for (const double tilt : {0.0, 0.05, 1.2}) {
    const ContactSurface surface = surface_of(sphere_on_circle(460.0, 300.0, direction(tilt, 0.0)));
    const TangentialField slip = slip_of_the_surface(surface, creepage, grid);
    EXPECT_NEAR(slip.x[4], creepage.longitudinal, 1e-12);
    EXPECT_NEAR((slip.x[7] - slip.x[1]) / (2 * h), -creepage.spin, 1e-9);
    EXPECT_NEAR((slip.y[5] - slip.y[3]) / (2 * h), creepage.spin, 1e-9);
  }
}

TEST(SurfaceOfProfiles, IsKnownAsFarAsBothProfilesReach) {
  const ContactSurface surface = surface_of(circle_pair(405.0, -105.263, 100.0));
  EXPECT_TRUE(surface.known(15.0));
  EXPECT_FALSE(surface.known(75.0));
  EXPECT_TRUE(ContactSurface{}.known(1e6));
}

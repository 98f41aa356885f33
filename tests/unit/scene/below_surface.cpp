// SPDX-License-Identifier: LGPL-2.1-or-later
// Coordinates that follow a curved surface: there and back, and those of circles in closed form.
#include "scene/below_surface.hpp"

#include "support/test.hpp"

namespace {

Geometry radii(double rolling, double wheel, double rail) {
  Geometry geometry;
  geometry.surface = {rolling, wheel, rail};
  return geometry;
}

TEST(BelowSurface, ThereAndBack) {
  const ChartedGeometry geometry(radii(405.0, -51.282, 50.0), Chart::arc);
  for (const bool wheel : {true, false}) {
    const BelowSurface body(geometry, wheel);
    for (const double depth : {0.0, 2.0, 9.0})
      for (const double y : {-12.0, 0.0, 5.0}) {
        const auto at = body.coordinates(body.place(3.0, y, depth));
        EXPECT_NEAR(at.x, 3.0, 1e-9);
        EXPECT_NEAR(at.y, y, 1e-9);
        EXPECT_NEAR(at.depth, depth, 1e-9);
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l) {
            double product = 0.0;
            for (std::size_t d = 0; d < 3; ++d) product += at.axes[k][d] * at.axes[l][d];
            EXPECT_NEAR(product, k == l ? 1.0 : 0.0, 1e-12);
          }
      }
  }
}

TEST(BelowSurface, CirclesOfOneRadiusArePolar) {
  // Wheel and rail are both on the circle of 50 mm about (0, -50); rolling on a cylinder.
  const ChartedGeometry geometry(radii(infinity, -50.0, 50.0), Chart::arc);
  const BelowSurface rail(geometry, false), wheel(geometry, true);
  for (const double angle : {-0.25, 0.1}) {
    for (const double depth : {0.0, 4.0, 20.0}) {
      const double radius = 50.0 - depth;
      const auto at =
          rail.coordinates({1.0, radius * std::sin(angle), radius * std::cos(angle) - 50.0});
      EXPECT_NEAR(at.x, 1.0, 1e-12);
      EXPECT_NEAR(at.y, 50.0 * angle, 1e-6);
      EXPECT_NEAR(at.depth, depth, 1e-9);
      EXPECT_NEAR(at.spread, radius / 50.0, 1e-6);
      EXPECT_NEAR(at.axes[2][1], std::sin(angle), 1e-9);
      EXPECT_NEAR(at.axes[2][2], std::cos(angle), 1e-9);
    }
    const auto above =
        wheel.coordinates({0.0, 53.0 * std::sin(angle), 53.0 * std::cos(angle) - 50.0});
    EXPECT_NEAR(above.depth, 3.0, 1e-9);
    EXPECT_NEAR(above.spread, 53.0 / 50.0, 1e-6);
  }
}

TEST(BelowSurface, StreamlinesOfAWheelAreCircles) {
  const ChartedGeometry geometry(radii(405.0, infinity, infinity), Chart::arc);
  const BelowSurface wheel(geometry, true);
  const auto at = wheel.coordinates({400.0 * std::sin(0.02), 1.0, 405.0 - 400.0 * std::cos(0.02)});
  EXPECT_NEAR(at.x, 405.0 * 0.02, 1e-9);
  EXPECT_NEAR(at.y, 1.0, 1e-12);
  EXPECT_NEAR(at.depth, 5.0, 1e-9);
  EXPECT_NEAR(at.axes[0][0], std::cos(0.02), 1e-12);
  EXPECT_NEAR(at.axes[0][2], std::sin(0.02), 1e-12);
  // As finite elements take places below their surface: along z.
  const auto below = wheel.below(8.0, 1.0, 5.0);
  EXPECT_NEAR(std::hypot(below[0], 405.0 - below[2]), 400.0, 1e-9);
  EXPECT_NEAR(below[0], 8.0, 1e-9);
}

TEST(BelowSurface, NormalsThatMeetAreReported) {
  const ChartedGeometry geometry(radii(405.0, -10.2, 10.0), Chart::arc);
  const BelowSurface rail(geometry, false);
  EXPECT_LT(rail.coordinates({0.0, 0.0, -9.8}).spread, 0.05);
}

}  // namespace

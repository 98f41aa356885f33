// SPDX-License-Identifier: LGPL-2.1-or-later
// The range of xz along rolling and the largest traction, of fields with known extremes.
#include "result/stress_extremes.hpp"

#include "support/test.hpp"

TEST(StressExtremes, TheRangeOfXzIsThatOfOneLineAtItsDepth) {
  // z exp(-z) sin(x - 0.3) cos(y - 0.1): the largest and the smallest xz of a line lie at x = 0.3
  // +- pi/2, and most apart at depth 1 and y = 0.1, by 2/e.
  PointResult point;
  point.semi_axis_x = 2.0;
  point.semi_axis_y = 1.0;
  point.patch_x_middle = 0.2;
  const RollingLines lines = rolling_lines(point, 0.13, 15, [](double x, double y, double depth) {
    return std::array<double, 3>{x, y, -depth};
  });
  std::vector<double> xz;
  for (const auto& [x, y, z] : lines.places)
    xz.push_back(-z * std::exp(z) * std::sin(x - 0.3) * std::cos(y - 0.1));
  const StressMaximum found = largest_xz_range("rail", lines, xz);
  EXPECT_NEAR(found.value, 2.0 / std::exp(1.0), 3e-4);
  EXPECT_NEAR(found.place[0], 0.3 + M_PI_2, 0.1);  // columns are 0.167 apart
  EXPECT_NEAR(found.place[1], 0.1, 0.01);
  EXPECT_NEAR(found.place[2], -1.0, 0.01);
  EXPECT_EQ(found.body, "rail");
}

TEST(StressExtremes, ShearOnTheSurfaceIsTheLargestTraction) {
  ContactGrid grid;
  grid.nx = 2;
  grid.ny = 2;
  grid.dx = grid.dy = 1.0;
  PointResult point;
  point.fields.traction.x = Field::Zero(4);
  point.fields.traction.y = Field::Zero(4);
  point.fields.traction.x[1] = -3.0;
  point.fields.traction.y[1] = 4.0;
  point.fields.traction.x[2] = 4.9;
  const StressMaximum found = largest_surface_shear("wheel", grid, point);
  EXPECT_DOUBLE_EQ(found.value, 5.0);
  EXPECT_EQ(found.place, (std::array<double, 3>{grid.x(1), grid.y(0), 0.0}));
}

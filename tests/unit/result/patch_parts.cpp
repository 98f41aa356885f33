// SPDX-License-Identifier: LGPL-2.1-or-later
// Regions of a contact: two semi-ellipsoids of pressure, whose forces and extents are known.
#include "base/pi.hpp"
#include "result/patch_size.hpp"
#include "result/result.hpp"

#include "support/test.hpp"

namespace {

double ellipsoid(double x, double y, double a, double b) {
  const double rest = 1.0 - x * x / (a * a) - y * y / (b * b);
  return rest > 0.0 ? 900.0 * std::sqrt(rest) : 0.0;
}

}  // namespace

TEST(PatchParts, AreTheRegionsWithTheirForces) {
  const ContactGrid grid = ContactGrid::centred(120, 300, 0.1, 0.1);
  ContactFields fields;
  fields.traction.n = grid.sample([](double x, double y) {
    return ellipsoid(x, y + 8.0, 5.0, 3.0) + ellipsoid(x, y - 6.0, 4.0, 5.0);
  });
  fields.traction.x = 0.1 * fields.traction.n;
  const auto parts = patch_parts(grid, fields);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(count_parts(grid, fields.traction.n), 2);
  const double volume = 2.0 / 3.0 * pi * 900.0;
  EXPECT_NEAR(parts[0].normal_force, volume * 20.0, 1e-3 * volume * 20.0);
  EXPECT_NEAR(parts[1].normal_force, volume * 15.0, 1e-3 * volume * 15.0);
  EXPECT_NEAR(parts[0].longitudinal_force, 0.1 * parts[0].normal_force, 1e-9);
  EXPECT_EQ(parts[0].lateral_force, 0.0);
  EXPECT_NEAR(parts[0].y, 6.0, 1e-3);
  EXPECT_NEAR(parts[1].y, -8.0, 1e-3);
  EXPECT_NEAR(parts[0].length, 8.0, 0.02);
  EXPECT_NEAR(parts[0].width, 10.0, 0.02);
  EXPECT_NEAR(parts[1].length, 10.0, 0.02);
}

TEST(PatchParts, ElementsThatMeetAtACornerAreOne) {
  const ContactGrid grid = ContactGrid::centred(4, 4, 1.0, 1.0);
  Field pressure = Field::Zero(16);
  pressure[grid.index(1, 1)] = pressure[grid.index(2, 2)] = 1.0;
  EXPECT_EQ(count_parts(grid, pressure), 1);
  pressure[grid.index(2, 2)] = 0.0;
  pressure[grid.index(3, 1)] = 1.0;
  EXPECT_EQ(count_parts(grid, pressure), 2);
  EXPECT_EQ(count_parts(grid, Field::Zero(16)), 0);
}

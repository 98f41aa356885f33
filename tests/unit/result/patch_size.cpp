// SPDX-License-Identifier: LGPL-2.1-or-later
// Patch size from sampled pressures, and the sums over the tractions.
#include "result/patch_size.hpp"

#include "contact/iteration/compliance.hpp"
#include "result/result.hpp"

#include "support/test.hpp"

namespace rollfem::contact {
namespace {

Field ellipse(const ContactGrid& grid, double a, double b, double x0 = 0.0, double y0 = 0.0) {
  return grid.sample([=](double x, double y) {
    const double u = (x - x0) / a;
    const double v = (y - y0) / b;
    return std::sqrt(std::max(0.0, 1.0 - u * u - v * v));
  });
}

TEST(PatchSize, OfAnExactEllipseIsExactWhereverItLies) {
  const ContactGrid grid = ContactGrid::centred(60, 50, 0.1, 0.2);
  for (const double shift : {0.0, 0.03, 0.05, 0.071}) {
    const PatchSize size = patch_size(grid, ellipse(grid, 2.3, 4.1, shift, -2 * shift));
    EXPECT_NEAR(size.length / 4.6, 1.0, 0.001);
    EXPECT_NEAR(size.width / 8.2, 1.0, 0.001);
    EXPECT_NEAR(size.area / (M_PI * 2.3 * 4.1), 1.0, 0.01);
  }
}

TEST(PatchSize, OfAFlatPunchIsThatOfItsElements) {
  const ContactGrid grid = ContactGrid::centred(40, 30, 0.1, 0.2);
  const Field pressure = grid.sample([](double x, double y) {
    const bool inside = std::abs(x) < 1.0 && std::abs(y) < 2.0;
    return inside ? 1.0 / std::sqrt((1.01 - x * x) * (4.1 - y * y)) : 0.0;
  });
  const PatchSize size = patch_size(grid, pressure);
  EXPECT_NEAR(size.length, 2.0, 1e-12);
  EXPECT_NEAR(size.width, 4.0, 1e-12);
  EXPECT_NEAR(size.area, 8.0, 1e-10);
}

TEST(PatchSize, OfTwoPatchesSpansBothButCoversOnlyThem) {
  const ContactGrid grid = ContactGrid::centred(120, 40, 0.1, 0.1);
  const Field pressure = ellipse(grid, 1.5, 1.5, -4.0) + ellipse(grid, 1.0, 1.0, 4.5);
  const PatchSize size = patch_size(grid, pressure);
  EXPECT_NEAR(size.length, 4.0 + 1.5 + 4.5 + 1.0, 0.02);
  EXPECT_NEAR(size.width, 3.0, 0.02);
  EXPECT_NEAR(size.area / (M_PI * (1.5 * 1.5 + 1.0)), 1.0, 0.02);
}

TEST(PatchSize, OfFewElementsCountsThem) {
  const ContactGrid grid = ContactGrid::centred(5, 5, 1.0, 2.0);
  Field pressure = Field::Zero(25);
  pressure[grid.index(2, 2)] = 1.0;
  PatchSize size = patch_size(grid, pressure);
  EXPECT_EQ(size.length, 1.0);
  EXPECT_EQ(size.width, 2.0);
  EXPECT_EQ(size.area, 2.0);
  size = patch_size(grid, Field::Zero(25));
  EXPECT_EQ(size.length, 0.0);
  EXPECT_EQ(size.area, 0.0);
}

TEST(IntegrateTractions, SumsForcesMomentAndMaxima) {
  const ContactGrid grid = ContactGrid::centred(2, 2, 0.5, 2.0);  // x = -+0.25, y = -+1
  PointResult point;
  point.fields.traction = {Field(4), Field(4), Field(4)};
  point.fields.traction.x << -1.0, -2.0, 0.0, 0.0;
  point.fields.traction.y << 0.0, 0.5, 0.0, -3.0;
  point.fields.traction.n << 10.0, 20.0, 0.0, 30.0;
  point.fields.state = {ElementState::adhesion, ElementState::slip, ElementState::exterior,
                        ElementState::slip};
  integrate_tractions(grid, point);
  EXPECT_DOUBLE_EQ(point.normal_force, 60.0);
  EXPECT_DOUBLE_EQ(point.longitudinal_force, -3.0);
  EXPECT_DOUBLE_EQ(point.lateral_force, -2.5);
  // sum(x Fy - y Fx): 0.25 (0.5 - 3) - (-1)(-1 - 2).
  EXPECT_DOUBLE_EQ(point.spin_moment, 0.25 * -2.5 - 3.0);
  EXPECT_DOUBLE_EQ(point.traction_coefficient, 0.05);
  EXPECT_DOUBLE_EQ(point.max_pressure, 30.0);
  EXPECT_DOUBLE_EQ(point.max_traction, 3.0);
  EXPECT_DOUBLE_EQ(point.max_traction_x, 2.0);
  EXPECT_NEAR(point.adhesion_area, point.contact_area / 3.0, 1e-12);
}

TEST(IntegrateTractions, TakesEmptyTangentialTractionsAsZero) {
  const ContactGrid grid = ContactGrid::centred(2, 1, 1.0, 1.0);
  PointResult point;
  point.fields.traction.n = Field::Ones(2);
  integrate_tractions(grid, point);
  EXPECT_EQ(point.longitudinal_force, 0.0);
  EXPECT_FALSE(std::signbit(point.traction_coefficient));
  EXPECT_EQ(point.max_traction, 0.0);
}

TEST(UpwindDifference, IsExactForItsOrderAndLooksUpstream) {
  const ContactGrid grid = ContactGrid::centred(8, 2, 0.25, 1.0, 3.0, 0.0);
  const Field linear = grid.sample([](double x, double y) { return 2.0 * x + y; });
  const Field square = grid.sample([](double x, double) { return x * x; });
  const TangentialField first = upwind_difference(grid, {linear, square}, UpwindOrder::first);
  const TangentialField second = upwind_difference(grid, {linear, square}, UpwindOrder::second);
  for (int k = 0; k < grid.size(); ++k) {
    EXPECT_NEAR(first.x[k], -2.0, 1e-12);  // -du/dx
    EXPECT_NEAR(second.x[k], -2.0, 1e-12);
  }
  for (int i = 0; i + 2 < grid.nx; ++i) {
    EXPECT_NEAR(second.y[i], -2.0 * grid.x(i), 1e-12);
    EXPECT_NEAR(first.y[i], -2.0 * grid.x(i) - grid.dx, 1e-12);
  }
  Field downstream = Field::Zero(grid.size());
  downstream[2] = 1.0;
  const Field w = upwind_difference(grid, {downstream, downstream}, UpwindOrder::second).x;
  for (int i = 3; i < grid.nx; ++i) EXPECT_EQ(w[i], 0.0);
  EXPECT_GT(w[2], 0.0);
}

TEST(UpwindDifference, OfFirstOrderHasTheSpinASixthOfItsStepUpstream) {
  EXPECT_DOUBLE_EQ(upstream_of_spin(UpwindOrder::first, 0.6), 0.1);
  EXPECT_EQ(upstream_of_spin(UpwindOrder::second, 0.6), 0.0);
}

}  // namespace
TEST(PatchSize, WidthOfACurvedPatchIsItsArcLength) {
  // The projection of a cylinder of 50 mm: 16 mm wide, of which the arc is 100 asin(8/50).
  const ContactGrid grid = ContactGrid::centred(40, 80, 0.4, 0.25);
  PointResult point;
  point.fields.traction.n = grid.sample([](double x, double y) {
    return 500.0 * std::sqrt(std::max(0.0, 1.0 - x * x / 36.0 - y * y / 64.0));
  });
  PatchShape shape;
  shape.climb = grid.sample([](double, double y) { return y / std::sqrt(2500.0 - y * y); });
  shape.stretch = (1.0 + shape.climb.array().square()).sqrt();
  integrate_tractions(grid, point, shape);
  const double arc = 100.0 * std::asin(8.0 / 50.0);
  EXPECT_NEAR(point.contact_width - 16.0, arc - 16.0, 0.05 * (arc - 16.0));
  EXPECT_DOUBLE_EQ(point.semi_axis_y, 0.5 * point.contact_width);
  shape.y = grid.sample([](double, double y) { return y; });  // the grid's own y is the arc length
  integrate_tractions(grid, point, shape);
  EXPECT_NEAR(point.contact_width, 16.0, 0.02);
}

}  // namespace rollfem::contact

// SPDX-License-Identifier: LGPL-2.1-or-later
// The half-space on one row of elements without ends across against half-planes as dense matrices,
// and against very long elements.
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/elasticity/influence.hpp"

#include "support/random_field.hpp"

namespace {

/// Aluminium on steel.
contact::CombinedMaterial unlike() {
  return contact::combine({70e3, 0.33}, {210e3, 0.28});
}

ContactGrid line_of(int n) {
  ContactGrid grid = ContactGrid::centred(n, 1, 0.05, 2.0);
  grid.line_reference = 30.0;
  return grid;
}

void expect_same(const Field& one, const Field& other) {
  EXPECT_LT((one - other).cwiseAbs().maxCoeff(), 1e-11 * other.cwiseAbs().maxCoeff());
}

/// Displacement of the elements, and of two beyond the last, as the sum over all elements of the
/// half-space's influence integrated along y (Johnson 1985, eq. 2.30 to 2.33).
SurfaceField summed(const ContactGrid& grid, const contact::CombinedMaterial& material,
                    const SurfaceField& p) {
  const double nu = material.poisson_ratio;
  const double scale = 2.0 * (1.0 - nu) / (M_PI * material.shear_modulus);
  const double k_over_g = material.difference / material.shear_modulus;
  const auto log_integral = [&](double s) {
    return s == 0.0 ? 0.0 : s - s * std::log(std::abs(s) / grid.line_reference);
  };
  const int n = grid.nx + 2;
  SurfaceField u{Field::Zero(n), Field::Zero(n), Field::Zero(n)};
  for (int to = 0; to < n; ++to)
    for (int from = 0; from < grid.nx; ++from) {
      const double k = to - from;
      const double own =
          scale * (log_integral((k + 0.5) * grid.dx) - log_integral((k - 0.5) * grid.dx));
      const double cross = -k_over_g * grid.dx * (std::abs(k + 0.5) - std::abs(k - 0.5));
      u.x[to] += own * p.x[from] + cross * p.n[from];
      u.y[to] += own / (1.0 - nu) * p.y[from];
      u.n[to] += own * p.n[from] - cross * p.x[from];
    }
  return u;
}

TEST(LineInfluence, OfAFourierSumIsThatOfADenseMatrix) {
  const ContactGrid grid = line_of(53);
  const int n = grid.nx;
  const halfspace::HalfspaceCompliance fast(grid, unlike());
  const SurfaceField p = random_field(grid, 7);
  const SurfaceField u = fast.apply(p), v = summed(grid, unlike(), p);
  expect_same(u.x, v.x.head(n));
  expect_same(u.y, v.y.head(n));
  expect_same(u.n, v.n.head(n));
  const SurfaceField alone = summed(grid, unlike().uncoupled(), p);
  Field normal;
  fast.normal().apply(p.n, normal);
  expect_same(normal, alone.n.head(n));
  // (u_i - u_(i+1)) / dx, and (3 u_i - 4 u_(i+1) + u_(i+2)) / (2 dx).
  const auto rolling_first = [&](const Field& w) -> Field {
    return (w.head(n) - w.segment(1, n)) / grid.dx;
  };
  const auto rolling_second = [&](const Field& w) -> Field {
    return (3.0 * w.head(n) - 4.0 * w.segment(1, n) + w.tail(n)) / (2.0 * grid.dx);
  };
  const contact::TangentialField first = fast.rolling(UpwindOrder::first).apply({p.x, p.y});
  expect_same(first.x, rolling_first(alone.x));
  expect_same(first.y, rolling_first(alone.y));
  const contact::TangentialField second = fast.rolling(UpwindOrder::second).apply({p.x, p.y});
  expect_same(second.x, rolling_second(alone.x));
  expect_same(second.y, rolling_second(alone.y));
  // The diagonal is the mean of what an element does to itself along and across.
  SurfaceField one{Field::Zero(n), Field::Zero(n), Field::Zero(n)};
  one.x[7] = one.y[7] = 1.0;
  const SurfaceField own = summed(grid, unlike().uncoupled(), one);
  const double diagonal = 0.5 * (rolling_second(own.x)[7] + rolling_second(own.y)[7]);
  EXPECT_NEAR(fast.rolling(UpwindOrder::second).diagonal(), diagonal, 1e-11 * diagonal);
  const double diagonal_first = 0.5 * (rolling_first(own.x)[7] + rolling_first(own.y)[7]);
  EXPECT_NEAR(fast.rolling(UpwindOrder::first).diagonal(), diagonal_first, 1e-11 * diagonal_first);
}

TEST(LineInfluence, IsTheHalfspaceUnderVeryLongElements) {
  const ContactGrid grid = line_of(12);
  const halfspace::HalfspaceCompliance line(grid, unlike());
  SurfaceField unit{Field::Zero(12), Field::Zero(12), Field::Zero(12)};
  unit.x[3] = unit.y[3] = unit.n[3] = 1.0;
  const SurfaceField u = line.apply(unit);
  const auto far = [&](int i) {
    return halfspace::rectangle_influence((i - 3) * grid.dx, 0.0, grid.dx, 1e5, unlike());
  };
  // Long elements lower the whole neighbourhood: only differences are comparable.
  const halfspace::Influence here = far(3);
  for (int i = 0; i < 12; ++i) {
    const halfspace::Influence there = far(i);
    EXPECT_NEAR(u.x[i] - u.x[3], there.xx + there.xn - here.xx - here.xn, 1e-6 * here.xx);
    EXPECT_NEAR(u.y[i] - u.y[3], there.yy - here.yy, 1e-6 * here.yy);
    EXPECT_NEAR(u.n[i] - u.n[3], there.nn - there.xn - here.nn + here.xn, 1e-6 * here.nn);
  }
}

TEST(LineInfluence, OfFiniteWidthIsTheMiddleOfALongElement) {
  const double dx = 0.05, length = 1e4;
  for (const int k : {0, 1, 5, 40}) {
    const auto line = halfspace::line_influence(k * dx, dx, length, unlike(), true);
    const auto rectangle = halfspace::rectangle_influence(k * dx, 0.0, dx, length, unlike());
    EXPECT_NEAR(line.xx / rectangle.xx, 1.0, 1e-6) << k;
    EXPECT_NEAR(line.yy / rectangle.yy, 1.0, 1e-6) << k;
    EXPECT_NEAR(line.nn / rectangle.nn, 1.0, 1e-6) << k;
    EXPECT_NEAR(line.xn, rectangle.xn, 1e-3 * std::abs(rectangle.xn)) << k;
  }
}

TEST(LineInfluence, OfFiniteWidthIsPositive) {
  ContactGrid grid = ContactGrid::centred(40, 1, 0.05, 10.0);
  grid.line_reference = contact::infinity;
  const halfspace::HalfspaceCompliance line(grid, unlike());
  const SurfaceField p = random_field(grid, 1);
  EXPECT_GT(dot(p, line.apply(p)), 0.0);
}

TEST(LineInfluence, AWidenedLineStaysOneRow) {
  const ContactGrid wider = line_of(10).widened(4, 6);
  EXPECT_EQ(wider.nx, 18);
  EXPECT_EQ(wider.ny, 1);
  EXPECT_TRUE(wider.is_line());
}

}  // namespace

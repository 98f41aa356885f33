// The half-space on one row of elements without ends across against half-planes as dense matrices,
// and against very long elements.
#include "halfspace/elasticity/compliance.hpp"
#include "halfspace/elasticity/influence.hpp"

#include <gtest/gtest.h>

#include "support/line_compliance.hpp"

namespace rollfem {
namespace {

using contact::ContactGrid;
using contact::Field;
using contact::SurfaceField;
using contact::UpwindOrder;
using testing::random_traction;
using testing::unlike;

ContactGrid line_of(int n) {
  ContactGrid grid = ContactGrid::centred(n, 1, 0.05, 2.0);
  grid.line_reference = 30.0;
  return grid;
}

void expect_same(const Field& one, const Field& other) {
  EXPECT_LT((one - other).cwiseAbs().maxCoeff(), 1e-11 * other.cwiseAbs().maxCoeff());
}

TEST(LineInfluence, OfAFourierSumIsThatOfADenseMatrix) {
  const ContactGrid grid = line_of(53);
  const halfspace::HalfspaceCompliance fast(grid, unlike());
  const testing::LineCompliance dense(grid, unlike(), grid.line_reference);
  const SurfaceField p = random_traction(grid.size(), 7);
  const SurfaceField u = fast.apply(p), v = dense.apply(p);
  expect_same(u.x, v.x);
  expect_same(u.y, v.y);
  expect_same(u.n, v.n);
  expect_same(fast.normal().apply(p.n), dense.normal().apply(p.n));
  for (const UpwindOrder order : {UpwindOrder::first, UpwindOrder::second}) {
    const contact::TangentialField t = fast.rolling(order).apply({p.x, p.y});
    const contact::TangentialField w = dense.rolling(order).apply({p.x, p.y});
    expect_same(t.x, w.x);
    expect_same(t.y, w.y);
    EXPECT_NEAR(fast.rolling(order).diagonal(), dense.rolling(order).diagonal(),
                1e-11 * dense.rolling(order).diagonal());
  }
}

TEST(LineInfluence, IsTheMiddleOfAnElementAsLongAsTheReference) {
  const double dx = 0.05, length = 1e4;
  for (const int k : {0, 1, 5, 40}) {
    const auto line = halfspace::line_influence(k * dx, dx, length, unlike());
    const auto rectangle = halfspace::rectangle_influence(k * dx, 0.0, dx, length, unlike());
    EXPECT_NEAR(line.nn / rectangle.nn, 1.0, 1e-6) << k;
    EXPECT_NEAR(line.xn, rectangle.xn, 1e-3 * std::abs(rectangle.xn)) << k;
  }
}

TEST(LineInfluence, AWidenedLineStaysOneRow) {
  const ContactGrid wider = line_of(10).widened(4, 6);
  EXPECT_EQ(wider.nx, 18);
  EXPECT_EQ(wider.ny, 1);
  EXPECT_TRUE(wider.is_line());
}

}  // namespace
}  // namespace rollfem

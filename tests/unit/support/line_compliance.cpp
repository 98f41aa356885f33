// Half-planes: influence coefficients against the half-space's on very long elements, symmetry, and
// the pressure of Hertz's line contact.
#include "support/line_compliance.hpp"

#include "contact/solve/normal.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/elasticity/influence.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rollfem {
namespace {

using contact::ContactGrid;
using contact::Field;
using contact::SurfaceField;
using contact::UpwindOrder;
using testing::LineCompliance;
using testing::random_traction;
using testing::unlike;

TEST(LineCompliance, IsTheHalfspaceUnderVeryLongElements) {
  const ContactGrid grid = ContactGrid::centred(12, 1, 0.1, 1.0);
  const LineCompliance line(grid, unlike());
  SurfaceField unit{Field::Zero(12), Field::Zero(12), Field::Zero(12)};
  unit.x[3] = unit.y[3] = unit.n[3] = 1.0;
  const SurfaceField u = line.apply(unit);
  const double length = 1e5;
  const auto far = [&](int i) {
    return halfspace::rectangle_influence((i - 3) * grid.dx, 0.0, grid.dx, length, unlike());
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

TEST(LineCompliance, IsSymmetricAndPositive) {
  const ContactGrid grid = ContactGrid::centred(40, 1, 0.05, 1.0);
  const LineCompliance line(grid, unlike());
  const SurfaceField p = random_traction(40, 1);
  const SurfaceField q = random_traction(40, 2);
  const auto product = [](const SurfaceField& a, const SurfaceField& b) {
    return a.x.dot(b.x) + a.y.dot(b.y) + a.n.dot(b.n);
  };
  const double pq = product(p, line.apply(q));
  EXPECT_NEAR(pq, product(line.apply(p), q), 1e-12 * product(p, line.apply(p)));
  EXPECT_GT(product(p, line.apply(p)), 0.0);
}

TEST(LineCompliance, UpwindOperatorIsTheDifferenceOfItsDisplacements) {
  const ContactGrid grid = ContactGrid::centred(30, 1, 0.05, 1.0);
  const LineCompliance line(grid, unlike());
  const SurfaceField p = random_traction(30, 3);
  for (const UpwindOrder order : {UpwindOrder::first, UpwindOrder::second}) {
    const contact::TangentialField t = line.rolling(order).apply({p.x, p.y});
    const contact::TangentialField u = line.shift().apply({p.x, p.y});
    const contact::TangentialField d = contact::upwind_difference(grid, u, order);
    for (int i = 0; i + 2 < 30; ++i) {
      EXPECT_NEAR(t.x[i], d.x[i], 1e-9 * t.x.cwiseAbs().maxCoeff());
      EXPECT_NEAR(t.y[i], d.y[i], 1e-9 * t.y.cwiseAbs().maxCoeff());
    }
  }
}

TEST(LineCompliance, GivesHertzsLineContactWhateverTheReference) {
  // Benchmark 1: R = 500, a = 1, E* = 113 888.9: 178.896 N/mm, 113.889 MPa.
  contact::CombinedMaterial material;
  material.shear_modulus = 82000.0;
  material.poisson_ratio = 0.28;
  material.contact_modulus = 82000.0 / 0.72;
  const ContactGrid grid = ContactGrid::centred(88, 1, 1.0 / 40, 1.0);
  const Field h = grid.sample([](double x, double) { return x * x / 1000.0; });
  for (const double reference : {0.0, 1000.0}) {
    const LineCompliance line(grid, material, reference);
    const contact::NormalSolution s = contact::solve_normal(line.normal(), {h, 178.896, {}});
    EXPECT_NEAR(s.pressure.maxCoeff() / 113.889, 1.0, 2e-4);
    EXPECT_EQ(s.contact_elements, 80);
  }
}

}  // namespace
}  // namespace rollfem

// SPDX-License-Identifier: LGPL-2.1-or-later
// Influence coefficients of the half-space against quadrature, point loads and closed values.
#include "halfspace/elasticity/influence.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "support/test.hpp"

namespace rollfem::halfspace {
namespace {

contact::CombinedMaterial unlike_materials() {
  return contact::combine({210e3, 0.3}, {70e3, 0.33});
}

/// Displacement difference per force at a point of the surface, Johnson 1985, eqs. 3.18 and 3.75.
Influence point_influence(double x, double y, const contact::CombinedMaterial& material) {
  const double r = std::hypot(x, y);
  const double nu = material.poisson_ratio;
  const double unit = 1.0 / (M_PI * material.shear_modulus * r);
  Influence result;
  result.xx = unit * (1.0 - nu + nu * x * x / (r * r));
  result.yy = unit * (1.0 - nu + nu * y * y / (r * r));
  result.xy = unit * nu * x * y / (r * r);
  result.nn = unit * (1.0 - nu);
  result.xn = -unit * material.difference * x / r;
  result.yn = -unit * material.difference * y / r;
  return result;
}

/// One coefficient integrated numerically from point loads, the rectangle split at the field point.
double integrated(double Influence::*component, double x, double y, double dx, double dy,
                  const contact::CombinedMaterial& material) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  const auto inner = [&](double sy) {
    const auto f = [&](double sx) { return point_influence(x - sx, y - sy, material).*component; };
    return Rule::integrate(f, -0.5 * dx, 0.5 * dx, 15, 1e-12);
  };
  return Rule::integrate(inner, -0.5 * dy, 0.5 * dy, 15, 1e-12);
}

constexpr double Influence::*components[] = {&Influence::xx, &Influence::yy, &Influence::xy,
                                             &Influence::nn, &Influence::xn, &Influence::yn};

TEST(Influence, AgreesWithQuadratureOfPointLoadsOutsideTheElement) {
  const contact::CombinedMaterial material = unlike_materials();
  const double dx = 0.3;
  const double dy = 0.8;
  for (const auto& [x, y] : {std::pair{0.4, 0.1},
                             {-0.6, 1.2},
                             {1.7, -0.9},
                             {-2.3, -5.0},
                             {5.5, 0.3},
                             {0.0, 5.9},
                             {30.0, -21.0}}) {
    const Influence a = rectangle_influence(x, y, dx, dy, material);
    const double size = std::abs(a.nn);
    for (const auto component : components)
      EXPECT_NEAR(a.*component, integrated(component, x, y, dx, dy, material), 2e-12 * size)
          << "at " << x << ", " << y;
  }
}

TEST(Influence, OfASquareAtItsCentreAndCornerIsLoves) {
  // Like materials with E and nu: u_z of one body is half the difference.
  const double young = 210e3;
  const double nu = 0.3;
  const contact::CombinedMaterial material = contact::combine({young, nu}, {young, nu});
  const double side = 0.7;
  const double unit = 2.0 * (1.0 - nu * nu) * side / young;
  const double centre = rectangle_influence(0.0, 0.0, side, side, material).nn / unit;
  const double corner = rectangle_influence(side / 2, side / 2, side, side, material).nn / unit;
  EXPECT_NEAR(centre, 4.0 / M_PI * std::log(1.0 + std::sqrt(2.0)), 1e-14);
  EXPECT_NEAR(centre, 1.122200, 5e-7);
  EXPECT_NEAR(corner, 0.561100, 5e-7);
}

TEST(Influence, InsideTheElementAddsUpFromFourQuarters) {
  // The field point as a common corner of four rectangles, each seen from outside its interior.
  const contact::CombinedMaterial material = unlike_materials();
  const double dx = 1.0;
  const double dy = 0.4;
  const double x = 0.3;
  const double y = -0.12;
  const double x0 = x - 0.5 * dx, x1 = x + 0.5 * dx, y0 = y - 0.5 * dy, y1 = y + 0.5 * dy;
  for (const auto component : components) {
    double sum = 0.0;
    for (const double a : {x0, x1})
      for (const double b : {y0, y1})
        sum += rectangle_influence(0.5 * a, 0.5 * b, std::abs(a), std::abs(b), material).*component;
    EXPECT_NEAR(rectangle_influence(x, y, dx, dy, material).*component, sum, 1e-18);
  }
}

TEST(Influence, TendsToAPointLoadFarAway) {
  const contact::CombinedMaterial material = unlike_materials();
  for (const double distance : {10.0, 100.0, 1000.0, 1e6}) {
    const double x = 0.8 * distance;
    const double y = -0.6 * distance;
    const Influence a = rectangle_influence(x, y, 1.0, 1.0, material);
    const Influence p = point_influence(x, y, material);
    for (const auto component : components)
      EXPECT_NEAR(a.*component, p.*component, 0.3 / (distance * distance) * p.nn + 1e-13 * p.nn);
  }
}

TEST(Influence, DoesNotJumpWhereTheMethodChanges) {
  const contact::CombinedMaterial material = unlike_materials();
  for (const double distance : {14.0 * 0.5, 110.0 * 0.5})
    for (const auto component : components) {
      const double direction[2] = {0.6, 0.8};
      const auto value = [&](double r) {
        return rectangle_influence(r * direction[0], r * direction[1], 1.0, 1.0, material).*
               component;
      };
      const double step = 1e-9 * distance;
      const double jump = value(distance + step) - value(distance - step);
      EXPECT_NEAR(jump / value(distance), 0.0, 1e-8);
      EXPECT_NEAR((value(distance + step) / value(distance - step) - 1.0), -2e-9, 2e-9);
    }
}

TEST(Influence, PressureDrawsTheSofterSurfaceTowardsIt) {
  // Johnson 1985 eq. 3.18a: u_r = -(1 - 2 nu) P / (4 pi G r). A wheel softer than the rail moves
  // towards the load: u_x < 0 at x > 0.
  const contact::CombinedMaterial material = contact::combine({70e3, 0.3}, {210e3, 0.3});
  EXPECT_GT(material.difference, 0.0);
  EXPECT_LT(rectangle_influence(3.0, 0.0, 1.0, 1.0, material).xn, 0.0);
  const double g1 = contact::shear_modulus({70e3, 0.3});
  const double g2 = contact::shear_modulus({210e3, 0.3});
  EXPECT_NEAR(point_influence(3.0, 0.0, material).xn,
              -(1.0 - 0.6) / (4.0 * M_PI * 3.0) * (1.0 / g1 - 1.0 / g2), 1e-19);
}

}  // namespace
}  // namespace rollfem::halfspace

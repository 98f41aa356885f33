// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement under Hertz's pressure: quadrature, the point load, the closed form of the circle.
#include "base/pi.hpp"
#include "halfspace/closed_forms/hertz.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "support/test.hpp"

namespace rollfem::halfspace {
namespace {

constexpr double modulus = 115384.6;

/// u = 1/(pi E*) times the integral of p/distance, over a polar grid about the point: the distance
/// cancels against the area element.
template <class Pressure>
double by_quadrature(Pressure&& pressure, double x, double y, double reach) {
  using boost::math::quadrature::gauss_kronrod;
  const auto along_ray = [&](double angle) {
    return gauss_kronrod<double, 61>::integrate(
        [&](double s) { return pressure(x + s * std::cos(angle), y + s * std::sin(angle)); }, 0.0,
        reach, 10, 1e-7);
  };
  return gauss_kronrod<double, 61>::integrate(along_ray, 0.0, 2.0 * pi, 6, 1e-6) / (pi * modulus);
}

TEST(HertzFields, EllipseAgreesWithQuadrature) {
  const HertzContact hertz = hertz_from_force(1.0 / 810, 1.0 / 200, modulus, 50e3);
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {3.0, 1.0}, {8.0, 0.0}, {0.0, 3.5}, {5.0, 6.0}}) {
    const double sum =
        by_quadrature([&](double u, double v) { return hertz.pressure(u, v); }, x, y, 20.0);
    EXPECT_NEAR(hertz_displacement(hertz, modulus, x, y) / sum, 1.0, 2e-4) << x << ", " << y;
  }
}

TEST(HertzFields, EllipseTendsToThePointLoad) {
  const HertzContact hertz = hertz_from_force(1.0 / 810, 1.0 / 4000, modulus, 50e3);
  const double r = 2000.0;
  EXPECT_NEAR(hertz_displacement(hertz, modulus, 0.6 * r, 0.8 * r) * pi * modulus * r / 50e3, 1.0,
              1e-4);
}

/// Johnson 1985, eq. 3.42.
double circle_displacement(const HertzContact& contact, double radius) {
  const double a = contact.semi_axis_x;
  const double r2 = radius * radius;
  if (radius <= a) return pi * contact.max_pressure * (2.0 * a * a - r2) / (4.0 * a * modulus);
  const double ratio = a / radius;
  return contact.max_pressure / (2.0 * a * modulus) *
         ((2.0 * a * a - r2) * std::asin(ratio) +
          r2 * ratio * std::sqrt((1.0 - ratio) * (1.0 + ratio)));
}

TEST(HertzFields, CircleIsTheEllipseOfEqualAxes) {
  const HertzContact hertz = hertz_from_force(0.001, 0.001, modulus, 20e3);
  for (const double ratio : {0.0, 0.5, 0.999999, 1.000001, 1.3, 40.0}) {
    const double r = ratio * hertz.semi_axis_x;
    EXPECT_NEAR(
        circle_displacement(hertz, r) / hertz_displacement(hertz, modulus, 0.6 * r, 0.8 * r), 1.0,
        1e-8)
        << ratio;
  }
  EXPECT_NEAR(circle_displacement(hertz, 0.0), hertz.approach, 1e-10 * hertz.approach);
}

}  // namespace
}  // namespace rollfem::halfspace

// Displacement under circular pressures: the general ellipse, quadrature and Johnson's values.
#include "halfspace/closed_forms/hertz_fields.hpp"

#include "contact/base/errors.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace rollfem::halfspace {
namespace {

const double pi = std::acos(-1.0);
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

TEST(HertzFields, CircleIsTheEllipseOfEqualAxes) {
  const HertzContact hertz = hertz_from_force(0.001, 0.001, modulus, 20e3);
  for (const double ratio : {0.0, 0.5, 0.999999, 1.000001, 1.3, 40.0}) {
    const double r = ratio * hertz.semi_axis_x;
    EXPECT_NEAR(hertz_circle_displacement(hertz, modulus, r) /
                    hertz_displacement(hertz, modulus, 0.6 * r, 0.8 * r),
                1.0, 1e-8)
        << ratio;
  }
  EXPECT_NEAR(hertz_circle_displacement(hertz, modulus, 0.0), hertz.approach,
              1e-10 * hertz.approach);
}

TEST(HertzFields, CircleFormulaRefusesAnEllipse) {
  const HertzContact hertz = hertz_from_force(0.001, 0.002, modulus, 20e3);
  EXPECT_THROW(hertz_circle_displacement(hertz, modulus, 1.0), contact::InputError);
}

TEST(HertzFields, UniformCircleHasJohnsonsCentreAndEdge) {
  // Johnson 1985, section 3.4: 2 (1 - nu^2) p a / E and 4 (1 - nu^2) p a / (pi E).
  EXPECT_NEAR(uniform_circle_displacement(100.0, 3.0, modulus, 0.0), 2.0 * 100 * 3 / modulus,
              1e-15);
  EXPECT_NEAR(uniform_circle_displacement(100.0, 3.0, modulus, 3.0), 4.0 * 100 * 3 / (pi * modulus),
              1e-15);
  EXPECT_NEAR(uniform_circle_displacement(100.0, 3.0, modulus, 3.0 * (1 + 1e-9)),
              uniform_circle_displacement(100.0, 3.0, modulus, 3.0 * (1 - 1e-9)), 1e-9);
  EXPECT_NEAR(uniform_circle_displacement(100.0, 3.0, modulus, 3000.0) * pi * modulus * 3000.0 /
                  (100.0 * pi * 9.0),
              1.0, 1e-5);
}

}  // namespace
}  // namespace rollfem::halfspace

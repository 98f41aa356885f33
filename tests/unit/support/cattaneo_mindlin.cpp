// SPDX-License-Identifier: LGPL-2.1-or-later
// Cattaneo-Mindlin: benchmark 3, equilibrium, and the loss as the area of the loop.
#include "support/cattaneo_mindlin.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>

namespace rollfem::testing {
namespace {

const double pi = std::acos(-1.0);

/// Benchmark 3: G = 200, nu = 0.42, R = 50 (A = B = 0.01), mu = 0.4, a = 1.
CattaneoMindlin benchmark(double* limit = nullptr) {
  const contact::Material body{2.0 * 200.0 * 1.42, 0.42};
  const contact::CombinedMaterial material = contact::combine(body, body);
  const halfspace::HertzContact hertz =
      halfspace::hertz_from_force(0.01, 0.01, material.contact_modulus, 9.1954);
  EXPECT_NEAR(hertz.semi_axis_x, 1.0, 1e-5);
  EXPECT_NEAR(hertz.max_pressure, 4.3905, 1e-4);
  EXPECT_NEAR(hertz.approach, 0.02, 1e-6);
  if (limit != nullptr) *limit = 0.4 * hertz.normal_force;
  return {hertz, material, 0.4};
}

TEST(CattaneoMindlin, GivesTheBenchmark) {
  double limit = 0.0;
  const CattaneoMindlin contact = benchmark(&limit);
  EXPECT_NEAR(contact.stick_radius(0.875 * limit), 0.5, 1e-5);
  EXPECT_NEAR(contact.shift(0.875 * limit), 0.008172, 5e-7);
}

TEST(CattaneoMindlin, TractionsCarryTheForce) {
  double limit = 0.0;
  const CattaneoMindlin contact = benchmark(&limit);
  boost::math::quadrature::tanh_sinh<double> rule;
  const auto carried = [&](auto&& traction, std::initializer_list<double> ends) {
    double sum = 0.0;
    for (auto end = ends.begin(); end + 1 != ends.end(); ++end)
      sum += rule.integrate([&](double r) { return 2.0 * pi * r * traction(r); }, *end, end[1]);
    return sum;
  };
  const double q = 0.7 * limit;
  const double c = contact.stick_radius(q);
  EXPECT_NEAR(carried([&](double r) { return contact.traction(q, r); }, {0.0, c, 1.001}), q,
              1e-4 * q);
  const double back = -0.2 * limit;
  const double inner = contact.stick_radius(0.5 * (q - back));
  EXPECT_NEAR(carried([&](double r) { return contact.unloading_traction(q, back, r); },
                      {0.0, c, inner, 1.001}),
              back, 1e-4 * q);
}

TEST(CattaneoMindlin, UnloadingClosesTheLoop) {
  double limit = 0.0;
  const CattaneoMindlin contact = benchmark(&limit);
  const double q = 0.9 * limit;
  EXPECT_NEAR(contact.unloading_shift(q, q), contact.shift(q), 1e-15);
  EXPECT_NEAR(contact.unloading_shift(q, -q), -contact.shift(q), 1e-15);
  EXPECT_NEAR(contact.unloading_traction(q, -q, 0.3), -contact.traction(q, 0.3), 1e-14);
}

TEST(CattaneoMindlin, LossIsTheAreaOfTheLoop) {
  double limit = 0.0;
  const CattaneoMindlin contact = benchmark(&limit);
  boost::math::quadrature::tanh_sinh<double> rule;
  for (const double share : {0.2, 0.6, 0.95}) {
    const double q = share * limit;
    const double area = rule.integrate(
        [&](double force) {
          // The way back lies above the way there, which is its mirror image.
          return contact.unloading_shift(q, force) + contact.unloading_shift(q, -force);
        },
        -q, q);
    EXPECT_NEAR(contact.cyclic_loss(q) / area, 1.0, 1e-8) << share;
  }
}

}  // namespace
}  // namespace rollfem::testing

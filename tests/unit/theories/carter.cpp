// SPDX-License-Identifier: LGPL-2.1-or-later
// Carter's closed form against benchmark numbers, quadrature, and its limits.
#include "theories/carter.hpp"

#include "halfspace/closed_forms/hertz.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>

#include "support/test.hpp"

namespace rollfem::theories {

using namespace halfspace;
namespace {

const double pi = std::acos(-1.0);

/// Benchmark 2: a = 1, R = 500, G = 82000, nu = 0.28, mu = 0.3.
CarterContact benchmark() {
  const double modulus = 82000.0 / (1.0 - 0.28);
  const LineHertz line = line_hertz(500.0, modulus, pi * modulus / (4.0 * 500.0), 1.0);
  return {line.half_width, line.max_pressure, 0.3, modulus};
}

TEST(Carter, GivesTheBenchmark) {
  const CarterContact contact = benchmark();
  EXPECT_NEAR(contact.force_per_length(), 178.896, 5e-4);
  EXPECT_NEAR(contact.saturation_creepage(), 6e-4, 1e-15);
  const CarterSolution braking(contact, 2.4e-4);
  EXPECT_NEAR(braking.stick_half_width(), 0.6, 1e-12);
  EXPECT_NEAR(braking.force(), -0.64 * 0.3 * contact.force_per_length(), 1e-10);
  EXPECT_NEAR(CarterSolution(contact, -2.4e-4).force(), -braking.force(), 1e-12);
}

TEST(Carter, InitialSlopeIsThatOfTheBenchmark) {
  // dF_x/dxi at xi = 0: -pi a E* / 2.
  EXPECT_NEAR(CarterSolution(benchmark(), 1e-10).force() / 1e-10, -178896.0, 0.5);
}

TEST(Carter, ForceIsTheIntegralOfTheTraction) {
  const CarterContact contact = benchmark();
  boost::math::quadrature::tanh_sinh<double> rule;
  for (const double xi : {-3e-4, 1e-5, 2.4e-4, 5.9e-4, 8e-4}) {
    const CarterSolution carter(contact, xi);
    const double split = std::min(carter.stick_middle() - carter.stick_half_width(), 0.999);
    const auto q = [&](double x) { return carter.traction(x); };
    EXPECT_NEAR(rule.integrate(q, -1.0, split) + rule.integrate(q, split, 1.0), carter.force(),
                1e-9 * std::abs(carter.force()))
        << xi;
  }
}

/// Slip from the traction alone: w = xi - du/dx, du/dx = -2/(pi E*) PV of p(s)/(x - s) ds.
double slip_by_quadrature(const CarterContact& contact, const CarterSolution& carter, double xi,
                          double x) {
  boost::math::quadrature::tanh_sinh<double> rule;
  const double at_x = carter.traction(x);
  // The traction less its value at x removes the singularity; the rest is a logarithm.
  const auto regular = [&](double s) {
    return s == x ? 0.0 : (carter.traction(s) - at_x) / (x - s);
  };
  const double corner = carter.stick_middle() - carter.stick_half_width();
  double integral = at_x * std::log((x + 1.0) / (1.0 - x));
  std::vector<double> ends{-1.0, x, 1.0};
  if (corner < 1.0) ends.push_back(corner);
  std::sort(ends.begin(), ends.end());
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    integral += rule.integrate(regular, ends[k], ends[k + 1], 1e-10);
  return xi + 2.0 / (pi * contact.contact_modulus) * integral;
}

TEST(Carter, LargestTractionIsTheLargestOfAll) {
  const CarterContact contact = benchmark();
  for (const double part : {-1.5, -0.9, 0.05, 0.3, 0.6, 1.0}) {
    const CarterSolution solution(contact, part * contact.saturation_creepage());
    double largest = 0.0;
    constexpr int places = 4000;
    for (int k = 0; k <= places; ++k)
      largest = std::max(
          largest, std::abs(solution.traction(contact.half_width * (2.0 * k / places - 1.0))));
    const double bound = contact.friction * contact.max_pressure;
    EXPECT_GE(solution.largest_traction(), largest - 1e-12 * bound) << part;
    EXPECT_NEAR(solution.largest_traction(), largest, 1e-2 * bound) << part;
  }
  EXPECT_EQ(CarterSolution(contact, 0.0).largest_traction(), 0.0);
}

TEST(Carter, SlipIsThatOfTheTraction) {
  const CarterContact contact = benchmark();
  for (const double xi : {2.4e-4, -4e-4, 9e-4}) {
    const CarterSolution carter(contact, xi);
    for (const double x : {-0.95, -0.7, -0.4, 0.1, 0.6, 0.9})
      EXPECT_NEAR(carter.slip(x), slip_by_quadrature(contact, carter, xi, x), 1e-6 * std::abs(xi))
          << "xi " << xi << " x " << x;
  }
}

}  // namespace
}  // namespace rollfem::theories

// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies that are flatter than paraboloids, h = A r^(2n): Steuermann (1939), for a frictionless
// axisymmetric contact also from Sneddon's integrals, with f = h:
//   approach = a int_0^a f'(r)/sqrt(a^2 - r^2) dr,  P = 2 E* int_0^a r^2 f'(r)/sqrt(a^2 - r^2) dr.
#include "contact/iteration/normal.hpp"
#include "contact/result/patch_size.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"

#include "support/recorded.hpp"

namespace {

constexpr double half_width = 5.0;  // mm
constexpr double steepness = 1e-3;  // h = 1e-3 mm at the edge
constexpr double contact_modulus = 210e3 / (2.0 * 0.91);

struct Closed {
  double force, approach, largest, middle;
};

/// In units of A a^(2n): approach 8/3, 16/5; force 64/15, 192/35 a E*.
Closed closed_form(int n) {
  const double unit = contact_modulus * steepness;
  // p = (32/9 pi) E* A s (a^2 + 2 r^2), s = sqrt(a^2 - r^2), largest at r^2 = a^2/2; and
  // (96/5 pi) E* A (s^5/5 + 2 r^2 s^3/3 + r^4 s), largest at r^2 = (1 + sqrt(3)) a^2/4.
  if (n == 2)
    return {64.0 / 15.0 * unit * half_width, 8.0 / 3.0 * steepness,
            32.0 / (9.0 * M_PI) * unit / half_width * std::sqrt(2.0),
            32.0 / (9.0 * M_PI) * unit / half_width};
  const auto pressure = [&](double r2) {
    const double s = std::sqrt(1.0 - r2);
    return 96.0 / (5.0 * M_PI) * unit / half_width *
           (std::pow(s, 5) / 5.0 + 2.0 * r2 * std::pow(s, 3) / 3.0 + r2 * r2 * s);
  };
  double largest = 0.0;
  for (int k = 0; k < 10000; ++k) largest = std::max(largest, pressure(k * 1e-4));
  return {192.0 / 35.0 * unit * half_width, 16.0 / 5.0 * steepness, largest, pressure(0.0)};
}

struct Errors {
  double radius, approach, largest, middle;
};

/// Errors with `across` elements over the diameter, relative.
Errors errors(int n, int across) {
  const Closed exact = closed_form(n);
  const double cell = 2.0 * half_width / across;
  const ContactGrid grid = ContactGrid::centred(across + 7, across + 7, cell, cell);
  contact::NormalProblem problem;
  problem.undeformed_distance = grid.sample([&](double x, double y) {
    return steepness * std::pow((x * x + y * y) / (half_width * half_width), n);
  });
  problem.normal_force = exact.force;
  const contact::Material steel{210e3, 0.3};
  const halfspace::HalfspaceCompliance compliance(grid, contact::combine(steel, steel));
  const auto solution = contact::solve_normal(compliance.normal(), problem);
  const auto size = contact::patch_size(grid, solution.pressure);
  const int middle = grid.index(grid.nx / 2, grid.ny / 2);
  return {0.5 * size.length / half_width - 1.0, solution.approach / exact.approach - 1.0,
          solution.pressure.maxCoeff() / exact.largest - 1.0,
          solution.pressure[middle] / exact.middle - 1.0};
}

class Steuermann : public ::testing::TestWithParam<int> {};

/// Integral from 0 to `end` by the midpoint rule, whose errors here are below 1e-5.
template <class Function>
double integral(double end, const Function& function) {
  constexpr int steps = 1000;
  double sum = 0.0;
  for (int k = 0; k < steps; ++k) sum += function((k + 0.5) * end / steps);
  return sum * end / steps;
}

TEST_P(Steuermann, TheClosedFormsAreSneddonsIntegrals) {
  // With g(x) = x int_0^x f'(r)/sqrt(x^2 - r^2) dr (r = x sin t): approach g(a), force 2 E* int_0^a
  // (g(a) - g(x)) dx, pressure E*/pi int_r^a g'(x)/sqrt(x^2 - r^2) dx (x^2 = r^2 + u^2).
  const int n = GetParam();
  const Closed exact = closed_form(n);
  const auto slope = [n](double r) {
    return 2 * n * steepness / half_width * std::pow(r / half_width, 2 * n - 1);
  };
  const auto g = [&](double x) {
    return x * integral(M_PI / 2.0, [&](double t) { return slope(x * std::sin(t)); });
  };
  EXPECT_NEAR(g(half_width) / exact.approach, 1.0, 1e-5);
  const double middle = g(half_width);
  const double force =
      2.0 * contact_modulus * integral(half_width, [&](double x) { return middle - g(x); });
  EXPECT_NEAR(force / exact.force, 1.0, 1e-5);
  const auto pressure = [&](double r) {
    const double step = 1e-4 * half_width;
    return contact_modulus / M_PI *
           integral(std::sqrt(half_width * half_width - r * r), [&](double u) {
             const double x = std::hypot(r, u);
             return (g(x + step) - g(x - step)) / (2.0 * step * x);
           });
  };
  EXPECT_NEAR(pressure(0.0) / exact.middle, 1.0, 1e-5);
  const double r2 = n == 2 ? 0.5 : (1.0 + std::sqrt(3.0)) / 4.0;
  EXPECT_NEAR(pressure(half_width * std::sqrt(r2)) / exact.largest, 1.0, 1e-5);
}

TEST_P(Steuermann, ApproachAndPressureConvergeToTheClosedFormWithOrderTwo) {
  const int n = GetParam();
  const Errors coarse = errors(n, 81);
  const Errors fine = errors(n, 161);
  EXPECT_LT(std::abs(fine.approach), 2e-5);
  EXPECT_LT(std::abs(fine.largest), 2e-4);
  EXPECT_LT(std::abs(fine.middle), 1e-4);
  const auto order = [](double a, double b) {
    return std::log(std::abs(a / b)) / std::log(161.0 / 81.0);
  };
  EXPECT_NEAR(order(coarse.approach, fine.approach), 2.0, 0.2);
  EXPECT_NEAR(order(coarse.middle, fine.middle), 2.0, 0.2);
  // Where the pressure falls more steeply than Hertz's, its square is straight over less than the
  // three elements that the edge is found from: it is known to an element or so.
  EXPECT_LT(std::abs(coarse.radius), 1.25 * 2.0 / 81.0);
  EXPECT_LT(std::abs(fine.radius), 1.25 * 2.0 / 161.0);
  const std::string at = "_" + std::to_string(n);
  record("order_of_approach" + at, order(coarse.approach, fine.approach));
  record("order_of_middle" + at, order(coarse.middle, fine.middle));
}

INSTANTIATE_TEST_SUITE_P(Exponents, Steuermann, ::testing::Values(2, 3));

}  // namespace

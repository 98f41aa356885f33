// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/elasticity/influence.hpp"

#include "base/pi.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace rollfem::halfspace {

namespace {

using contact::pi;

/// Integrals over the rectangle of the five kernels that make up all coefficients.
struct Integrals {
  double xx_r3 = 0.0;  ///< X^2 / R^3
  double yy_r3 = 0.0;  ///< Y^2 / R^3
  double xy_r3 = 0.0;  ///< X Y / R^3
  double x_r2 = 0.0;   ///< X / R^2
  double y_r2 = 0.0;   ///< Y / R^2
};

/// X asinh(Y / |X|): the mixed derivative is Y^2 / R^3. Equals X ln(Y + R) up to terms that cancel
/// in the corner sum, without the loss of digits of Y + R at negative Y.
double corner_log(double x, double y) {
  return x == 0.0 ? 0.0 : x * std::asinh(y / std::abs(x));
}

/// Y ln R + X atan(Y / X): the mixed derivative is X / R^2.
double corner_atan(double x, double y) {
  const double logarithm = y == 0.0 ? 0.0 : y * std::log(std::hypot(x, y));
  const double angle = x == 0.0 ? 0.0 : x * std::atan(y / x);
  return logarithm + angle;
}

template <class Function>
double corner_sum(double x0, double x1, double y0, double y1, Function&& f) {
  return (f(x1, y1) - f(x0, y1)) - (f(x1, y0) - f(x0, y0));
}

/// The last two kernels only where they count.
Integrals closed_form(double x, double y, double dx, double dy, bool coupled) {
  const double x0 = x - 0.5 * dx;
  const double x1 = x + 0.5 * dx;
  const double y0 = y - 0.5 * dy;
  const double y1 = y + 0.5 * dy;
  const auto swapped = [](auto f) { return [f](double a, double b) { return f(b, a); }; };
  Integrals sum;
  sum.yy_r3 = corner_sum(x0, x1, y0, y1, corner_log);
  sum.xx_r3 = corner_sum(x0, x1, y0, y1, swapped(corner_log));
  sum.xy_r3 = -corner_sum(x0, x1, y0, y1, [](double a, double b) { return std::hypot(a, b); });
  if (!coupled) return sum;
  sum.x_r2 = corner_sum(x0, x1, y0, y1, corner_atan);
  sum.y_r2 = corner_sum(x0, x1, y0, y1, swapped(corner_atan));
  return sum;
}

void add_kernels(double x, double y, double weight, Integrals& sum) {
  const double r2 = x * x + y * y;
  const double w2 = weight / r2;
  const double w3 = w2 / std::sqrt(r2);
  sum.xx_r3 += w3 * x * x;
  sum.yy_r3 += w3 * y * y;
  sum.xy_r3 += w3 * x * y;
  sum.x_r2 += w2 * x;
  sum.y_r2 += w2 * y;
}

/// Gauss-Legendre product rule on the rectangle.
template <std::size_t n>
Integrals quadrature(double x, double y, double dx, double dy,
                     const std::array<double, n>& abscissae, const std::array<double, n>& weights) {
  Integrals sum;
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i)
      add_kernels(x + 0.5 * dx * abscissae[i], y + 0.5 * dy * abscissae[j],
                  0.25 * dx * dy * weights[i] * weights[j], sum);
  return sum;
}

// Points and weights on [-1, 1] (Abramowitz & Stegun, table 25.4).
constexpr std::array<double, 3> points_3{-0.7745966692414834, 0.0, 0.7745966692414834};
constexpr std::array<double, 3> weights_3{0.5555555555555556, 0.8888888888888888,
                                          0.5555555555555556};
constexpr std::array<double, 5> points_5{-0.9061798459386640, -0.5384693101056831, 0.0,
                                         0.5384693101056831, 0.9061798459386640};
constexpr std::array<double, 5> weights_5{0.2369268850561891, 0.4786286704993665,
                                          0.5688888888888889, 0.4786286704993665,
                                          0.2369268850561891};

/// n points converge as (2 d)^(-2n) with the distance d in half sides: 1e-14 for both rules where
/// they are used. The corner functions lose (R / side)^2 of the machine precision.
Integrals integrals(double x, double y, double dx, double dy, bool coupled) {
  const double half_sides = std::hypot(x, y) / (0.5 * std::max(dx, dy));
  if (half_sides < 14.0) return closed_form(x, y, dx, dy, coupled);
  if (half_sides < 110.0) return quadrature(x, y, dx, dy, points_5, weights_5);
  return quadrature(x, y, dx, dy, points_3, weights_3);
}

Influence combine(const Integrals& sum, const contact::CombinedMaterial& material) {
  const double scale = 1.0 / (pi * material.shear_modulus);
  const double nu = material.poisson_ratio;
  Influence result;
  result.xx = scale * (sum.xx_r3 + (1.0 - nu) * sum.yy_r3);
  result.yy = scale * (sum.yy_r3 + (1.0 - nu) * sum.xx_r3);
  result.xy = scale * nu * sum.xy_r3;
  result.nn = scale * (1.0 - nu) * (sum.xx_r3 + sum.yy_r3);
  result.xn = -scale * material.difference * sum.x_r2;
  result.yn = -scale * material.difference * sum.y_r2;
  return result;
}

}  // namespace

Influence rectangle_influence(double x, double y, double dx, double dy,
                              const contact::CombinedMaterial& material) {
  return combine(integrals(x, y, dx, dy, material.difference != 0.0), material);
}

Influence line_influence(double x, double dx, double reference,
                         const contact::CombinedMaterial& material, bool finite) {
  const double x0 = x - 0.5 * dx;
  const double x1 = x + 0.5 * dx;
  // Integral of -ln|s / reference| from 0 to s.
  const auto logarithm = [&](double s) {
    return s == 0.0 ? 0.0 : s - s * std::log(std::abs(s) / reference);
  };
  const double scale = 2.0 / (pi * material.shear_modulus);
  const double integral = logarithm(x1) - logarithm(x0);
  Influence result;
  result.xx = result.nn = scale * (1.0 - material.poisson_ratio) * integral;
  result.yy = scale * integral;  // antiplane shear
  if (finite) {
    result.xx += scale * material.poisson_ratio * dx;
    result.yy -= scale * material.poisson_ratio * dx;
  }
  result.xn = -material.difference / material.shear_modulus * (std::abs(x1) - std::abs(x0));
  return result;
}

Influence element_influence(const contact::ContactGrid& grid, int i, int j,
                            const contact::CombinedMaterial& material) {
  const bool finite = std::isinf(grid.line_reference);
  if (grid.is_line())
    return line_influence(i * grid.dx, grid.dx, finite ? grid.dy : grid.line_reference, material,
                          finite);
  return rectangle_influence(i * grid.dx, j * grid.dy, grid.dx, grid.dy, material);
}

namespace {

class RowDeflection {
 public:
  RowDeflection() {
    for (std::size_t k = 0; k < table_.size(); ++k)
      table_[k] = integral(std::exp(first_ + step_ * static_cast<double>(k)));
  }

  double operator()(double t) const {
    const double most = static_cast<double>(table_.size() - 1) - 1e-9;
    const double place = std::clamp((std::log(t) - first_) / step_, 0.0, most);
    const auto k = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(k);
    return (1.0 - share) * table_[k] + share * table_[k + 1];
  }

 private:
  static double integral(double t) {
    constexpr int points = 400;
    // u = t sinh(v) with v evenly spaced: resolves both the peak at 0 and the tails.
    const double end = std::asinh(1.0 / t);
    const double ratio = std::exp(end / points);
    double power = std::exp(0.5 * end / points);  // e^v
    double sum = 0.0;
    for (int k = 0; k < points; ++k, power *= ratio) {
      const double u = 0.5 * t * (power - 1.0 / power);
      sum += std::sqrt(std::max(0.0, 1.0 - u * u));
    }
    return 2.0 * end * sum / points;
  }

  static constexpr double first_ = -9.0;  ///< ln t
  static constexpr double step_ = 0.05;
  std::array<double, 321> table_{};
};

}  // namespace

double row_deflection(double t) {
  static const RowDeflection deflection;
  return deflection(t);
}

}  // namespace rollfem::halfspace

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/stress/shakedown.hpp"

#include "contact/base/pi.hpp"
#include "contact/result/stress_measures.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::postprocess {
namespace {

using contact::pi;
using contact::Stress;

constexpr double poisson_ratio = 0.3;

/// Largest von Mises stress and |xz| of a field, over p0.
struct Largest {
  double von_mises = 0.0;
  double shear = 0.0;
  void take(const Stress& stress) {
    von_mises = std::max(von_mises, contact::von_mises(stress));
    shear = std::max(shear, std::abs(stress.xz));
  }
  ShakedownLimits limits() const { return {std::sqrt(3.0) / von_mises, 1.0 / shear}; }
};

/// Stress of a line contact of half-width 1 and p0 = 1 under pressure and friction, plane strain; x
/// along sliding, z > 0 into the material.
Stress line_field(double x, double z, double friction) {
  const double half = 1.0 - x * x + z * z;
  const double root = std::hypot(half, 2.0 * x * z);
  const double m = std::sqrt(0.5 * (root + half));
  const double n = std::copysign(std::sqrt(std::max(0.0, 0.5 * (root - half))), x);
  const double square = m * m + n * n;
  const double ratio = (z * z + n * n) / square;
  const double xx = 2.0 * z - m * (1.0 + ratio);
  const double zz = -m * (1.0 - ratio);
  const double xz = -n * (m * m - z * z) / square;
  const double xx_of_friction = n * (2.0 - (z * z - m * m) / square) - 2.0 * x;
  Stress stress;
  stress.xx = xx + friction * xx_of_friction;
  stress.zz = zz + friction * xz;
  stress.xz = xz + friction * xx;
  stress.yy = poisson_ratio * (stress.xx + stress.zz);
  return stress;
}

/// Largest subsurface stresses of the circle over p0, at friction 0, 0.05, ... 0.35; with more
/// friction the largest ones are at the surface. verification/shakedown.cpp recomputes them.
struct BelowSurface {
  double von_mises;
  double shear;
};
constexpr double step = 0.05;
constexpr BelowSurface below[] = {{0.62000, 0.21386}, {0.62110, 0.22788}, {0.62443, 0.24217},
                                  {0.62991, 0.25670}, {0.63761, 0.27145}, {0.64753, 0.28642},
                                  {0.65973, 0.30160}, {0.67416, 0.31695}};

BelowSurface below_surface(double friction) {
  constexpr int last = static_cast<int>(std::size(below)) - 1;
  const double at = std::min(friction / step, static_cast<double>(last));
  const int k = std::min(static_cast<int>(at), last - 1);
  const double share = at - k;
  return {(1.0 - share) * below[k].von_mises + share * below[k + 1].von_mises,
          (1.0 - share) * below[k].shear + share * below[k + 1].shear};
}

constexpr int half = 24;  ///< places to each side of a line along rolling

constexpr std::size_t nodes = 24;
using Gauss = boost::math::quadrature::gauss<double, static_cast<unsigned>(nodes)>;

/// Calls visit(place, weight) at the Gauss points of an interval; boost stores the positive half.
template <class Visit>
void each_gauss_point(double from, double to, const Visit& visit) {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  for (std::size_t k = 0; k < nodes / 2; ++k)
    for (const double side : {half, -half})
      visit(middle + side * Gauss::abscissa()[k], half * Gauss::weights()[k]);
}

Stress sum(const Stress& one, double factor, const Stress& other) {
  auto values = one.as_array();
  const auto more = other.as_array();
  for (std::size_t c = 0; c < values.size(); ++c) values[c] += factor * more[c];
  return Stress::from_array(values);
}

/// Adds the stress that point loads `weight` at (-x, -y) and (-x, y) cause at (0, 0, z), along z
/// and along x (Boussinesq and Cerruti; Johnson 1985, sections 3.2 and 3.6).
void add_pair(double x, double y, double z, double weight, std::array<Stress, 2>& sum) {
  auto& [pressed, rubbed] = sum;
  constexpr double a = 1.0 - 2.0 * poisson_ratio;
  const double r = std::sqrt(x * x + y * y + z * z), s = 1.0 / (r + z);
  const double part = weight / pi, c = 3.0 / (r * r * r * r * r);
  const double flat = a * (z / (r * r) - s) / r, bent = a * (2.0 * r + z) * s * s / (r * r * r);
  pressed.xx += part * (flat + x * x * (bent - c * z));
  pressed.yy += part * (flat + y * y * (bent - c * z));
  pressed.zz -= part * c * z * z * z;
  pressed.xz -= part * c * x * z * z;
  const double even = a / (r * r * r), odd = a * s * s / r;
  const double curl = odd * (1.0 / (r * r) + 2.0 * s / r);
  rubbed.xx += part * x * (even - 3.0 * odd + x * x * (curl - c));
  rubbed.yy += part * x * (even - odd + y * y * (curl - c));
  rubbed.zz -= part * c * x * z * z;
  rubbed.xz -= part * c * x * x * z;
}

/// Stress in an ellipse with semi-axes 1 and `ratio` at (x, 0, z). Integration points are the sinh
/// of even ones about the field point, to be dense where the point load is steep.
std::array<Stress, 2> loaded_at(double x, double z, double ratio) {
  std::array<Stress, 2> sum;
  each_gauss_point(std::asinh((-1.0 - x) / z), std::asinh((1.0 - x) / z), [&](double s, double ds) {
    const double away = -z * std::sinh(s);  // distance from the load to the field point
    const double place = x - away;
    const double rest = std::max(0.0, 1.0 - place * place);
    const double near = std::hypot(z, away), end = std::asinh(ratio * std::sqrt(rest) / near);
    each_gauss_point(0.0, end, [&](double t, double dt) {
      const double y = near * std::sinh(t);
      const double pressure = std::sqrt(std::max(0.0, rest - y * y / (ratio * ratio)));
      add_pair(away, y, z, ds * z * std::cosh(s) * dt * near * std::cosh(t) * pressure, sum);
    });
  });
  return sum;
}

}  // namespace

Stress sliding_circle_surface(double x, double friction) {
  const double c = std::sqrt(1.0 - x * x);
  // (1 - c^3) / x^2 without cancellation at the centre.
  const double lift = (1.0 - 2.0 * poisson_ratio) / 3.0 * (1.0 + c + c * c) / (1.0 + c);
  Stress stress;
  stress.zz = -c;
  stress.xx = lift - c - friction * pi / 8.0 * (4.0 + poisson_ratio) * x;
  stress.yy = -lift - 2.0 * poisson_ratio * c - friction * pi / 8.0 * 3.0 * poisson_ratio * x;
  stress.xz = -friction * c;
  return stress;
}

ShakedownLimits line_contact_limits(double traction_coefficient) {
  Largest largest;
  // Depths start at the surface and are denser there; x avoids the edge, where the formula is 0/0.
  for (int j = 0; j <= 150; ++j) {
    const double z = 1.5 * std::pow(j / 150.0, 1.5);
    for (int i = -150; i <= 150; ++i)
      largest.take(line_field(0.00999 * i + 1e-6, z, traction_coefficient));
  }
  return largest.limits();
}

ShakedownLimits point_contact_limits(double traction_coefficient) {
  const BelowSurface deep = below_surface(traction_coefficient);
  Largest largest{deep.von_mises, deep.shear};
  for (int i = -1000; i <= 1000; ++i)
    largest.take(sliding_circle_surface(1e-3 * i, traction_coefficient));
  return largest.limits();
}

double yield_shear_stress(double yield_strength) {
  return yield_strength / std::sqrt(3.0);
}

double surface_fatigue_index(double traction_coefficient, double load_factor) {
  return traction_coefficient - 1.0 / load_factor;
}

std::string shakedown_region(const ShakedownLimits& limits, double load_factor) {
  if (load_factor <= std::min(limits.elastic, limits.shakedown)) return "elastic";
  return load_factor <= limits.shakedown ? "elastic shakedown" : "beyond shakedown";
}

EllipseStress::EllipseStress(double ratio)
    : ratio_(std::isinf(ratio) ? ratio : std::clamp(ratio, 0.1, 50.0)) {
  if (is_line()) return;
  for (int j = 1; j <= half; ++j)
    for (int i = -half; i <= half; ++i)
      stress_.push_back(loaded_at(0.05 * i, 0.05 * j * std::min(1.0, ratio_), ratio_));
}

double EllipseStress::shakedown_limit(double friction) const {
  if (is_line()) return line_contact_limits(friction).shakedown;
  double shear = friction;  // on the surface, xz is the traction
  double change = 0.0;
  for (std::size_t first = 0; first < stress_.size(); first += 2 * half + 1) {
    std::vector<Stress> instants{Stress{}};  // unloaded
    for (std::size_t k = first; k < first + 2 * half + 1; ++k) {
      const Stress now = sum(stress_[k][0], friction, stress_[k][1]);
      shear = std::max(shear, std::abs(now.xz));
      for (const Stress& before : instants)
        change = std::max(change, contact::von_mises(sum(now, -1.0, before)));
      instants.push_back(now);
    }
  }
  return std::min(1.0 / shear, 2.0 * std::sqrt(3.0) / change);
}

}  // namespace rollfem::postprocess

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/strip_theory.hpp"

#include "contact/base/pi.hpp"
#include "halfspace/closed_forms/kalker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollfem::theories {

using contact::pi;

StripTheory::StripTheory(const halfspace::HertzContact& ellipse,
                         const contact::CombinedMaterial& material, double bound,
                         const contact::Creepage& creepage, double y)
    : bound_(bound) {
  const double a = ellipse.semi_axis_x;
  const double b = ellipse.semi_axis_y;
  const double nu = material.poisson_ratio;
  const halfspace::KalkerCoefficients kalker = halfspace::kalker_coefficients(a, b, nu);
  half_length_ = a * std::sqrt(std::max(0.0, (1.0 - y / b) * (1.0 + y / b)));
  const double scale = material.shear_modulus / bound;
  // Strip theory by itself has C11 = pi^2/(4 (1 - nu)), C22 = pi^2/4, C23 = pi/3 sqrt(a/b).
  const double spin = 1.5 / pi * kalker.c23 * std::sqrt(b / a) * creepage.spin * scale;
  const double x =
      2.0 / (pi * pi) * kalker.c11 * creepage.longitudinal * scale - spin * y / (1.0 - nu);
  const double e = 2.0 / (pi * pi) * kalker.c22 * creepage.lateral * scale;
  across_ = spin;
  if (x == 0.0 && e == 0.0) {  // nothing moves but the spin, which the strip bears up to its bound
    if (std::abs(spin) >= 1.0) slip_ = std::numeric_limits<double>::infinity();
    return;
  }
  // k d = -x, l d = -e, and k^2 + (l - P)^2 = 1 at the end of adhesion.
  const double root = e * e + x * x * (1.0 - spin * spin);
  const double divisor = std::sqrt(std::max(0.0, root)) - e * spin;
  slip_ = root >= 0.0 && divisor > 0.0 ? (x * x + e * e) / divisor
                                       : std::numeric_limits<double>::infinity();
  if (slip_ >= half_length_) slip_ = std::numeric_limits<double>::infinity();
  k_ = -x / slip_;
  l_ = -e / slip_;
}

namespace {

/// Mean of sqrt(radius^2 - t^2) over t from `first` to `last`, 0 beyond the radius.
double mean_root(double radius, double first, double last) {
  const auto integral = [radius](double t) {
    const double u = std::clamp(t, -radius, radius);
    return 0.5 * (u * std::sqrt(radius * radius - u * u) + radius * radius * std::asin(u / radius));
  };
  return (integral(last) - integral(first)) / (last - first);
}

}  // namespace

StripTheory::Traction StripTheory::traction(double x, double step) const {
  const double first = x - 0.5 * step;
  const double last = x + 0.5 * step;
  const double whole = mean_root(half_length_, first, last);
  const double rest = whole - mean_root(half_length_ - slip_, first - slip_, last - slip_);
  return {bound_ * k_ * rest, bound_ * (l_ * rest - across_ * whole)};
}

}  // namespace rollfem::theories

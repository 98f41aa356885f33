// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/hertz_ellipse.hpp"

#include "base/pi.hpp"
#include "base/root.hpp"

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

#include <cmath>

namespace rollfem::contact {

using boost::math::ellint_rd;
using boost::math::ellint_rf;

namespace {

/// A/B as a function of ln k, which increases from 0 to infinity.
double log_curvature_ratio(double log_k) {
  const double k2 = std::exp(2.0 * log_k);
  return std::log(ellint_rd(0.0, k2, 1.0) / ellint_rd(0.0, 1.0, k2));
}

}  // namespace

HertzEllipse hertz_ellipse(double A, double B) {
  const double wanted = std::log(A / B);
  const auto f = [&](double log_k) { return log_curvature_ratio(log_k) - wanted; };
  // k = (A/B)^(2/3) is within a factor of 2 up to aspects of 1e4; widen until the root is inside.
  double low = wanted * 2.0 / 3.0 - 0.5;
  double high = wanted * 2.0 / 3.0 + 0.5;
  for (double step = 0.5; f(low) > 0.0; step *= 2.0) low -= step;
  for (double step = 0.5; f(high) < 0.0; step *= 2.0) high += step;
  const double k = std::exp(bracketed_root(f, low, high, 0.0, "Hertz's ellipse"));
  return {k, ellint_rd(0.0, k * k, 1.0), ellint_rf(0.0, k * k, 1.0)};
}

double hertz_force(const Geometry& geometry, const CombinedMaterial& material,
                   double max_pressure) {
  const auto [A, B] = relative_curvatures(geometry);
  const double slope = max_pressure / material.contact_modulus;
  if (geometry.line) return 0.5 * pi / A * slope * max_pressure * geometry.line->width;
  const HertzEllipse shape = hertz_ellipse(A, B);
  const double a = slope * shape.k * shape.rd / (3.0 * A);
  return 2.0 / 3.0 * pi * a * a * shape.k * max_pressure;
}

}  // namespace rollfem::contact

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/stress/ellipse_shear.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::postprocess {
namespace {

constexpr int nodes = 24;
using Gauss = boost::math::quadrature::gauss<double, nodes>;

/// Gauss points on -1 to 1 with their weights; boost stores only the positive half.
struct Rule {
  std::array<double, nodes> at{}, weight{};
  Rule() {
    for (int k = 0; k < nodes / 2; ++k)
      for (int side = 0; side < 2; ++side) {
        const auto i = static_cast<std::size_t>(2 * k + side);
        const auto j = static_cast<std::size_t>(k);
        at[i] = (side == 0 ? 1.0 : -1.0) * Gauss::abscissa()[j];
        weight[i] = Gauss::weights()[j];
      }
  }
};

struct Shear {
  double of_pressure = 0.0;
  double of_traction = 0.0;
};

/// Shear of an ellipse with semi-axes 1 and `ratio` at (x, 0, z). Integration points are the sinh
/// of even ones about the field point, to be dense where the point load is steep.
Shear shear_at(double x, double z, double ratio) {
  static const Rule rule;
  Shear sum;
  const double from = std::asinh((-1.0 - x) / z), to = std::asinh((1.0 - x) / z);
  for (int i = 0; i < nodes; ++i) {
    const double s = 0.5 * (to - from) * rule.at[static_cast<std::size_t>(i)] + 0.5 * (to + from);
    const double away = -z * std::sinh(s);  // distance from the load to the field point
    const double place = x - away;
    const double weight =
        0.5 * (to - from) * rule.weight[static_cast<std::size_t>(i)] * z * std::cosh(s);
    const double rest = std::max(0.0, 1.0 - place * place);
    const double near = std::hypot(z, away), end = std::asinh(ratio * std::sqrt(rest) / near);
    for (int j = 0; j < nodes; ++j) {
      const double t = 0.5 * end * (rule.at[static_cast<std::size_t>(j)] + 1.0);
      const double y = near * std::sinh(t);
      const double pressure = std::sqrt(std::max(0.0, rest - y * y / (ratio * ratio)));
      const double distance2 = near * near + y * y;
      // Factor 2 for both sides of y = 0.
      const double part = 2.0 * weight * 0.5 * end * rule.weight[static_cast<std::size_t>(j)] *
                          near * std::cosh(t) * 1.5 / M_PI * pressure /
                          (distance2 * distance2 * std::sqrt(distance2));
      sum.of_pressure += part * away * z * z;
      sum.of_traction += part * away * away * z;
    }
  }
  return sum;
}

}  // namespace

EllipseShear::EllipseShear(double ratio) : ratio_(std::clamp(ratio, 0.1, 50.0)) {
  const double deep = std::min(1.0, ratio_);
  for (int j = 1; j <= 24; ++j)
    for (int i = -24; i <= 24; ++i) {
      const Shear shear = shear_at(0.05 * i, 0.05 * j * deep, ratio_);
      of_pressure_.push_back(shear.of_pressure);
      of_traction_.push_back(shear.of_traction);
    }
}

double EllipseShear::largest(double friction) const {
  double found = friction;  // on the surface, xz is the traction
  for (std::size_t k = 0; k < of_pressure_.size(); ++k)
    found = std::max(found, std::abs(of_pressure_[k] + friction * of_traction_[k]));
  return found;
}

}  // namespace rollfem::postprocess

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/elasticity/row_deflection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace rollfem::halfspace {

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

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/iteration/interpolation.hpp"

#include <cmath>

namespace rollfem::contact {

Field interpolated(const ContactGrid& from, const Field& values, const ContactGrid& to,
                   const Field& weights) {
  const auto at = [&](double x, double y) {
    const double u = (x - from.x_first) / from.dx;
    const double v = (y - from.y_first) / from.dy;
    const int i = static_cast<int>(std::floor(u));
    const int j = static_cast<int>(std::floor(v));
    double sum = 0.0;
    double weight_sum = 0.0;
    for (int dj = 0; dj < 2; ++dj)
      for (int di = 0; di < 2; ++di) {
        const double share = (di == 1 ? u - i : 1.0 - u + i) * (dj == 1 ? v - j : 1.0 - v + j);
        const bool inside = i + di >= 0 && i + di < from.nx && j + dj >= 0 && j + dj < from.ny;
        const int k = inside ? from.index(i + di, j + dj) : 0;
        const double weight = weights.size() == 0 ? share : inside ? share * weights[k] : 0.0;
        weight_sum += weight;
        if (inside) sum += weight * values[k];
      }
    return weight_sum > 0.0 ? sum / weight_sum : 0.0;
  };
  return to.sample(at);
}

TangentialField relative_to_bound(const TangentialField& traction, const Field& bound) {
  const Field inverse = bound.unaryExpr([](double g) { return g > 0.0 ? 1.0 / g : 0.0; });
  return {traction.x.cwiseProduct(inverse), traction.y.cwiseProduct(inverse)};
}

TangentialField finer_tractions(const ContactGrid& coarse, const Field& pressure,
                                const TangentialField& relative, const ContactGrid& fine,
                                const Field& bound) {
  const Field inside = (pressure.array() > 0.0).cast<double>();
  return {interpolated(coarse, relative.x, fine, inside).cwiseProduct(bound),
          interpolated(coarse, relative.y, fine, inside).cwiseProduct(bound)};
}

}  // namespace rollfem::contact

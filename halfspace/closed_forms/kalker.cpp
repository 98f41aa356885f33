// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/closed_forms/kalker.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/pi.hpp"
#include "contact/iteration/interpolation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::halfspace {

namespace {

using contact::pi;

using Coefficient = double KalkerCoefficients::*;
constexpr std::array<Coefficient, 4> all_coefficients{
    &KalkerCoefficients::c11, &KalkerCoefficients::c22, &KalkerCoefficients::c23,
    &KalkerCoefficients::c33};

/// a/b from 0.01 to 100: ln C over ln(a/b) by six entries, (1 - nu) C over nu by all five, since
/// C11 and C33 of short patches grow as 1/(1 - nu).
KalkerCoefficients from_table(double ratio, double nu) {
  const KalkerTable& table = kalker_table();
  constexpr std::size_t used = 6;
  const auto above =
      std::upper_bound(table.begin(), table.end(), ratio,
                       [](double value, const KalkerEntry& entry) { return value < entry.ratio; });
  const auto first = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
      above - table.begin() - used / 2, 0, static_cast<std::ptrdiff_t>(table.size() - used)));
  std::array<double, used> logarithms;
  for (std::size_t k = 0; k < used; ++k) logarithms[k] = std::log(table[first + k].ratio);
  const auto in_ratio = contact::lagrange_weights(logarithms, std::log(ratio));
  const auto in_nu = contact::lagrange_weights(kalker_table_poisson, nu);
  KalkerCoefficients result;
  for (const Coefficient c : all_coefficients) {
    double logarithm = 0.0;
    for (std::size_t k = 0; k < used; ++k) {
      double value = 0.0;
      for (std::size_t m = 0; m < in_nu.size(); ++m)
        value += in_nu[m] * (1.0 - kalker_table_poisson[m]) * (table[first + k].row[m].*c);
      logarithm += in_ratio[k] * std::log(value);
    }
    result.*c = std::exp(logarithm) / (1.0 - nu);
  }
  return result;
}

/// a/b = ratio -> 0.
KalkerCoefficients asymptotes_short(double ratio, double nu) {
  KalkerCoefficients result;
  result.c11 = pi * pi / (4.0 * (1.0 - nu));
  result.c22 = pi * pi / 4.0;
  result.c23 =
      pi * std::sqrt(ratio) / (3.0 * (1.0 - nu)) * (1.0 + nu * (std::log(16.0 / ratio) - 5.0));
  result.c33 = pi * pi / (16.0 * (1.0 - nu) * ratio);
  return result;
}

/// b/a = ratio -> 0. Kalker's first terms 1/L (1 + n/L) as 1/(L - n), which is the same to that
/// order and ten times closer to the table at 0.01; C33 to its leading order, from the series of
/// benchmarks/kalker_table.py, with which it agrees within 1e-3 at 0.01 and 1e-4 at 0.001.
KalkerCoefficients asymptotes_long(double ratio, double nu) {
  const double logarithm = std::log(16.0 / (ratio * ratio));
  const double shortened = logarithm - 3.0 + std::log(4.0);
  const double turning = (1.0 - nu) * logarithm - 2.0 + 4.0 * nu;
  const double share = 1.0 - nu * (logarithm - 4.0) / turning;
  KalkerCoefficients result;
  result.c11 = 2.0 * pi / (ratio * (shortened - 2.0 * nu));
  result.c22 = 2.0 * pi / (ratio * ((1.0 - nu) * shortened + 2.0 * nu));
  result.c23 = 2.0 * pi / (3.0 * std::pow(ratio, 1.5) * turning);
  result.c33 = 0.25 * pi * share * share;
  return result;
}

void check_ellipse(double a, double b, double nu) {
  const bool sizes = a > 0.0 && b > 0.0 && std::isfinite(a) && std::isfinite(b);
  if (sizes && nu >= 0.0 && nu <= 0.5) return;
  throw contact::InputError(fmt::format(
      "Kalker's coefficients need positive semi-axes and a Poisson's ratio from 0 to 0.5; given "
      "a = {:g} mm, b = {:g} mm, nu = {:g}",
      a, b, nu));
}

}  // namespace

KalkerCoefficients kalker_coefficients(double semi_axis_x, double semi_axis_y,
                                       double poisson_ratio) {
  check_ellipse(semi_axis_x, semi_axis_y, poisson_ratio);
  const double ratio = semi_axis_x / semi_axis_y;
  const double last = kalker_table().back().ratio;
  const double slender = std::min(ratio, 1.0 / ratio) * last;
  if (slender >= 1.0) return from_table(ratio, poisson_ratio);
  const auto asymptotes = ratio < 1.0 ? asymptotes_short : asymptotes_long;
  const KalkerCoefficients join = from_table(ratio < 1.0 ? 1.0 / last : last, poisson_ratio);
  const KalkerCoefficients at_join = asymptotes(1.0 / last, poisson_ratio);
  KalkerCoefficients result = asymptotes(slender / last, poisson_ratio);
  for (const Coefficient c : all_coefficients)
    result.*c *= 1.0 + (join.*c / at_join.*c - 1.0) * slender * slender;
  return result;
}

CreepForces linear_creep_forces(double semi_axis_x, double semi_axis_y, double shear_modulus,
                                double poisson_ratio, const contact::Creepage& creepage) {
  const KalkerCoefficients k = kalker_coefficients(semi_axis_x, semi_axis_y, poisson_ratio);
  const double c = std::sqrt(semi_axis_x * semi_axis_y);
  const double scale = -shear_modulus * c * c;
  return {scale * k.c11 * creepage.longitudinal,
          scale * (k.c22 * creepage.lateral + c * k.c23 * creepage.spin),
          scale * c * (-k.c23 * creepage.lateral + c * k.c33 * creepage.spin)};
}

}  // namespace rollfem::halfspace

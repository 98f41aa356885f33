#include "halfspace/closed_forms/kalker.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/pi.hpp"
#include "halfspace/closed_forms/kalker_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::halfspace {

namespace {

using contact::pi;
constexpr double first_ratio = 0.1;

using Coefficient = double KalkerCoefficients::*;
constexpr std::array<Coefficient, 4> all_coefficients{
    &KalkerCoefficients::c11, &KalkerCoefficients::c22, &KalkerCoefficients::c23,
    &KalkerCoefficients::c33};

/// 1/C as the parabola through nu = 0, 1/4, 1/2.
double interpolate_in_nu(const KalkerRow& row, Coefficient c, double nu) {
  const double at_0 = 1.0 / (row[0].*c);
  const double at_quarter = 1.0 / (row[1].*c);
  const double at_half = 1.0 / (row[2].*c);
  return 1.0 / (at_0 * (1.0 - 4.0 * nu) * (1.0 - 2.0 * nu) +
                at_quarter * 8.0 * nu * (1.0 - 2.0 * nu) - at_half * 2.0 * nu * (1.0 - 4.0 * nu));
}

/// ratio from 0.1 to 1.
KalkerCoefficients from_table(const KalkerTable& table, double ratio, double nu) {
  const double position = (ratio - first_ratio) / 0.1;
  const int row = std::clamp(static_cast<int>(position), 0, 8);
  const double weight = position - row;
  KalkerCoefficients result;
  for (const Coefficient c : all_coefficients)
    result.*c = (1.0 - weight) * interpolate_in_nu(table[row], c, nu) +
                weight * interpolate_in_nu(table[row + 1], c, nu);
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

/// b/a = ratio -> 0.
KalkerCoefficients asymptotes_long(double ratio, double nu) {
  const double logarithm = std::log(16.0 / (ratio * ratio));
  const double numerator = 3.0 - std::log(4.0);
  const double along = logarithm - 2.0 * nu;
  const double across = (1.0 - nu) * logarithm + 2.0 * nu;
  const double turning = (1.0 - nu) * logarithm - 2.0 + 4.0 * nu;
  KalkerCoefficients result;
  result.c11 = 2.0 * pi / (along * ratio) * (1.0 + numerator / along);
  result.c22 = 2.0 * pi / (across * ratio) * (1.0 + (1.0 - nu) * numerator / across);
  result.c23 = 2.0 * pi / (3.0 * std::pow(ratio, 1.5) * turning);
  result.c33 = 0.25 * pi * (1.0 - nu * (logarithm - 2.0) / turning);
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
  const bool is_short = semi_axis_x < semi_axis_y;
  const double ratio = is_short ? semi_axis_x / semi_axis_y : semi_axis_y / semi_axis_x;
  const KalkerTable& table = is_short ? kalker_table_short() : kalker_table_long();
  if (ratio >= first_ratio) return from_table(table, ratio, poisson_ratio);
  const auto asymptotes = is_short ? asymptotes_short : asymptotes_long;
  const KalkerCoefficients join = from_table(table, first_ratio, poisson_ratio);
  const KalkerCoefficients at_join = asymptotes(first_ratio, poisson_ratio);
  KalkerCoefficients result = asymptotes(ratio, poisson_ratio);
  for (const Coefficient c : all_coefficients)
    result.*c *= 1.0 + (join.*c / at_join.*c - 1.0) * ratio / first_ratio;
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

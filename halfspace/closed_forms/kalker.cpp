#include "halfspace/closed_forms/kalker.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/pi.hpp"

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

// clang-format off
const KalkerTable& kalker_table_short() {
  //  C11, C22, C23, C33 at nu = 0, 0.25, 0.5; a/b = 0.1 to 1
  static const KalkerTable table{{
    {{{2.51, 2.51, 0.334, 6.42}, {3.31, 2.52, 0.473, 8.28}, {4.85, 2.53, 0.731, 11.7}}},
    {{{2.59, 2.59, 0.483, 3.46}, {3.37, 2.63, 0.603, 4.27}, {4.81, 2.66, 0.809, 5.66}}},
    {{{2.68, 2.68, 0.607, 2.49}, {3.44, 2.75, 0.715, 2.96}, {4.8, 2.81, 0.889, 3.72}}},
    {{{2.78, 2.78, 0.72, 2.02}, {3.53, 2.88, 0.823, 2.32}, {4.82, 2.98, 0.977, 2.77}}},
    {{{2.88, 2.88, 0.827, 1.74}, {3.62, 3.01, 0.929, 1.93}, {4.83, 3.14, 1.07, 2.22}}},
    {{{2.98, 2.98, 0.93, 1.56}, {3.72, 3.14, 1.03, 1.68}, {4.91, 3.31, 1.18, 1.86}}},
    {{{3.09, 3.09, 1.03, 1.43}, {3.81, 3.28, 1.14, 1.5}, {4.97, 3.48, 1.29, 1.6}}},
    {{{3.19, 3.19, 1.13, 1.34}, {3.91, 3.41, 1.25, 1.37}, {5.05, 3.65, 1.4, 1.42}}},
    {{{3.29, 3.29, 1.23, 1.27}, {4.01, 3.54, 1.36, 1.27}, {5.12, 3.82, 1.51, 1.27}}},
    {{{3.4, 3.4, 1.33, 1.21}, {4.12, 3.67, 1.47, 1.19}, {5.2, 3.98, 1.63, 1.16}}},
  }};
  return table;
}

const KalkerTable& kalker_table_long() {
  //  b/a = 0.1 to 1
  static const KalkerTable table{{
    {{{10.7, 10.7, 12.2, 0.795}, {11.7, 12.8, 14.6, 0.526}, {12.9, 16.0, 18.0, 0.228}}},
    {{{6.96, 6.96, 5.72, 0.828}, {7.78, 8.14, 6.63, 0.601}, {8.82, 9.79, 7.89, 0.341}}},
    {{{5.57, 5.57, 3.79, 0.868}, {6.34, 6.4, 4.32, 0.674}, {7.34, 7.51, 5.01, 0.446}}},
    {{{4.84, 4.84, 2.88, 0.912}, {5.57, 5.48, 3.24, 0.747}, {6.57, 6.31, 3.7, 0.549}}},
    {{{4.37, 4.37, 2.35, 0.958}, {5.1, 4.9, 2.62, 0.819}, {6.11, 5.56, 2.96, 0.65}}},
    {{{4.06, 4.06, 2.01, 1.01}, {4.78, 4.5, 2.23, 0.892}, {5.8, 5.04, 2.5, 0.751}}},
    {{{3.82, 3.82, 1.76, 1.05}, {4.54, 4.21, 1.95, 0.965}, {5.58, 4.67, 2.18, 0.852}}},
    {{{3.65, 3.65, 1.58, 1.1}, {4.36, 3.99, 1.75, 1.04}, {5.42, 4.39, 1.94, 0.954}}},
    {{{3.51, 3.51, 1.44, 1.16}, {4.22, 3.81, 1.59, 1.11}, {5.3, 4.16, 1.77, 1.06}}},
    {{{3.4, 3.4, 1.33, 1.21}, {4.12, 3.67, 1.47, 1.19}, {5.2, 3.98, 1.63, 1.16}}},
  }};
  return table;
}
// clang-format on

}  // namespace rollfem::halfspace

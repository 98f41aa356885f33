// SPDX-License-Identifier: LGPL-2.1-or-later
// Kalker's printed table of creepage coefficients with three digits (Kalker 1967; 1990, table E.3),
// and CONTACT's interpolation: 1/C quadratic in nu, C linear in the ratio of the semi-axes.
#pragma once

#include "halfspace/closed_forms/kalker.hpp"
#include "theories/brush.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

/// C11, C22, C23, C33. C11, C22 and C23 are those of two public codes, which agree on all 180; C33
/// lies within 0.9 % of the series of benchmarks/kalker_table.py (the others within 1.2 %).
using PrintedCoefficients = std::array<double, 4>;
/// At nu = 0, 1/4, 1/2.
using PrintedRow = std::array<PrintedCoefficients, 3>;

// clang-format off
/// a/b = 0.1, 0.2, ... 1.
inline constexpr std::array<PrintedRow, 10> printed_short{{
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
/// b/a = 0.1, 0.2, ... 1.
inline constexpr std::array<PrintedRow, 10> printed_long{{
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
// clang-format on

/// From a ratio of 0.1 to 1 of the smaller semi-axis to the larger.
inline PrintedCoefficients printed_coefficients(double a, double b, double nu) {
  const auto& table = a < b ? printed_short : printed_long;
  const double place = 10.0 * std::min(a / b, b / a) - 1.0;
  const int row = std::clamp(static_cast<int>(place), 0, 8);
  const auto in_nu = [&](int k, std::size_t c) {
    return 1.0 / ((1.0 - 4.0 * nu) * (1.0 - 2.0 * nu) / table[k][0][c] +
                  8.0 * nu * (1.0 - 2.0 * nu) / table[k][1][c] -
                  2.0 * nu * (1.0 - 4.0 * nu) / table[k][2][c]);
  };
  PrintedCoefficients result;
  for (std::size_t c = 0; c < 4; ++c)
    result[c] = (row + 1.0 - place) * in_nu(row, c) + (place - row) * in_nu(row + 1, c);
  return result;
}

/// The flexibilities that CONTACT gives its FASTSIM.
inline theories::BrushFlexibilities printed_flexibilities(double a, double b, double shear_modulus,
                                                          double nu) {
  const PrintedCoefficients k = printed_coefficients(a, b, nu);
  const double pi = std::acos(-1.0);
  return {8.0 * a / (3.0 * shear_modulus * k[0]), 8.0 * a / (3.0 * shear_modulus * k[1]),
          pi * a * a / (4.0 * shear_modulus * std::sqrt(a * b) * k[2])};
}

}  // namespace rollfem::testing

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/closed_forms/kalker.hpp"

#include "base/errors.hpp"
#include "base/pi.hpp"
#include "contact/iteration/interpolation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::halfspace {

namespace {

using contact::pi;

// The coefficients at 25 ratios and five Poisson's ratios, computed: benchmarks/kalker_table.py.

/// Poisson's ratios of a row.
constexpr std::array<double, 5> table_poisson{0.0, 0.125, 0.25, 0.375, 0.5};

struct KalkerEntry {
  double ratio;  ///< a/b
  std::array<KalkerCoefficients, 5> row;
};

/// By increasing a/b: 0.01, 0.02, 0.05, 0.1, 0.2, ... 1 and the reciprocals to 100; six digits,
/// five of them certain (four beyond 0.02 and 20).
// clang-format off
// a/b; C11, C22, C23, C33 at nu = 0, 1/8, 1/4, 3/8, 1/2
constexpr std::array<KalkerEntry, 25> kalker_table{{
    {0.01,
     {{{2.46838, 2.46838, 0.104743, 61.7525}, {2.82067, 2.46855, 0.155375, 70.5441},
       {3.29014, 2.46862, 0.222812, 82.2463}, {3.94689, 2.4685, 0.317063, 98.5914},
       {4.93092, 2.46806, 0.458052, 123.026}}}},
    {0.02,
     {{{2.47067, 2.47067, 0.148209, 30.9533}, {2.82259, 2.47126, 0.205397, 35.3284},
       {3.29109, 2.47158, 0.281421, 41.1358}, {3.94558, 2.47145, 0.387356, 49.2163},
       {4.92427, 2.47054, 0.545075, 61.2288}}}},
    {0.05,
     {{{2.48247, 2.48247, 0.23501, 12.5352}, {2.8328, 2.48523, 0.296535, 14.2491},
       {3.29734, 2.48722, 0.377707, 16.5016}, {3.9428, 2.48802, 0.489544, 19.5939},
       {4.90043, 2.48678, 0.653197, 24.1026}}}},
    {0.1,
     {{{2.51225, 2.51225, 0.334861, 6.4557}, {2.85944, 2.52032, 0.394218, 7.27384},
       {3.31638, 2.52711, 0.4714, 8.33189}, {3.9448, 2.53189, 0.575628, 9.7531},
       {4.86344, 2.53334, 0.723774, 11.7626}}}},
    {0.2,
     {{{2.59142, 2.59142, 0.483502, 3.4714}, {2.93262, 2.61272, 0.536187, 3.83606},
       {3.37509, 2.63257, 0.602692, 4.29535}, {3.97161, 2.65007, 0.689216, 4.89134},
       {4.81929, 2.66363, 0.80629, 5.69529}}}},
    {0.3,
     {{{2.68338, 2.68338, 0.606937, 2.50134}, {3.01973, 2.71901, 0.655428, 2.71281},
       {3.45022, 2.75374, 0.71492, 2.97403}, {4.02049, 2.78664, 0.789794, 3.30474},
       {4.81142, 2.81622, 0.88711, 3.73662}}}},
    {0.4,
     {{{2.78135, 2.78135, 0.71955, 2.02637}, {3.11401, 2.83146, 0.766269, 2.16034},
       {3.53485, 2.88161, 0.82211, 2.3235}, {4.08397, 2.93097, 0.890332, 2.52641},
       {4.8301, 2.97818, 0.975992, 2.78544}}}},
    {0.5,
     {{{2.88232, 2.88232, 0.826519, 1.74652}, {3.21222, 2.94675, 0.873306, 1.83338},
       {3.62534, 3.01241, 0.927978, 1.93813}, {4.15739, 3.07865, 0.99307, 2.06681},
       {4.8678, 3.14427, 1.07239, 2.22851}}}},
    {0.6,
     {{{2.98469, 2.98469, 0.93029, 1.56298}, {3.31261, 3.06317, 0.978541, 1.61798},
       {3.71956, 3.14429, 1.03389, 1.68396}, {4.23769, 3.22755, 1.0984, 1.76444},
       {4.91926, 3.31202, 1.17504, 1.8646}}}},
    {0.7,
     {{{3.0876, 3.0876, 1.0322, 1.43384}, {3.41414, 3.17983, 1.08299, 1.46572},
       {3.81615, 3.27624, 1.14045, 1.50403}, {4.32288, 3.37657, 1.20628, 1.55079},
       {4.98085, 3.48015, 1.2829, 1.60889}}}},
    {0.8,
     {{{3.19053, 3.19053, 1.13303, 1.33836}, {3.51619, 3.29622, 1.18724, 1.35259},
       {3.91426, 3.40775, 1.24793, 1.37011}, {4.41156, 3.5251, 1.31656, 1.39196},
       {5.05, 3.64795, 1.39519, 1.41966}}}},
    {0.9,
     {{{3.29316, 3.29316, 1.2333, 1.26508}, {3.61835, 3.41203, 1.29163, 1.26535},
       {4.01328, 3.53849, 1.35646, 1.26663}, {4.50276, 3.67281, 1.42911, 1.26933},
       {5.12489, 3.81502, 1.51136, 1.27407}}}},
    {1,
     {{{3.3953, 3.3953, 1.33333, 1.20722}, {3.72036, 3.5271, 1.39638, 1.1961},
       {4.11282, 3.66829, 1.46611, 1.1843}, {4.59578, 3.8195, 1.54377, 1.1718},
       {5.20417, 3.98114, 1.63096, 1.15863}}}},
    {1.11111111,
     {{{3.50809, 3.50809, 1.44448, 1.15582}, {3.83331, 3.65396, 1.51335, 1.13426},
       {4.22367, 3.81132, 1.58929, 1.11059}, {4.70065, 3.98117, 1.6735, 1.08447},
       {5.29621, 4.16444, 1.76748, 1.05552}}}},
    {1.25,
     {{{3.64789, 3.64789, 1.58373, 1.10519}, {3.97371, 3.81098, 1.66061, 1.07293},
       {4.36223, 3.98823, 1.74526, 1.03724}, {4.83321, 4.18122, 1.8389, 0.997545},
       {5.41561, 4.39156, 1.943, 0.953116}}}},
    {1.42857143,
     {{{3.82558, 3.82558, 1.76368, 1.05549}, {4.15267, 4.01025, 1.85186, 1.01221},
       {4.53983, 4.21264, 1.94901, 0.964296}, {5.00503, 4.43509, 2.05647, 0.910988},
       {5.57414, 4.68022, 2.17581, 0.85137}}}},
    {1.66666667,
     {{{4.05888, 4.05888, 2.00577, 1.00693}, {4.38831, 4.27147, 2.11047, 0.952205},
       {4.77498, 4.50664, 2.22616, 0.891753}, {5.235, 4.76789, 2.35449, 0.82473},
       {5.79106, 5.05933, 2.49739, 0.750165}}}},
    {2,
     {{{4.37875, 4.37875, 2.34959, 0.959831}, {4.71235, 4.62908, 2.47964, 0.893072},
       {5.10014, 4.90894, 2.6242, 0.819614}, {5.55628, 5.2236, 2.7856, 0.738631},
       {6.10031, 5.57958, 2.96658, 0.649289}}}},
    {2.5,
     {{{4.84505, 4.84505, 2.87695, 0.914654}, {5.18608, 5.1496, 3.04885, 0.835023},
       {5.57806, 5.49427, 3.24174, 0.747827}, {6.03314, 5.88732, 3.4594, 0.652405},
       {6.56767, 6.33931, 3.70647, 0.548328}}}},
    {3.33333333,
     {{{5.59166, 5.59166, 3.78729, 0.87221}, {5.94669, 5.98183, 4.03672, 0.778433},
       {6.3493, 6.4299, 4.32039, 0.676293}, {6.80961, 6.9496, 4.64557, 0.565515},
       {7.34079, 7.55925, 5.02155, 0.446515}}}},
    {5,
     {{{6.99769, 6.99769, 5.71818, 0.833802}, {7.38259, 7.54728, 6.14389, 0.72375},
       {7.81186, 8.19005, 6.63726, 0.604497}, {8.29358, 8.95171, 7.21547, 0.476533},
       {8.83784, 9.86829, 7.90194, 0.342002}}}},
    {10,
     {{{10.7994, 10.7994, 12.2345, 0.802219}, {11.2714, 11.7783, 13.3025, 0.671545},
       {11.7862, 12.9519, 14.5742, 0.530414}, {12.3499, 14.3847, 16.1137, 0.380949},
       {12.9698, 16.1728, 18.0154, 0.229365}}}},
    {20,
     {{{17.4984, 17.4984, 27.6479, 0.790885}, {18.1228, 19.2404, 30.3319, 0.645851},
       {18.7932, 21.3672, 33.5928, 0.489137}, {19.5148, 24.0222, 37.6387, 0.324591},
       {20.2938, 27.4296, 42.7915, 0.163321}}}},
    {50,
     {{{34.8963, 34.8963, 86.1122, 0.786559}, {35.8893, 38.659, 95.256, 0.628616},
       {36.9402, 43.3308, 106.572, 0.457569}, {38.0544, 49.2866, 120.939, 0.279379},
       {39.2377, 57.1394, 139.783, 0.111878}}}},
    {100,
     {{{60.5015, 60.5015, 209.783, 0.785746}, {61.9907, 67.2969, 233.086, 0.620947},
       {63.5549, 75.8115, 262.213, 0.442182}, {65.1999, 86.7924, 299.658, 0.256816},
       {66.9321, 101.492, 349.58, 0.0875088}}}},
}};
// clang-format on

using Coefficient = double KalkerCoefficients::*;
constexpr std::array<Coefficient, 4> all_coefficients{
    &KalkerCoefficients::c11, &KalkerCoefficients::c22, &KalkerCoefficients::c23,
    &KalkerCoefficients::c33};

/// a/b from 0.01 to 100: ln C over ln(a/b) by six entries, (1 - nu) C over nu by all five, since
/// C11 and C33 of short patches grow as 1/(1 - nu).
KalkerCoefficients from_table(double ratio, double nu) {
  constexpr std::size_t used = 6;
  const auto above =
      std::upper_bound(kalker_table.begin(), kalker_table.end(), ratio,
                       [](double value, const KalkerEntry& entry) { return value < entry.ratio; });
  const auto first = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(above - kalker_table.begin() - used / 2, 0,
                                 static_cast<std::ptrdiff_t>(kalker_table.size() - used)));
  std::array<double, used> logarithms;
  for (std::size_t k = 0; k < used; ++k) logarithms[k] = std::log(kalker_table[first + k].ratio);
  const auto in_ratio = contact::lagrange_weights(logarithms, std::log(ratio));
  const auto in_nu = contact::lagrange_weights(table_poisson, nu);
  KalkerCoefficients result;
  for (const Coefficient c : all_coefficients) {
    double logarithm = 0.0;
    for (std::size_t k = 0; k < used; ++k) {
      double value = 0.0;
      for (std::size_t m = 0; m < in_nu.size(); ++m)
        value += in_nu[m] * (1.0 - table_poisson[m]) * (kalker_table[first + k].row[m].*c);
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
  const double last = kalker_table.back().ratio;
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

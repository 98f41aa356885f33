// SPDX-License-Identifier: LGPL-2.1-or-later
// The thesis's case a: exact Hertz, and what CONTACT (Vollebregt) has of it
// (shared/reference/contact_normal.csv, contact_tangential.csv, contact_subsurface_a.csv).
#pragma once

#include "support/test.hpp"

namespace rollfem::testing::case_a {

inline constexpr double p0 = 578.967, semi_axis_x = 3.79236, semi_axis_y = 10.87295;

/// -F_x/F_z, 80 and 160 across extrapolated with order 1, +-5e-4.
inline const std::vector<double> creepages{0.0005, 0.001, 0.002, 0.003, 0.004, 0.006};
inline const std::vector<double> coefficients{0.11542, 0.21565, 0.37221, 0.47467, 0.53016, 0.54952};

/// At a depth below the middle, without friction: displacement of the wheel, mm, and stresses, MPa.
struct Below {
  double z, uz, hydrostatic, von_mises, xx, yy, zz;
};
inline constexpr Below below[] = {
    {0.5, 2.2868e-2, -432.399, 214.689, -383.311, -340.510, -573.375},
    {1.0, 2.1976e-2, -372.545, 277.423, -276.966, -283.211, -557.459},
    {2.0, 2.0064e-2, -278.420, 341.384, -137.465, -194.151, -503.644},
    {3.0, 1.8190e-2, -211.630, 344.171, -64.6025, -132.593, -437.695},
    {4.0, 1.6481e-2, -164.219, 319.047, -28.1380, -90.6904, -373.829},
    {6.0, 1.3655e-2, -104.920, 251.454, -1.13786, -42.7999, -270.821},
    {8.0, 1.1514e-2, -71.5926, 193.498, 5.22582, -20.2541, -199.750},
    {12.0, 8.6137e-3, -38.4412, 118.350, 5.77334, -3.95558, -117.141}};

}  // namespace rollfem::testing::case_a

// SPDX-License-Identifier: LGPL-2.1-or-later
// The curvature of S1002. Other built-in profiles: tests/cli/test_standard_rails.py.
#include "profiles/formula_profiles.hpp"

#include "support/test.hpp"

namespace rollfem::profiles {
namespace {

TEST(S1002, HasTheCurvatureOfItsFormulas) {
  const ProfileCurve smooth = find_built_in_profile("S1002-smooth")->make();
  const ProfileCurve plain = find_built_in_profile("S1002")->make();
  const auto curvature = [](double y) {  // of the polynomials of zones B and C
    const double h = 0.02;
    const double second =
        (s1002_height(y + h) - 2.0 * s1002_height(y) + s1002_height(y - h)) / (h * h);
    const double first = (s1002_height(y + h) - s1002_height(y - h)) / (2.0 * h);
    return second / std::pow(1.0 + first * first, 1.5);
  };
  double worst = 0.0, worst_smooth = 0.0, blended = 0.0;
  for (double y = -34.97; y < 32.1; y += 0.0137) {
    if (std::abs(y + 26.0) < 0.021) continue;
    const double true_value = curvature(y);
    const double off = std::abs(plain.at(plain.parameter_at(y)).curvature - true_value);
    const double off_smooth = std::abs(smooth.at(smooth.parameter_at(y)).curvature - true_value);
    worst_smooth = std::max(worst_smooth, off_smooth);
    if (y < -34.9)
      blended = std::max(blended, off / true_value);
    else if (std::abs(y + 26.05) >= 0.2)
      worst = std::max(worst, off);
  }
  EXPECT_LT(worst, 2e-6);
  EXPECT_LT(worst_smooth, 2e-5);
  EXPECT_LT(blended, 0.1);
}

}  // namespace
}  // namespace rollfem::profiles

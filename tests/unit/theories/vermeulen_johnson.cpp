// SPDX-License-Identifier: LGPL-2.1-or-later
// Vermeulen and Johnson's theory against benchmark 8 and its limits.
#include "halfspace/closed_forms/kalker.hpp"
#include "theories/closed_forms.hpp"

#include "support/test.hpp"

namespace rollfem::theories {

using namespace halfspace;
TEST(VermeulenJohnson, GivesTheBenchmark) {
  // a = b = 6, G = 82000, nu = 0.25, N = 82000, mu = 0.3: tau = 120 C11 xi by hand, C11 = 4.11282.
  const double xi[] = {1e-4, 5e-4, 1e-3, 2e-3, 3e-3};
  const double saturation[] = {0.04855, 0.22703, 0.41680, 0.69792, 0.87009};
  for (int k = 0; k < 5; ++k)
    EXPECT_NEAR(vermeulen_johnson(6, 6, 82000, 0.25, 24600, {xi[k], 0, 0}).saturation,
                saturation[k], 6e-6);
}

TEST(VermeulenJohnson, TendsToTheLinearTheoryAndToFullSlip) {
  const CreepForces linear = linear_creep_forces(6, 4, 82000, 0.3, {2e-9, -1e-9, 0});
  const VermeulenJohnson small = vermeulen_johnson(6, 4, 82000, 0.3, 24600, {2e-9, -1e-9, 0});
  EXPECT_NEAR(24600 * small.saturation * small.direction_x / linear.longitudinal, 1.0, 1e-6);
  EXPECT_NEAR(24600 * small.saturation * small.direction_y / linear.lateral, 1.0, 1e-6);
  const VermeulenJohnson large = vermeulen_johnson(6, 4, 82000, 0.3, 24600, {0.5, 0, 0});
  EXPECT_EQ(large.saturation, 1.0);
  EXPECT_EQ(large.stick_ratio, 0.0);
}

}  // namespace rollfem::theories

// SPDX-License-Identifier: LGPL-2.1-or-later
// Rayleigh's wave speed against the ratios to the shear wave speed that have a closed form.
#include "base/material.hpp"

#include "support/test.hpp"

namespace {

double ratio(double poisson_ratio) {
  const contact::Material material{210e3, poisson_ratio, 7.85e-9};
  return contact::rayleigh_speed(material) /
         std::sqrt(contact::shear_modulus(material) / material.density);
}

TEST(RayleighSpeed, HasTheKnownRatiosToTheShearWaveSpeed) {
  EXPECT_NEAR(ratio(0.0), std::sqrt(3.0 - std::sqrt(5.0)), 1e-12);
  EXPECT_NEAR(ratio(0.25), std::sqrt(2.0 - 2.0 / std::sqrt(3.0)), 1e-12);
  EXPECT_NEAR(ratio(0.5), 0.95531, 1e-5);  // e^3 - 8 e^2 + 24 e - 16 = 0
}

// The root satisfies (2 - e)^2 = 4 sqrt((1 - e)(1 - k e)), the equation before squaring.
TEST(RayleighSpeed, LeavesTheSurfaceFreeOfTraction) {
  for (const double nu : {0.0, 0.1, 0.3, 0.45, 0.4999}) {
    const double e = std::pow(ratio(nu), 2), k = (1 - 2 * nu) / (2 * (1 - nu));
    EXPECT_NEAR((2 - e) * (2 - e), 4 * std::sqrt((1 - e) * (1 - k * e)), 1e-12) << nu;
  }
}

TEST(RayleighSpeed, IsInfiniteWithoutMass) {
  EXPECT_TRUE(std::isinf(contact::rayleigh_speed({210e3, 0.3, 0.0})));
  EXPECT_TRUE(
      std::isinf(contact::rayleigh_speed({std::numeric_limits<double>::infinity(), 0.3, 7.85e-9})));
}

}  // namespace

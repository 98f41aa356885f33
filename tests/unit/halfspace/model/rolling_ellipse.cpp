// SPDX-License-Identifier: LGPL-2.1-or-later
// An ellipse rolling at many creepages: each result equals a single solution (small creepage and
// full sliding: cli.filled_tables).
#include "halfspace/model/rolling_ellipse.hpp"

#include "base/errors.hpp"

#include "support/test.hpp"

namespace {

using halfspace::EllipseForces;
using halfspace::roll_ellipse;
using halfspace::ScaledCreepage;

/// Neighbours in turn, also where they go on to finer grids.
std::vector<ScaledCreepage> some_creepages() {
  std::vector<ScaledCreepage> creepages;
  for (int k = 0; k < 90; ++k) {
    const double s = 0.01 + 0.005 * k;
    creepages.push_back({s, 0.3 * s - 0.02, 0.2 - 0.004 * k});
  }
  return creepages;
}

TEST(RollingEllipse, IsEachCreepageAlone) {
  const std::vector<ScaledCreepage> creepages = some_creepages();
  for (const double ratio : {0.3, 1.0, 4.0}) {
    const auto together = roll_ellipse({ratio, 0.28}, creepages, {0.003, 40});
    ASSERT_EQ(together.size(), creepages.size());
    for (std::size_t k = 0; k < creepages.size(); k += 9) {
      const EllipseForces alone = roll_ellipse({ratio, 0.28}, {creepages[k]}, {0.003, 40})[0];
      EXPECT_EQ(together[k].elements_across, alone.elements_across) << k;
      EXPECT_NEAR(together[k].limit.longitudinal, alone.limit.longitudinal, 1e-10) << k;
      EXPECT_NEAR(together[k].limit.lateral, alone.limit.lateral, 1e-10) << k;
      EXPECT_NEAR(together[k].limit.spin_moment, alone.limit.spin_moment, 1e-10) << k;
    }
  }
}

TEST(RollingEllipse, RefusesWhatItCannotSolve) {
  EXPECT_THROW(roll_ellipse({0.0, 0.28}, {}), contact::InputError);
  EXPECT_THROW(roll_ellipse({1.0, 0.6}, {}), contact::InputError);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(roll_ellipse({1.0, 0.3}, {{0.0, nan, 0.0}}), contact::InputError);
  EXPECT_THROW(roll_ellipse({1.0, 0.3}, {}, {0.003, 10}), contact::InputError);
}

}  // namespace

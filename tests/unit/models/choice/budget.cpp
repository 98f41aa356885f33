// SPDX-License-Identifier: LGPL-2.1-or-later
// Sharing the time of a run without a requested accuracy among its scenes.
#include "models/choice/budget.hpp"

#include <gtest/gtest.h>

namespace {

using rollfem::modelling::Budget;
using rollfem::modelling::seconds_by_default;

TEST(Budget, GivesAllToAnOnlyScene) {
  EXPECT_DOUBLE_EQ(Budget({}).allowed(), seconds_by_default);
  EXPECT_DOUBLE_EQ(Budget({500.0}).allowed(), seconds_by_default);
}

TEST(Budget, KeepsWhatLaterScenesNeedButNoMoreThanTheirShares) {
  EXPECT_DOUBLE_EQ(Budget({1.0, 5.0, 7.0}).allowed(), 48.0);
  EXPECT_DOUBLE_EQ(Budget({1.0, 500.0, 7.0}).allowed(), 20.0);
}

TEST(Budget, CountsPredictionsThatHoldAsPredicted) {
  Budget budget({10.0, 10.0});
  EXPECT_DOUBLE_EQ(budget.spend(10.0, 25.0), 1.0);  // a busy machine makes no other choice
  EXPECT_DOUBLE_EQ(budget.spend(0.1, 1.9), 1.0);    // nor does a slow start
  budget.next();
  EXPECT_DOUBLE_EQ(budget.allowed(), 49.9);
}

TEST(Budget, CountsByTheClockWhatWasGrosslyMispredicted) {
  Budget budget({});
  EXPECT_DOUBLE_EQ(budget.spend(4.0, 40.0), 10.0);
  EXPECT_DOUBLE_EQ(budget.allowed(), 20.0);
  budget.spend(0.0, 50.0);  // nothing was predicted of what failed
  EXPECT_DOUBLE_EQ(budget.allowed(), 0.0);
}

TEST(Budget, TellsABusyMachineFromAWrongPrediction) {
  Budget budget({});
  EXPECT_DOUBLE_EQ(budget.spend(10.0, 20.0, 0.5), 1.0);
  EXPECT_DOUBLE_EQ(budget.times(), 2.0);
  EXPECT_DOUBLE_EQ(budget.allowed(), 50.0);  // the same choice as on a quiet one
  EXPECT_DOUBLE_EQ(budget.spend(4.0, 16.0, 0.25), 1.0);
  EXPECT_DOUBLE_EQ(budget.allowed(), (50.0 - 16.0) * 0.25);
  EXPECT_DOUBLE_EQ(budget.spend(1.0, 10.0, 0.4), 4.0);
  EXPECT_DOUBLE_EQ(budget.times(), 2.5);
}

TEST(Budget, AllowsASlowMachineLess) {
  Budget budget({0.0, 5.0}, 2.0);
  EXPECT_DOUBLE_EQ(budget.needed(), 10.0);
  EXPECT_DOUBLE_EQ(budget.allowed(), 25.0);
  EXPECT_DOUBLE_EQ(budget.spend(5.0, 10.0), 1.0);
  budget.next();
  EXPECT_DOUBLE_EQ(budget.allowed(), 25.0);
}

}  // namespace

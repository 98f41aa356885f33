// SPDX-License-Identifier: LGPL-2.1-or-later
// Errors of a result relative to the scale of each quantity.
#include "contact/result/reached.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace rollfem;
using contact::reached_by;

contact::ModelResult result() {
  contact::ModelResult made;
  contact::PointResult point;
  point.max_pressure = 500.0;
  point.semi_axis_x = 4.0;
  point.traction_coefficient = 0.02;
  point.error_estimate = {
      {"max_pressure", 1.0}, {"semi_axis_x", 0.02}, {"traction_coefficient", 0.001}};
  point.model_error = {{"max_pressure", 2.0}};
  made.points = {point, point};
  made.points[1].error_estimate["traction_coefficient"] = 0.003;
  made.points[1].model_error["traction_coefficient"] = 0.0015;
  return made;
}

TEST(Reached, IsTheWorstOfQuantitiesAndPointsByBothErrorsTogether) {
  const contact::AccuracyRequest all{0.01, {"max_pressure", "semi_axis_x", "traction_coefficient"}};
  const contact::Reached worst = reached_by(result(), all, 0.3, true);
  EXPECT_EQ(worst.quantity, "traction_coefficient");  // 1.5 % of mu; p0 0.6 %
  EXPECT_EQ(worst.point, 2);
  EXPECT_NEAR(worst.discretisation, 0.01, 1e-12);
  EXPECT_NEAR(worst.model, 0.005, 1e-12);
  EXPECT_EQ(worst.text(),
            "discretisation 1 %, model 0.5 % of mu (traction_coefficient at load point 2)");
  const contact::Reached pressure = reached_by(result(), {0.01, {"max_pressure"}}, 0.3, true);
  EXPECT_EQ(pressure.text(), "discretisation 0.2 %, model 0.4 % (max_pressure at load point 1)");
}

TEST(Reached, WhatIsMissingIsUnknownUnlessItIsExact) {
  contact::ModelResult made = result();
  const contact::AccuracyRequest axis{0.01, {"semi_axis_x"}};
  EXPECT_NEAR(reached_by(made, axis, 0.3, true).together(), 0.005, 1e-12);
  EXPECT_TRUE(std::isinf(reached_by(made, axis, 0.3, false).model));
  for (contact::PointResult& point : made.points) point.error_estimate.erase("semi_axis_x");
  EXPECT_TRUE(std::isinf(reached_by(made, axis, 0.3, true).discretisation));
  for (contact::PointResult& point : made.points) point.no_bar["semi_axis_x"] = "exact";
  EXPECT_EQ(reached_by(made, axis, 0.3, true).together(), 0.0);
}

}  // namespace

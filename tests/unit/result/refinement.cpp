// SPDX-License-Identifier: LGPL-2.1-or-later
// The error estimated from a sequence of levels, against sequences whose limit is known, and the
// load point that decides the accuracy of a case.
#include "result/refinement.hpp"

#include "support/temporary_folder.hpp"

namespace {

std::vector<double> sequence(double order, int levels) {
  std::vector<double> values;
  for (int i = 0; i < levels; ++i) values.push_back(3.0 + 0.1 * std::exp2(-order * i));
  return values;
}

double effectivity(const std::vector<double>& values, double limit) {
  return estimated_error(values, 1.5) / std::abs(values.back() - limit);
}

TEST(Refinement, IsExactForAPureOrderBetweenOneAndTwo) {
  for (const double order : {1.0, 1.3, 1.7, 2.0})
    EXPECT_NEAR(effectivity(sequence(order, 3), 3.0), 1.0, 1e-10) << order;
}

TEST(Refinement, OverestimatesWhatConvergesQuicker) {
  // Order 3: the change before, taken as if it fell by 4 only, is 2 changes; (8 - 1) 2 / (4 - 1).
  EXPECT_NEAR(effectivity(sequence(3.0, 3), 3.0), 14.0 / 3.0, 1e-9);
}

TEST(Refinement, UnderestimatesALowOrderByNoMoreThanItsShareOfOrderOne) {
  EXPECT_NEAR(effectivity(sequence(0.5, 3), 3.0), std::sqrt(2.0) - 1.0, 1e-9);
}

TEST(Refinement, TwoLevelsTakeTheAssumedOrder) {
  EXPECT_NEAR(effectivity(sequence(1.5, 2), 3.0), 1.0, 1e-10);
}

TEST(Refinement, TwoGridsThatAgreeByChanceAreNotBelieved) {
  EXPECT_NEAR(estimated_error({1.0, 1.4, 1.4}, 1.5), 0.025 / (std::exp2(1.5) - 1.0), 1e-12);
  EXPECT_NEAR(estimated_error({1.0, 1.4, 1.41}, 1.5), 0.1 / 3.0, 1e-12);
  EXPECT_GT(estimated_error({1.0, 1.4, 1.3}, 1.5), 0.05);
}

TEST(Refinement, ErrorsOfFrictionArePartsOfFullSliding) {
  const AccuracyRequest asked{{}, {"traction_coefficient", "max_pressure"}};
  constexpr double friction = 0.5;
  std::vector<PointResult> points(2);
  for (PointResult& point : points) point.max_pressure = 600.0;
  points[0].traction_coefficient = 0.002;
  points[0].error_estimate = {{"traction_coefficient", 0.004}, {"max_pressure", 3.0}};
  points[1].traction_coefficient = 0.4;
  points[1].error_estimate = {{"traction_coefficient", 0.008}, {"max_pressure", 1.5}};
  WorstError worst = worst_error(asked, friction, points);
  EXPECT_EQ(worst.point, 2);
  EXPECT_DOUBLE_EQ(worst.error, 0.016);
  EXPECT_EQ(worst.text(), "1.6 % of mu (traction_coefficient at load point 2)");
  points[1].error_estimate["traction_coefficient"] = 0.003;
  worst = worst_error(asked, friction, points);
  EXPECT_DOUBLE_EQ(worst.error, 0.008);
  EXPECT_EQ(worst.text(), "0.8 % of mu (traction_coefficient at load point 1)");
  points[1].error_estimate["max_pressure"] = 6.0;
  EXPECT_EQ(worst_error(asked, friction, points).text(), "1 % (max_pressure at load point 2)");
  EXPECT_TRUE(says(shortfall_text({0.001, asked.of}, worst, "do: request less"),
                   "the largest estimated error is 0.8 % of mu (traction_coefficient at load"));
}

/// Bars fall with order 1 from 0.08 of the pressure on 10 elements across.
PointResult on(int across) {
  PointResult point;
  point.max_pressure = 100.0;
  point.error_estimate["max_pressure"] = 80.0 / across;
  return point;
}

TEST(Ladder, IsClimbedUntilTheAccuracyIsReached) {
  ModelResult result;
  int across = 10;
  while (refine_further({0.011, {"max_pressure"}}, 0.5,
                        {std::to_string(across) + " across", "", true}, {on(across)}, result))
    across *= 2;
  EXPECT_EQ(across, 80);
  EXPECT_TRUE(result.shortfall.empty());
  EXPECT_EQ(
      result.note_about("accuracy")->text,
      "accuracy 0.011 requested: 80 across; largest estimated error 1 % (max_pressure at load "
      "point 1)");
}

TEST(Ladder, SaysSoWhereThereIsNoFinerLevel) {
  ModelResult result;
  EXPECT_FALSE(refine_further({0.001, {"max_pressure"}}, 0.5, {"40 across", "memory is full", true},
                              {on(40)}, result));
  EXPECT_TRUE(says(result.shortfall, "accuracy = 0.001 was not reached", "2 %", "memory is full"));
}

TEST(Ladder, TwoLevelsThatAgreeAreNotBelieved) {
  ModelResult result;
  EXPECT_TRUE(
      refine_further({0.1, {"max_pressure"}}, 0.5, {"20 across", "", false}, {on(20)}, result));
  EXPECT_FALSE(refine_further({0.1, {"max_pressure"}}, 0.5, {"20 across", "no memory", false},
                              {on(20)}, result));
  EXPECT_TRUE(says(result.shortfall, "no memory"));
}

TEST(Ladder, OfACaseWithoutAnAccuracyHasOneLevel) {
  ModelResult result;
  EXPECT_FALSE(refine_further({}, 0.5, {"20 across", "", true}, {on(20)}, result));
  EXPECT_TRUE(result.notes.empty());
}

}  // namespace

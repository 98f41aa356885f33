// SPDX-License-Identifier: LGPL-2.1-or-later
// The cheapest sufficient grid, and the update of forecasts by a solved grid.
#include "models/choice/forecast.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace rollfem::modelling;

Forecast model(const std::string& name, double model_error, double seconds) {
  Forecast forecast;
  forecast.model = forecast.label = name;
  forecast.model_error = model_error;
  for (const int across : {10, 20, 40})
    forecast.levels.push_back({across, 0.1 / across, seconds * across});
  return forecast;
}

TEST(Forecast, BothErrorsTogetherMustDo) {
  const std::vector<Forecast> all{model("plain", 0.004, 1.0), model("fine", 0.0, 100.0)};
  const auto plan = cheapest(all, 0.01);  // 0.004 + 0.1 / 20 <= 0.01 < 0.004 + 0.1 / 10
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->model, 0U);
  EXPECT_EQ(all[0].levels[plan->level].across, 20);
  const auto finer = cheapest(all, 0.003);
  ASSERT_TRUE(finer);
  EXPECT_EQ(finer->model, 1U);
  EXPECT_FALSE(cheapest(all, 0.002));
  EXPECT_DOUBLE_EQ(least_error(all), 0.0025);
}

TEST(Forecast, SecondsDecideBetweenModelsThatDo) {
  std::vector<Forecast> all{model("plain", 0.0074, 1.0), model("fine", 0.0, 1.5)};
  EXPECT_EQ(cheapest(all, 0.01)->model, 1U);  // 10 across of the one, 40 of the other
  all[1].cannot = "it cannot";
  EXPECT_EQ(cheapest(all, 0.01)->model, 0U);
  all[0].cannot = "nor can it";
  EXPECT_FALSE(cheapest(all, 1.0));
  EXPECT_TRUE(std::isinf(least_error(all)));
}

TEST(Forecast, ASolvedGridTellsOfThoseThatWereNot) {
  Forecast one = model("plain", 0.0, 1.0);
  one.once = 2.0;
  learn(one, 1, 0.08, 7.0);
  EXPECT_TRUE(one.levels[1].solved);
  EXPECT_DOUBLE_EQ(one.levels[1].seconds, 7.0);
  EXPECT_DOUBLE_EQ(one.levels[2].discretisation, 0.08 / std::pow(2.0, assumed_order));
  EXPECT_DOUBLE_EQ(one.levels[2].seconds, 38.0) << "what is spent once is spent";
  learn(one, 2, 0.01, 9.0);
  EXPECT_DOUBLE_EQ(one.levels[1].discretisation, 0.08) << "what was found stays";
  EXPECT_FALSE(cheapest({one}, 0.05, true)) << "the only one that does is solved";
  EXPECT_EQ(cheapest({one}, 0.05)->level, 2U);
}

TEST(Forecast, ACorrectedModelHasAPartOfTheErrorOfThePlainOne) {
  Forecast plain = model("plain", 0.0, 1.0), corrected = model("corrected", 0.5, 10.0);
  corrected.corrects = "plain";
  corrected.uncertain_part = 0.1;
  learn(plain, 0, 0.04, 1.0);
  plain.model_error = 0.02;
  learn_from(corrected, plain, 0);
  EXPECT_DOUBLE_EQ(corrected.model_error, 0.5) << "the plain one's was not found";
  plain.model_error_found = true;
  learn_from(corrected, plain, 0);
  EXPECT_DOUBLE_EQ(corrected.model_error, 0.002);
  EXPECT_DOUBLE_EQ(corrected.levels[2].discretisation, 0.04 / 8.0);
  Forecast other = model("other", 0.0, 100.0);
  learn_from(other, plain, 0);
  EXPECT_DOUBLE_EQ(other.levels[0].discretisation, 0.04)
      << "no grid is better than the plain one's";
  learn(plain, 2, 1e-4, 1.0);
  learn_from(other, plain, 2);
  EXPECT_DOUBLE_EQ(other.levels[0].discretisation, 0.04);
  EXPECT_EQ(other.model_error, 0.0);
}

}  // namespace

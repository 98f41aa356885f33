// SPDX-License-Identifier: LGPL-2.1-or-later
// The cheapest sufficient grid, the next solution of a run, and the update of forecasts by a solved
// grid.
#include "modelling/choice/forecast.hpp"

#include "support/test.hpp"

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
  const auto plan = cheapest({all}, 0.01);  // 0.004 + 0.1 / 20 <= 0.01 < 0.004 + 0.1 / 10
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->model, 0U);
  EXPECT_EQ(all[0].levels[plan->levels[0]].across, 20);
  const auto finer = cheapest({all}, 0.003);
  ASSERT_TRUE(finer);
  EXPECT_EQ(finer->model, 1U);
  EXPECT_FALSE(cheapest({all}, 0.002));
}

TEST(Forecast, SecondsDecideBetweenModelsThatDo) {
  std::vector<Forecast> all{model("plain", 0.0074, 1.0), model("fine", 0.0, 1.5)};
  EXPECT_EQ(cheapest({all}, 0.01)->model, 1U);  // 10 across of the one, 40 of the other
  all[1].cannot = "it cannot";
  EXPECT_EQ(cheapest({all}, 0.01)->model, 0U);
  all[0].cannot = "nor can it";
  EXPECT_FALSE(cheapest({all}, 1.0));
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
  EXPECT_EQ(cheapest({{one}}, 0.05)->levels[0], 2U);
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

/// A run of one contact per entry, by two models: model errors of the plain one, whose grids need
/// 1, 2 and 4 s and have errors of 1, 0.5 and 0.25 %. The fine model has no model error.
Contacts run_of(const std::vector<double>& model_errors, double seconds_of_fine) {
  Contacts contacts;
  for (const double error : model_errors)
    contacts.push_back({model("plain", error, 0.1), model("fine", 0.0, 0.1 * seconds_of_fine)});
  return contacts;
}

/// Every contact is solved by the plain model on the grid of a plan, as expected.
void solve(Contacts& contacts, const Plan& plan) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    Forecast& forecast = contacts[c][plan.model];
    Level& level = forecast.levels[plan.levels[c]];
    forecast.model_error_found = true;
    level.reached = forecast.error(level);
  }
}

using Levels = std::vector<std::size_t>;
constexpr double no_limit = std::numeric_limits<double>::infinity();

TEST(NextPlan, TheFirstModelSolvesAllContactsFirst) {
  Contacts contacts = run_of({0.0, 0.004, 0.1}, 0.5);  // even where another one is quicker
  const auto plan = next_plan(contacts, 0.01, no_limit);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->model, 0U);
  // Left to the grid: 1 %, 0.6 %, and a quarter of 10 %.
  EXPECT_EQ(plan->levels, (Levels{0, 1, 0}));
  EXPECT_DOUBLE_EQ(plan->seconds, 4.0);
  EXPECT_EQ(plan->unsolved, 3U);
}

TEST(NextPlan, AFinerGridOfTheSameModelIsCheaperThanAnotherModel) {
  Contacts contacts = run_of({0.002, 0.002}, 20.0);
  solve(contacts, *next_plan(contacts, 0.01, no_limit));
  contacts[1][0].model_error = 0.006;  // found larger than expected: 0.5 % on 20 is too much
  contacts[1][0].levels[1].reached = 0.011;
  const auto plan = next_plan(contacts, 0.01, no_limit);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->model, 0U);
  EXPECT_EQ(plan->levels, (Levels{1, 2}));
  EXPECT_EQ(plan->unsolved, 1U) << "the other contact has its solution";
  EXPECT_DOUBLE_EQ(plan->seconds, 4.0);
}

TEST(NextPlan, FinerGridsFollowWhereTheyHelpEvenIfAnotherContactStillMisses) {
  Contacts contacts = run_of({0.002, 0.1}, 200.0);
  solve(contacts, *next_plan(contacts, 0.01, 60.0));
  contacts[0][0].levels[1].reached = 0.02;  // of this contact
  const auto plan = next_plan(contacts, 0.01, 60.0);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->model, 0U);
  EXPECT_EQ(plan->levels, (Levels{2, 0}));
  EXPECT_EQ(plan->unsolved, 1U);
}

TEST(NextPlan, LittleTimeMeansCoarserGridsForAll) {
  const auto of_limit = [](double seconds) {
    return next_plan(run_of({0.006, 0.006}, 20.0), 0.01, seconds)->levels;
  };
  EXPECT_EQ(of_limit(4.0), (Levels{1, 1}));
  EXPECT_EQ(of_limit(3.0), (Levels{0, 0}));
  EXPECT_EQ(of_limit(0.1), (Levels{0, 0})) << "an answer is always given";
}

}  // namespace

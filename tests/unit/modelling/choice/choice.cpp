// SPDX-License-Identifier: LGPL-2.1-or-later
// The choice among toy models with given errors, for one contact and for a run of several: solved
// models, their grids, and the sentence about the choice.
#include "modelling/choice/choice.hpp"

#include "base/errors.hpp"
#include "result/record.hpp"

#include "support/temporary_folder.hpp"
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace {

using namespace rollfem::modelling;

/// Errors of a toy on 16 elements across; they fall with 1/n^1.5.
struct Toy {
  double discretisation = 0.02;
  double model_error = 0.0;
  const char* fails = nullptr;
};

struct Toys {
  Toy plain, corrected, full;
  std::vector<std::pair<std::string, int>> solved;
};

contact::ModelResult result_of(const std::string& name, const Toy& toy, int across) {
  contact::ModelResult result;
  result.name = name;
  result.notes = {{contact::about_model_error, "given"}};
  contact::PointResult point;
  point.max_pressure = 200.0;
  point.error_estimate["max_pressure"] = 200.0 * toy.discretisation * std::pow(16.0 / across, 1.5);
  point.model_error["max_pressure"] = 200.0 * toy.model_error;
  result.points = {point};
  return result;
}

struct Candidate {
  Forecast forecast;
  std::function<contact::ModelResult(int across)> solve;
};

/// Expectations are those of the toys as they are made, seconds 1, 10 and 100 times (n/16)^2.
std::vector<Candidate> candidates(Toys& toys) {
  std::vector<Candidate> all;
  double times = 1.0;
  for (const auto& [name, toy] : {std::pair<const char*, const Toy*>{"plain", &toys.plain},
                                  {"corrected", &toys.corrected},
                                  {"full", &toys.full}}) {
    Candidate candidate;
    candidate.forecast.model = candidate.forecast.label = name;
    for (const int across : {16, 32, 64, 128})
      candidate.forecast.levels.push_back(
          {across, 0.02 * std::pow(16.0 / across, 1.5), times * across * across / 256.0});
    candidate.solve = [&toys, name = std::string(name), toy = toy](int across) {
      toys.solved.emplace_back(name, across);
      if (toy->fails != nullptr) throw contact::SolveError(toy->fails);
      return result_of(name, *toy, across);
    };
    times *= 10.0;
    all.push_back(std::move(candidate));
  }
  all[0].forecast.estimates_model_error = true;
  all[1].forecast.corrects = "plain";
  all[1].forecast.uncertain_part = 0.1;
  return all;
}

Wanted wanted(double accuracy) {
  Wanted what;
  what.accuracy = {accuracy, {"max_pressure"}};
  return what;
}

using Solved = std::vector<std::pair<std::string, int>>;

Chosen choose_all(const std::vector<std::vector<Candidate>>& contacts, const Wanted& what) {
  std::vector<Subject> subjects;
  for (const std::vector<Candidate>& candidates : contacts) {
    Subject& subject = subjects.emplace_back();
    for (const Candidate& candidate : candidates) subject.forecasts.push_back(candidate.forecast);
    subject.solve = [&candidates](const Forecast& model, int across) {
      const auto same = [&](const Candidate& one) { return one.forecast.model == model.model; };
      return std::find_if(candidates.begin(), candidates.end(), same)->solve(across);
    };
    subject.friction_coefficient = 0.3;
    subject.where = {"contact " + std::to_string(subjects.size())};
  }
  return choose(std::move(subjects), what);
}

contact::ModelResult choose(std::vector<Candidate> candidates, const Wanted& what) {
  return choose_all({std::move(candidates)}, what).results.front();
}

TEST(Choice, TakesTheCoarsestGridThatDoes) {
  for (const auto& [accuracy, across] : {std::pair{0.05, 16}, {0.01, 32}, {0.002, 128}}) {
    Toys toys;
    const contact::ModelResult result = choose(candidates(toys), wanted(accuracy));
    EXPECT_EQ(toys.solved, (Solved{{"plain", across}}));
    EXPECT_EQ(result.name, "plain");
    EXPECT_EQ(result.shortfall, "");
  }
}

TEST(Choice, LaysNoFineGridForAModelErrorThatIsExpectedOnly) {
  Toys toys;
  toys.plain.model_error = 0.03;
  auto all = candidates(toys);
  all[0].forecast.model_error = 0.0095;  // half of 1 % is left to the grid, not 0.05 %
  EXPECT_EQ(choose(all, wanted(0.01)).name, "corrected");
  EXPECT_EQ(toys.solved, (Solved{{"plain", 64}, {"corrected", 64}}));
  toys.solved.clear();
  all[0].forecast.model_error = 0.08;  // a grid of a quarter of that does
  choose(all, wanted(0.01));
  EXPECT_EQ(toys.solved, (Solved{{"plain", 16}, {"corrected", 64}}));
}

TEST(Choice, RefinesGridsThatAreWorseThanExpected) {
  Toys toys;
  toys.plain.discretisation = 0.05;  // 0.0177 on 32, 0.00625 on 64
  choose(candidates(toys), wanted(0.01));
  EXPECT_EQ(toys.solved, (Solved{{"plain", 32}, {"plain", 64}}));
}

TEST(Choice, ContinuesWhereTheModelErrorIsTooLarge) {
  Toys toys;
  toys.plain.model_error = 0.03;
  const contact::ModelResult result = choose(candidates(toys), wanted(0.01));
  // A tenth of 3 % is left of it: 0.7 % for the grid.
  EXPECT_EQ(toys.solved, (Solved{{"plain", 32}, {"corrected", 64}}));
  EXPECT_EQ(result.name, "corrected");
  EXPECT_TRUE(says(result.choice, "corrected, 64 across", "plain, 32 across", "model 3 %",
                   "full would take about 7 min"));
  EXPECT_EQ(result.note_about("choice")->text, "auto, for 1 %: " + result.choice);
}

TEST(Choice, SkipsModelsThatFailOrCannotSolveTheCase) {
  Toys toys;
  toys.plain.model_error = 0.03;
  toys.corrected.fails = "the bodies are none that it can take";
  EXPECT_EQ(choose(candidates(toys), wanted(0.01)).name, "full");
  EXPECT_EQ(toys.solved, (Solved{{"plain", 32}, {"corrected", 64}, {"full", 32}}));
  Toys others;
  others.plain.model_error = 0.03;
  auto all = candidates(others);
  all[1].forecast.cannot = "not in this build";
  const contact::ModelResult result = choose(all, wanted(0.01));
  EXPECT_EQ(result.name, "full");
  EXPECT_TRUE(says(result.choice, "corrected: not in this build"));
}

TEST(Choice, TriesOneMoreGridWhereOneFails) {
  Toys toys;
  auto all = candidates(toys);
  all[0].solve = [&](int across) {
    toys.solved.emplace_back("plain", across);
    if (across == 32) throw contact::SolveError("single elements go round");
    return result_of("plain", toys.plain, across);
  };
  EXPECT_EQ(choose(all, wanted(0.01)).name, "plain");
  EXPECT_EQ(toys.solved, (Solved{{"plain", 32}, {"plain", 64}}));
}

TEST(Choice, GivesTheBestWhereNothingDoesAndFailsWhereItWasAskedFor) {
  Toys toys;
  toys.plain.model_error = 0.03;
  auto all = candidates(toys);
  all[1].forecast.cannot = all[2].forecast.cannot = "not in this build";
  const contact::ModelResult asked = choose(all, wanted(0.01));
  EXPECT_EQ(asked.name, "plain");
  EXPECT_TRUE(says(asked.shortfall, "accuracy = 0.01 was not reached"));
  Wanted what = wanted(0.01);
  what.seconds = 60.0;
  const Chosen chosen = choose_all({all}, what);
  EXPECT_EQ(chosen.results.front().shortfall, "");
  EXPECT_EQ(chosen.advice, "") << "no time helps";
}

TEST(Choice, TakesNoMoreTimeThanItsLimit) {
  Toys toys;
  toys.plain.model_error = 0.03;
  auto all = candidates(toys);
  all[1].forecast.cannot = "not in this build";
  Wanted what = wanted(0.01);
  what.seconds = 60.0;
  const Chosen chosen = choose_all({all}, what);
  // "full" needs 100 s on 16 across, 400 on 32
  EXPECT_EQ(chosen.results.front().name, "plain");
  EXPECT_EQ(chosen.advice, "`--set accuracy=0.01` allows more time: full would take about 7 min.");
  what.seconds = 1000.0;
  EXPECT_EQ(choose(all, what).name, "full");
  EXPECT_EQ(toys.solved.back(), (std::pair<std::string, int>{"full", 32}));
}

TEST(Choice, SolvesTheQuickestWhereTheLimitHoldsNone) {
  Toys toys;
  Wanted what = wanted(0.01);
  what.seconds = 0.5;
  const Chosen chosen = choose_all({candidates(toys)}, what);
  EXPECT_EQ(toys.solved, (Solved{{"plain", 16}}));
  EXPECT_EQ(chosen.advice, "`--set accuracy=0.01` allows more time: plain would take about 4 s.");
}

TEST(Choice, AnnouncesTheTimeOfModelsThatUseAllThreads) {
  Toys toys;
  toys.plain.model_error = 0.03;
  auto all = candidates(toys);
  all[0].forecast.on_one_thread = true;
  std::vector<std::string> told;
  Wanted what = wanted(0.01);
  what.progress = [&](const contact::ProgressEvent& event) { told.push_back(event.note); };
  choose_all({all, all}, what);
  EXPECT_EQ(told, (std::vector<std::string>{"corrected for 2 contacts, about 5 min"}));
  // No time is promised for the other kind.
  what.seconds = 0.5;
  toys.plain.model_error = 0.0;
  EXPECT_EQ(choose_all({all}, what).advice,
            "`--set accuracy=0.01` allows more time: plain on finer grids.");
}

TEST(Choice, OneContactThatNeedsAnotherModelChangesTheModelOfAll) {
  Toys good, bad;
  bad.plain.model_error = 0.03;
  const Chosen chosen =
      choose_all({candidates(good), candidates(bad), candidates(good)}, wanted(0.01));
  ASSERT_EQ(chosen.results.size(), 3U);
  for (const contact::ModelResult& result : chosen.results) {
    EXPECT_EQ(result.name, "corrected");
    EXPECT_EQ(result.notes, chosen.results.front().notes) << "one note for the run";
  }
  EXPECT_TRUE(says(chosen.results[0].note_about("choice")->text,
                   "auto, for 1 %: corrected for all 3 contacts", "; plain for all 3 contacts",
                   "model 3 %", "; full would take about"));
  // The contact that alone needs a finer grid has one: a tenth of 3 % is left of its model error.
  EXPECT_EQ(good.solved,
            (Solved{{"plain", 32}, {"plain", 32}, {"corrected", 32}, {"corrected", 32}}));
  EXPECT_EQ(bad.solved, (Solved{{"plain", 32}, {"corrected", 64}}));
}

TEST(Choice, AllContactsKeepTheFirstModelWhereAnotherOneTakesTooLong) {
  Toys good, bad;
  bad.plain.model_error = 0.03;
  Wanted what = wanted(0.01);
  what.seconds = 60.0;
  // The bad contact alone would need 160 s of "corrected"; with 170 s the good one does not fit.
  for (const double seconds : {60.0, 170.0}) {
    what.seconds = seconds;
    const Chosen chosen = choose_all({candidates(good), candidates(bad)}, what);
    for (const contact::ModelResult& result : chosen.results) EXPECT_EQ(result.name, "plain");
    EXPECT_EQ(chosen.advice,
              "`--set accuracy=0.01` allows more time: corrected would take about 3 min.");
  }
}

TEST(Choice, AContactThatTheFirstModelCannotTakeDecidesForAll) {
  Toys good, bad;
  auto beyond = candidates(bad);
  beyond[0].forecast.cannot = "the bodies conform";
  const Chosen chosen = choose_all({candidates(good), beyond}, wanted(0.05));
  for (const contact::ModelResult& result : chosen.results) EXPECT_EQ(result.name, "corrected");
  EXPECT_EQ(good.solved, (Solved{{"corrected", 16}}));
  EXPECT_TRUE(says(chosen.results.front().choice, "plain: the bodies conform"));
}

TEST(Choice, AnUnknownErrorDoesNotSuffice) {
  Toys toys;
  auto all = candidates(toys);
  all[0].solve = [&](int across) {
    contact::ModelResult result = result_of("plain", toys.plain, across);
    result.points[0].model_error.clear();
    return result;
  };
  EXPECT_EQ(choose(all, wanted(0.01)).name, "corrected");
  all[0].solve = [&](int across) {
    contact::ModelResult result = result_of("plain", toys.plain, across);
    result.points[0].error_estimate.clear();
    result.points[0].no_bar["max_pressure"] = contact::NoBar::one_grid;
    return result;
  };
  EXPECT_NE(choose(all, wanted(0.01)).name, "plain");
}

TEST(Choice, ThrowsWhatTheFirstThrewWhereAllFail) {
  Toys toys;
  toys.plain.fails = "nothing touches";
  toys.corrected.fails = toys.full.fails = "no patch";
  EXPECT_EQ(refusal<contact::SolveError>([&] { choose(candidates(toys), wanted(0.01)); }),
            "contact 1: model plain: nothing touches");
  auto none = candidates(toys);
  for (Candidate& candidate : none) candidate.forecast.cannot = "it cannot handle this";
  EXPECT_THROW(choose(none, wanted(0.01)), contact::InputError);
  Wanted strict = wanted(0.01);
  strict.go_on = false;
  Toys second;
  second.plain.fails = "nothing touches";
  EXPECT_THROW(choose(candidates(second), strict), contact::SolveError);
  EXPECT_EQ(second.solved.size(), 1U);
}

TEST(Choice, AgreesWithTheFirstProcess) {
  Toys toys;
  Wanted what = wanted(0.01);
  int asked = 0;  // the first one has the plain model's error, this process nothing of it
  what.agree = [&](const std::string&) {
    const double model = ++asked == 1 ? 0.03 : 0.0;
    return rollfem::contact::record_of(1.0, 0.001, model, 0.001, model, 1,
                                       std::string("max_pressure"));
  };
  EXPECT_EQ(choose(candidates(toys), what).name, "corrected");
  EXPECT_EQ(asked, 2);
}

}  // namespace

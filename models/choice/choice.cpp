// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/choice/choice.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

namespace rollfem::modelling {

namespace {

using contact::ModelResult;

/// If no grid is expected to meet the accuracy, a cheaper grid within this factor of the best is
/// accepted.
constexpr double near_enough = 1.25;

/// Expected model errors are known only to a factor of two or three. Until one is computed, this
/// part of it counts, so that a guess neither rules out a cheap model nor makes its first grid too
/// fine.
constexpr double believed_of_expected = 1.0 / 3.0;

/// Weight of expected model errors until they are computed.
std::vector<Forecast> hopes(std::vector<Forecast> forecasts, double accuracy) {
  for (Forecast& forecast : forecasts) {
    if (forecast.model_error_found) continue;
    forecast.model_error *= believed_of_expected;
    // Fine grids wait until the model error is known.
    if (forecast.model_error <= accuracy)
      forecast.model_error = std::min(forecast.model_error, 0.5 * accuracy);
  }
  return forecasts;
}

/// Cost of a model that was not chosen, or why it is unavailable. `times`: seconds on this machine
/// per predicted second.
std::string not_taken(const Forecast& forecast, double accuracy, double times = 1.0) {
  if (!forecast.cannot.empty()) return fmt::format("{}: {}", forecast.label, forecast.cannot);
  if (const auto plan = cheapest({forecast}, accuracy))
    return fmt::format("{} would take about {}", forecast.label,
                       duration(times * forecast.levels[plan->level].seconds));
  if (forecast.model_error > accuracy)
    return fmt::format("{} {} {}", forecast.label,
                       forecast.model_error_found ? "neglects" : "is expected to neglect about",
                       percent(forecast.model_error));
  return fmt::format("{} is not expected to suffice", forecast.label);
}

/// Shorter levels say nothing about the speed of a machine: they are mostly overhead, s.
constexpr double worth_timing = 0.1;

struct Cost {
  double seconds = 0.0;  ///< wall time
  double had = 0.0;      ///< part of a processor, at most 1; 0: unknown
};

class CostWatch {
 public:
  Cost cost() const {
    constexpr double least = 0.01;
    const double seconds = watch_.seconds();
    const double cpu = static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC;
    return {seconds, seconds > worth_timing ? std::clamp(cpu / seconds, least, 1.0) : 0.0};
  }

 private:
  contact::Stopwatch watch_;
  std::clock_t begin_ = std::clock();  ///< CPU time of all threads
};

/// The last attempt of a candidate.
struct Attempt {
  int across = 0;
  double seconds = 0.0;
  Reached reached;
};

struct Best {
  std::size_t model = 0;
  ModelResult result;
};

class Choice {
 public:
  Choice(std::vector<Candidate> candidates, const Wanted& wanted)
      : candidates_(std::move(candidates)),
        wanted_(wanted),
        accuracy_(*wanted.accuracy.relative),
        attempts_(candidates_.size()),
        failed_once_(candidates_.size(), false),
        budget_(wanted.budget != nullptr ? *wanted.budget : unlimited_) {
    for (const Candidate& candidate : candidates_) forecasts_.push_back(candidate.forecast);
  }

  ModelResult run() {
    while (!met_) {
      const std::optional<Plan> plan = next();
      if (!plan) break;
      attempt(*plan);
    }
    if (!best_) throw_why_none();
    return finished();
  }

 private:
  double reached_best() const { return attempts_[best_->model]->reached.together(); }

  /// The next plan to solve; empty if no plan improves on the results so far.
  std::optional<Plan> next() const {
    std::vector<Forecast> hoped = hopes(forecasts_, accuracy_);
    for (Forecast& forecast : hoped) leave_out_slow(forecast.levels);
    if (const auto plan = cheapest(hoped, accuracy_, true)) return plan;
    const double least = near_enough * least_error(hoped, true);
    if (best_ && reached_best() <= least) return {};
    if (const auto plan = cheapest(hoped, least, true)) return plan;
    // Without any result yet, a slow plan is still worth solving.
    return best_ ? std::nullopt : quickest();
  }

  /// Levels are ordered by increasing time.
  void leave_out_slow(std::vector<Level>& levels) const {
    const double allowed = budget_.allowed();
    while (!levels.empty() && levels.back().seconds > allowed && !levels.back().solved)
      levels.pop_back();
  }

  std::optional<Plan> quickest() const {
    return cheapest(forecasts_, std::numeric_limits<double>::max(), true);
  }

  void attempt(const Plan& plan) {
    Forecast& forecast = forecasts_[plan.model];
    const int across = forecast.levels[plan.level].across;
    announce(forecast, forecast.levels[plan.level]);
    const CostWatch watch;
    try {
      ModelResult result = candidates_[plan.model].solve(across);
      judge(plan, watch.cost(), std::move(result));
    } catch (const contact::UnfitGrid& error) {
      count_failed(watch);
      leave_out_grid(plan, error.what());
    } catch (const contact::SolveError& error) {
      count_failed(watch);
      if (failed_once_[plan.model]) return leave_out(forecast, error.what());
      failed_once_[plan.model] = true;
      leave_out_grid(plan, error.what());  // another level may have a solution: retry once
    } catch (const contact::InputError& error) {
      leave_out(forecast, error.what());
    }
  }

  /// The outcome is unknown, but the time it takes is known.
  void announce(const Forecast& forecast, const Level& level) const {
    contact::ProgressEvent event;
    event.model = forecast.model;
    event.stage = "tried next";
    event.finished = true;  // keep its line on the terminal
    event.note =
        fmt::format("{} across, about {}", level.across, duration(times() * level.seconds));
    contact::report(wanted_.progress, event);
  }

  void count_failed(const CostWatch& watch) {
    const Cost cost = watch.cost();
    budget_.spend(0.0, cost.seconds, cost.had);
  }

  /// A gross misprediction also applies to the model's finer grids and to the model that corrects
  /// it. Any other is taken for the speed of this machine, except of corrected models, because
  /// their correction may come from the cache.
  void count(const Plan& plan, double predicted, const Cost& cost) {
    const double wrong = budget_.spend(predicted, cost.seconds, cost.had);
    const std::string& model = forecasts_[plan.model].model;
    if (budget_.limited() && wrong > 1.0) {
      for (Forecast& forecast : forecasts_)
        if (forecast.model == model || forecast.corrects == model)
          for (Level& level : forecast.levels)
            if (!level.solved) level.seconds *= wrong;
    } else if (std::min(cost.seconds, predicted) > worth_timing &&
               forecasts_[plan.model].corrects.empty()) {
      slower_ = cost.seconds / (predicted * budget_.times());
    }
  }

  /// While an exception is handled.
  void leave_out_grid(const Plan& plan, const std::string& why) {
    std::vector<Level>& levels = forecasts_[plan.model].levels;
    if (!wanted_.go_on) throw;
    if (!failure_) failure_ = std::current_exception();
    levels.erase(levels.begin() + static_cast<std::ptrdiff_t>(plan.level));
    if (levels.empty()) leave_out(forecasts_[plan.model], why);
  }

  /// While an exception is handled.
  void leave_out(Forecast& forecast, const std::string& why) {
    if (!wanted_.go_on) throw;
    forecast.cannot = why;
    if (!failure_) failure_ = std::current_exception();
  }

  void judge(const Plan& plan, Cost cost, ModelResult result) {
    const Candidate& candidate = candidates_[plan.model];
    Forecast& forecast = forecasts_[plan.model];
    Reached reached = reached_by(result, wanted_.accuracy, wanted_.friction_coefficient,
                                 !candidate.estimates_model_error || result.has_model_error());
    if (candidate.largest_model_error > 0.0)
      reached.set_largest_model(candidate.largest_model_error);
    agree(reached, cost);
    const double predicted = forecast.levels[plan.level].seconds;
    learn(forecast, plan.level, reached.most_discretisation, cost.seconds);
    if (candidate.estimates_model_error || candidate.largest_model_error > 0.0) {
      forecast.model_error = reached.most_model;
      forecast.model_error_found = true;
    }
    for (Forecast& other : forecasts_)
      if (&other != &forecast) learn_from(other, forecast, plan.level);
    count(plan, predicted, cost);
    const bool better = !best_ || reached.together() < reached_best();
    attempts_[plan.model] = Attempt{forecast.levels[plan.level].across, cost.seconds, reached};
    met_ = reached.together() <= accuracy_;
    if (candidate.largest_model_error > 0.0)
      result.model_error_source =
          fmt::format("not estimated: at most {} by the size of the contact, {} requested",
                      percent(candidate.largest_model_error), percent(accuracy_));
    if (better || met_) best_ = Best{plan.model, std::move(result)};
  }

  /// Only the first of several processes holds complete results.
  void agree(Reached& reached, Cost& cost) const {
    if (!wanted_.agree) return;
    const std::string text = wanted_.agree(
        fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {} {}", cost.seconds, cost.had,
                    reached.discretisation, reached.model, reached.most_discretisation,
                    reached.most_model, reached.point, reached.quantity));
    std::istringstream words(text);
    const auto number = [&] {  // includes infinity
      std::string word;
      words >> word;
      return std::strtod(word.c_str(), nullptr);
    };
    cost.seconds = number();
    cost.had = number();
    reached.discretisation = number();
    reached.model = number();
    reached.most_discretisation = number();
    reached.most_model = number();
    words >> reached.point;
    reached.quantity.clear();
    words >> reached.quantity;
  }

  /// The first failure comes from the simplest model and is the most informative.
  [[noreturn]] void throw_why_none() const {
    if (failure_) std::rethrow_exception(failure_);
    std::string text;
    for (const Forecast& forecast : forecasts_)
      text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", forecast.label, forecast.cannot);
    throw contact::InputError("no model can solve this case: " + text +
                              "; do: change the case, or name a model");
  }

  /// The model and level that were chosen.
  std::string taken() const {
    const Attempt& attempt = *attempts_[best_->model];
    return fmt::format("{}, {} across, {}: {}", forecasts_[best_->model].label, attempt.across,
                       duration(attempt.seconds),
                       attempt.reached.text(candidates_[best_->model].no_model_error));
  }

  std::string left(std::size_t m) const {
    const Forecast& forecast = forecasts_[m];
    if (const auto& attempt = attempts_[m])
      return fmt::format("{}, {} across, {}, has {}", forecast.label, attempt->across,
                         duration(attempt->seconds), attempt->reached.text());
    return not_taken(forecast, accuracy_, times());
  }

  /// Seconds to expect per predicted second.
  double times() const { return slower_ * budget_.times(); }

  ModelResult finished() {
    ModelResult result = std::move(best_->result);
    result.choice = taken();
    for (std::size_t m = 0; m < forecasts_.size(); ++m)
      if (m != best_->model) result.choice += "; " + left(m);
    result.notes.insert(result.notes.begin(),
                        fmt::format("auto, for {}: {}", percent(accuracy_), result.choice));
    if (!met_) fail(result);
    return result;
  }

  void fail(ModelResult& result) const {
    if (!budget_.limited()) {
      result.shortfall =
          fmt::format("accuracy = {:g} was not reached: {}; do: request less accuracy", accuracy_,
                      result.choice);
      return;
    }
    result.notes.insert(
        result.notes.begin(),
        fmt::format("warning: accuracy = {:g}, which models = [\"auto\"] aims for within {} for "
                    "the whole run, is not reached: {}; do: give `accuracy` to allow more time, or "
                    "name a model",
                    accuracy_, duration(seconds_by_default), result.choice));
  }

  std::vector<Candidate> candidates_;
  const Wanted& wanted_;
  double accuracy_;
  std::vector<Forecast> forecasts_;
  std::vector<std::optional<Attempt>> attempts_;
  std::vector<bool> failed_once_;
  std::optional<Best> best_;
  std::exception_ptr failure_;
  Budget unlimited_{{}, 1.0, std::numeric_limits<double>::infinity()};
  Budget& budget_;
  double slower_ = 1.0;  ///< than predicted for this machine
  bool met_ = false;
};

}  // namespace

double seconds_of_first(const std::vector<Forecast>& forecasts, double accuracy) {
  const std::vector<Forecast> hoped = hopes(forecasts, accuracy);
  const auto plan = cheapest(hoped, accuracy);
  return plan ? hoped[plan->model].levels[plan->level].seconds : 0.0;
}

std::string duration(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.2g} s", seconds);
  if (seconds < 6000.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.0f} h", seconds / 3600.0);
}

ModelResult choose(std::vector<Candidate> candidates, const Wanted& wanted) {
  return Choice(std::move(candidates), wanted).run();
}

std::string verdict(const std::vector<Forecast>& forecasts, double accuracy, bool others) {
  const std::optional<Plan> plan = cheapest(forecasts, accuracy);
  std::string text = "nothing is expected to suffice";
  if (plan) {
    const Forecast& forecast = forecasts[plan->model];
    const Level& level = forecast.levels[plan->level];
    text = fmt::format("{}, {} across, {}{}: discretisation {}, model {}", forecast.label,
                       level.across, level.solved ? "" : "about ", duration(level.seconds),
                       percent(level.discretisation), percent(forecast.model_error));
  }
  for (std::size_t m = 0; others && m < forecasts.size(); ++m)
    if (!plan || m != plan->model) text += "; " + not_taken(forecasts[m], accuracy);
  return text;
}

}  // namespace rollfem::modelling

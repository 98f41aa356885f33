// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/choice/choice.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "result/quantities.hpp"
#include "result/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

namespace rollfem::modelling {

namespace {

using contact::ModelResult;
using contact::percent;
using contact::Reached;

/// The best solution of a contact by a model.
struct Attempt {
  int across = 0;
  double seconds = 0.0;
  Reached reached;
  ModelResult result;
};

/// "0.3 s", "4 min", "2 h".
std::string duration(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.2g} s", seconds);
  if (seconds < 6000.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.0f} h", seconds / 3600.0);
}

/// "hybrid would take about 4 min", without time for a half-space, or why it would not suffice.
std::string not_taken(const Contacts& contacts, std::size_t model, double accuracy) {
  const std::string& label = contacts.front()[model].label;
  const Forecast* most = &contacts.front()[model];
  for (const std::vector<Forecast>& models : contacts) {
    if (!models[model].cannot.empty()) return fmt::format("{}: {}", label, models[model].cannot);
    if (models[model].model_error > most->model_error) most = &models[model];
  }
  if (const auto plan = plan_of(contacts, model, accuracy); plan && plan->error <= accuracy)
    return label + (most->on_one_thread ? " on finer grids"
                                        : " would take about " + duration(plan->seconds));
  if (most->model_error > accuracy)
    return fmt::format("{} {} {}", label,
                       most->model_error_found ? "neglects" : "is expected to neglect about",
                       percent(most->model_error));
  return fmt::format("{} would probably not suffice", label);
}

class Choice {
 public:
  Choice(std::vector<Subject> subjects, const Wanted& wanted)
      : subjects_(std::move(subjects)), wanted_(wanted), accuracy_(*wanted.accuracy.relative) {
    for (Subject& subject : subjects_) {
      attempts_.emplace_back(subject.forecasts.size());
      failed_once_.emplace_back(subject.forecasts.size(), false);
      forecasts_.push_back(std::move(subject.forecasts));
    }
  }

  Chosen run() {
    while (const auto plan = next_plan(forecasts_, accuracy_, wanted_.seconds - predicted_)) {
      announce(*plan);
      if (!solve(*plan)) break;
    }
    return finished();
  }

 private:
  const std::string& label(std::size_t m) const { return forecasts_.front()[m].label; }

  /// Not the half-space: its seconds cannot be predicted within a factor of 3 (docs/counts.md).
  void announce(const Plan& plan) const {
    if (forecasts_.front()[plan.model].on_one_thread) return;
    contact::ProgressEvent event;
    event.model = "auto";
    event.stage = "expected";
    event.finished = true;  // keep its line on the terminal
    event.note = fmt::format("{} for {} contact{}, about {}", label(plan.model), plan.unsolved,
                             plan.unsolved == 1 ? "" : "s", duration(plan.seconds));
    contact::report(wanted_.progress, event);
  }

  /// What a model found on one contact; neither result nor error: not tried.
  struct Outcome {
    std::optional<ModelResult> result;
    std::exception_ptr error;
    double seconds = 0.0;
  };

  /// Solves the plan: by a model on one thread all contacts side by side, by others one after the
  /// other as far as nothing fails. False: the limit has passed by the clock, and there is a
  /// solution of every contact.
  bool solve(const Plan& plan) {
    const bool complete = answer(forecasts_).has_value();
    std::vector<std::size_t> open;
    for (std::size_t c = 0; c < subjects_.size(); ++c)
      if (!forecasts_[c][plan.model].levels[plan.levels[c]].reached) open.push_back(c);
    // Several processes agree on the time of every contact.
    const bool beside = forecasts_.front()[plan.model].on_one_thread && !wanted_.agree;
    std::vector<Outcome> outcomes(open.size());
    const contact::Stopwatch watch;
    const double before = elapsed_;
    if (beside)
      contact::for_each_index(open.size(), [&](std::size_t i) {
        if (!complete || before + watch.seconds() <= wanted_.seconds)
          outcomes[i] = outcome_of(open[i], plan);
      });
    const double together = watch.seconds();
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (!beside && (!complete || elapsed_ <= wanted_.seconds))
        outcomes[i] = outcome_of(open[i], plan);
      if (!outcomes[i].result && !outcomes[i].error) return false;
      if (!take(open[i], plan, std::move(outcomes[i])) && !beside) break;
    }
    if (beside) elapsed_ = before + together;
    return true;
  }

  Outcome outcome_of(std::size_t c, const Plan& plan) const {
    const Forecast& forecast = forecasts_[c][plan.model];
    Outcome outcome;
    const contact::Stopwatch watch;
    try {
      outcome.result = subjects_[c].solve(forecast, forecast.levels[plan.levels[c]].across);
    } catch (contact::Failure& error) {
      contact::FailurePlace place = subjects_[c].where;
      place.push_back("model " + forecast.model);
      if (error.cause() != contact::Failure::Cause::input) error.put_at(place);
      if (!wanted_.go_on) throw;
      outcome.error = std::current_exception();
    }
    outcome.seconds = watch.seconds();
    return outcome;
  }

  /// False: it failed.
  bool take(std::size_t c, const Plan& plan, Outcome outcome) {
    const std::size_t m = plan.model, at = plan.levels[c];
    predicted_ += forecasts_[c][m].levels[at].seconds;
    if (outcome.result) {
      judge(c, m, at, outcome.seconds, *std::move(outcome.result));
      return true;
    }
    try {
      std::rethrow_exception(outcome.error);
    } catch (const contact::Failure& error) {
      failed(c, m, at, error);
    }
    elapsed_ += outcome.seconds;
    return false;
  }

  /// While an exception is handled. Keeps the first failure, and leaves out the grid, or all grids
  /// of the model that are not solved.
  void failed(std::size_t c, std::size_t m, std::size_t at, const contact::Failure& error) {
    using Cause = contact::Failure::Cause;
    Forecast& forecast = forecasts_[c][m];
    bool only_grid = error.cause() == Cause::grid;
    if (error.cause() == Cause::solution) {  // another grid may have a solution: retry once
      only_grid = !failed_once_[c][m];
      failed_once_[c][m] = true;
    }
    if (!failure_) failure_ = std::current_exception();
    std::vector<Level> left;
    for (std::size_t k = 0; k < forecast.levels.size(); ++k)
      if (forecast.levels[k].reached || (only_grid && k != at)) left.push_back(forecast.levels[k]);
    forecast.levels = std::move(left);
    if (forecast.levels.empty()) forecast.cannot = error.text();
  }

  void judge(std::size_t c, std::size_t m, std::size_t at, double seconds, ModelResult result) {
    Forecast& forecast = forecasts_[c][m];
    Reached reached =
        contact::reached_by(result, wanted_.accuracy, subjects_[c].friction_coefficient,
                            !forecast.estimates_model_error || result.has_model_error());
    agree(reached, seconds);
    elapsed_ += seconds;
    learn(forecast, at, reached.most_discretisation, seconds);
    forecast.levels[at].reached = reached.together();
    if (forecast.estimates_model_error) {
      forecast.model_error = reached.most_model;
      forecast.model_error_found = true;
    }
    for (Forecast& other : forecasts_[c])
      if (&other != &forecast) learn_from(other, forecast, at);
    std::optional<Attempt>& best = attempts_[c][m];
    if (!best || reached.together() < best->reached.together())
      best = Attempt{forecast.levels[at].across, seconds, reached, std::move(result)};
  }

  /// Only the first of several processes holds complete results.
  void agree(Reached& reached, double& seconds) const {
    if (!wanted_.agree) return;
    const auto exchange = [&](contact::Record record) {
      record.values(seconds, reached.discretisation, reached.model, reached.most_discretisation,
                    reached.most_model, reached.point, reached.quantity);
      return record.bytes();
    };
    exchange(contact::Record(wanted_.agree(exchange({}))));
  }

  const Attempt& worst(std::size_t m) const { return *attempts_[*worst_contact(forecasts_, m)][m]; }

  /// The first failure comes from the simplest model and is the most informative.
  [[noreturn]] void throw_why_none() const {
    if (failure_) std::rethrow_exception(failure_);
    std::string text;
    for (std::size_t m = 0; m < models_of(forecasts_); ++m)
      text += fmt::format("{}{}", m > 0 ? "; " : "", not_taken(forecasts_, m, accuracy_));
    throw contact::InputError("no model can solve this case: " + text +
                              "; do: change the case, or name a model");
  }

  std::string solved_text(std::size_t c, std::size_t m) const {
    const Attempt& attempt = *attempts_[c][m];
    return fmt::format("{}, {} across, {}: {}", label(m), attempt.across, duration(attempt.seconds),
                       attempt.reached.text(forecasts_[c][m].no_model_error));
  }

  /// A complete model in all contacts.
  std::string all_text(std::size_t m) const {
    if (subjects_.size() == 1) return solved_text(0, m);
    double seconds = 0.0;
    for (const auto& attempts : attempts_) seconds += attempts[m]->seconds;
    return fmt::format("{} for all {} contacts, {}, worst contact: {}", label(m), subjects_.size(),
                       duration(seconds), worst(m).reached.text());
  }

  Chosen finished() {
    const std::optional<std::size_t> best = answer(forecasts_);
    if (!best) throw_why_none();
    std::string others;
    for (std::size_t m = 0; m < models_of(forecasts_); ++m)
      if (m != *best)
        others += "; " + (worst_contact(forecasts_, m) ? all_text(m)
                                                       : not_taken(forecasts_, m, accuracy_));
    const bool limited = std::isfinite(wanted_.seconds);
    Chosen chosen;
    if (limited && worst(*best).reached.together() > accuracy_)
      if (const auto plan = cheapest(forecasts_, accuracy_))
        chosen.advice = fmt::format("`--set accuracy={:g}` allows more time: {}.", accuracy_,
                                    not_taken(forecasts_, plan->model, accuracy_));
    const contact::Note note{
        "choice", fmt::format("auto, for {}: {}{}", percent(accuracy_), all_text(*best), others)};
    for (std::size_t c = 0; c < subjects_.size(); ++c) {
      const bool met = attempts_[c][*best]->reached.together() <= accuracy_;
      ModelResult result = std::move(attempts_[c][*best]->result);
      result.choice = solved_text(c, *best) + others;
      result.notes.insert(result.notes.begin(), note);
      if (!met && !limited)
        result.shortfall =
            fmt::format("accuracy = {:g} was not reached: {}; do: request less accuracy", accuracy_,
                        result.choice);
      chosen.results.push_back(std::move(result));
    }
    return chosen;
  }

  std::vector<Subject> subjects_;
  const Wanted& wanted_;
  double accuracy_;
  Contacts forecasts_;
  std::vector<std::vector<std::optional<Attempt>>> attempts_;  ///< like `forecasts_`
  std::vector<std::vector<bool>> failed_once_;
  std::exception_ptr failure_;
  double predicted_ = 0.0;  ///< seconds of all grids tried
  double elapsed_ = 0.0;    ///< seconds by the clock
};

}  // namespace

Chosen choose(std::vector<Subject> contacts, const Wanted& wanted) {
  return Choice(std::move(contacts), wanted).run();
}

}  // namespace rollfem::modelling

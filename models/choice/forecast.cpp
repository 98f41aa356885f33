// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/choice/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::modelling {

namespace {

/// Expected discretisation error of a grid, extrapolated from another grid's error.
double expected_of(const Level& level, int across, double discretisation) {
  return discretisation * std::pow(static_cast<double>(across) / level.across, assumed_order);
}

/// If no grid is expected to meet the accuracy, a run aims for errors larger by this factor, and so
/// on. Smaller improvements are not worth another solution.
constexpr double next_target = 1.25;
constexpr double largest_target = 100.0;  ///< 10 000 %

/// Expected model errors are known to a factor of two or three. Until one is found, it takes at
/// most half the accuracy; where it is expected to be far beyond, the grid need not be fine.
Contacts hopes(Contacts contacts, double accuracy) {
  constexpr double worth_of_grid = 0.25;
  for (std::vector<Forecast>& models : contacts)
    for (Forecast& forecast : models)
      if (!forecast.model_error_found)
        forecast.model_error = std::min({forecast.model_error, 0.5 * accuracy,
                                         accuracy - worth_of_grid * forecast.model_error});
  return contacts;
}

/// Whether the model can take every contact.
bool able(const Contacts& contacts, std::size_t model) {
  return std::all_of(contacts.begin(), contacts.end(), [&](const std::vector<Forecast>& models) {
    return models[model].cannot.empty();
  });
}

/// The plan with the smallest error within the time; of several, the cheapest. With `stay`, a model
/// that has not solved all contacts must meet the accuracy.
std::optional<Plan> closest(const Contacts& contacts, double accuracy, double seconds, bool stay) {
  for (double target = accuracy; target < largest_target; target *= next_target) {
    std::optional<Plan> best;
    for (std::size_t m = 0; m < models_of(contacts); ++m) {
      if (stay && target > accuracy && !all_solved(contacts, m)) continue;
      std::optional<Plan> plan = plan_of(contacts, m, target);
      if (plan && plan->seconds <= seconds && (!best || plan->seconds < best->seconds))
        best = std::move(plan);
    }
    if (best) return best;
    for (std::size_t m = 0; m < models_of(contacts); ++m)
      if (std::optional<Plan> plan = plan_of(contacts, m, next_target * next_target * target))
        if (plan->unsolved == 0) return plan;
  }
  return {};
}

}  // namespace

std::optional<Plan> plan_of(const Contacts& contacts, std::size_t model, double accuracy) {
  Plan plan;
  plan.model = model;
  for (const std::vector<Forecast>& models : contacts) {
    const Forecast& forecast = models[model];
    std::optional<std::size_t> best;
    const auto cost = [&](std::size_t k) {
      return forecast.levels[k].reached ? 0.0 : forecast.levels[k].seconds;
    };
    for (std::size_t k = 0; k < forecast.levels.size() && forecast.cannot.empty(); ++k)
      if (forecast.error(forecast.levels[k]) <= accuracy && (!best || cost(k) < cost(*best)))
        best = k;
    if (!best) return {};
    plan.levels.push_back(*best);
    plan.seconds += cost(*best);
    plan.unsolved += forecast.levels[*best].reached ? 0 : 1;
  }
  return plan;
}

std::optional<Plan> cheapest(const Contacts& contacts, double accuracy) {
  std::optional<Plan> best;
  for (std::size_t m = 0; m < models_of(contacts); ++m)
    if (std::optional<Plan> plan = plan_of(contacts, m, accuracy))
      if (!best || plan->seconds < best->seconds) best = std::move(plan);
  return best;
}

bool all_solved(const Contacts& contacts, std::size_t model) {
  return std::all_of(contacts.begin(), contacts.end(), [&](const std::vector<Forecast>& models) {
    const std::vector<Level>& levels = models[model].levels;
    return std::any_of(levels.begin(), levels.end(), [](const Level& l) { return l.reached; });
  });
}

std::optional<Plan> next_plan(const Contacts& contacts, double accuracy, double seconds) {
  Contacts hoped = hopes(contacts, accuracy);
  std::size_t first = 0;
  while (first < models_of(contacts) && !able(contacts, first)) ++first;
  if (first == models_of(contacts)) return {};
  const bool begun = all_solved(contacts, first);
  if (!begun)
    for (std::vector<Forecast>& models : hoped) models = {models[first]};
  std::optional<Plan> plan = closest(hoped, accuracy, seconds, begun && std::isfinite(seconds));
  // Without any solution yet, the quickest is worth its time.
  if (!plan && !begun) plan = plan_of(hoped, 0, largest_target);
  if (!plan || plan->unsolved == 0) return {};
  if (!begun) plan->model = first;
  return plan;
}

ExpectedRun expected_run(Contacts contacts, double accuracy, double seconds) {
  ExpectedRun run;
  while (const std::optional<Plan> plan = next_plan(contacts, accuracy, seconds - run.seconds)) {
    run.plans.push_back(*plan);
    run.seconds += plan->seconds;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      Forecast& forecast = contacts[c][plan->model];
      Level& level = forecast.levels[plan->levels[c]];
      if (level.reached) continue;
      level.reached = forecast.error(level);
      forecast.model_error_found = true;
      learn(forecast, plan->levels[c], level.discretisation, level.seconds);
      level.solved = false;
      for (Forecast& other : contacts[c])
        if (&other != &forecast) learn_from(other, forecast, plan->levels[c]);
    }
  }
  run.contacts = std::move(contacts);
  return run;
}

void learn(Forecast& forecast, std::size_t at, double discretisation, double seconds) {
  Level& level = forecast.levels.at(at);
  level.discretisation = discretisation;
  level.seconds = seconds;
  level.solved = true;
  for (Level& other : forecast.levels) {
    if (other.solved) continue;
    other.discretisation = expected_of(other, level.across, discretisation);
    other.seconds -= forecast.once;
  }
  forecast.once = 0.0;
}

void learn_from(Forecast& forecast, const Forecast& solved, std::size_t at) {
  const Level& found = solved.levels.at(at);
  const bool corrects = forecast.corrects == solved.model;
  for (Level& level : forecast.levels) {
    if (level.solved || !std::isfinite(found.discretisation)) continue;
    const double expected = expected_of(level, found.across, found.discretisation);
    level.discretisation = corrects ? expected : std::max(level.discretisation, expected);
  }
  if (!corrects || !solved.model_error_found || !std::isfinite(solved.model_error)) return;
  forecast.model_error = forecast.uncertain_part * solved.model_error;
  forecast.model_error_found = true;
}

}  // namespace rollfem::modelling

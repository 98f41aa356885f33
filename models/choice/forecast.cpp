// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/choice/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// The grid with the smallest cost whose error is at most `accuracy`; solved grids cost nothing.
const Level* cheapest_level(const Forecast& forecast, double accuracy) {
  const Level* best = nullptr;
  if (forecast.cannot.empty())
    for (const Level& level : forecast.levels)
      if (forecast.error(level) <= accuracy && (best == nullptr || level.cost() < best->cost()))
        best = &level;
  return best;
}

/// As plan_of, but contacts that cannot meet the accuracy keep their solutions.
std::optional<Plan> plan_or_keep(const Contacts& contacts, std::size_t model, double accuracy,
                                 bool keep) {
  Plan plan;
  plan.model = model;
  for (const std::vector<Forecast>& models : contacts) {
    const Level* level = cheapest_level(models[model], accuracy);
    if (level == nullptr && keep) level = best_solved(models[model]);
    if (level == nullptr) return {};
    plan.levels.push_back(static_cast<std::size_t>(level - models[model].levels.data()));
    plan.seconds += level->cost();
    plan.unsolved += level->reached ? 0 : 1;
  }
  return plan;
}

/// The cheapest model with grids of at most this error within the time. With `stay`, only models
/// that have solved all contacts.
std::optional<Plan> within(const Contacts& contacts, double target, double seconds, bool stay) {
  std::optional<Plan> best;
  for (std::size_t m = 0; m < models_of(contacts); ++m) {
    if (stay && !all_solved(contacts, m)) continue;
    std::optional<Plan> plan = plan_of(contacts, m, target);
    if (plan && plan->seconds <= seconds && (!best || plan->seconds < best->seconds))
      best = std::move(plan);
  }
  return best;
}

/// The plan with the smallest error above the accuracy within the time. Empty if the solutions are
/// nearly as good.
std::optional<Plan> closest(const Contacts& contacts, double accuracy, double seconds, bool stay) {
  for (double target = next_target * accuracy; target < largest_target; target *= next_target) {
    if (const auto solved = within(contacts, next_target * target, 0.0, true)) return {};
    if (auto plan = within(contacts, target, seconds, stay)) return plan;
  }
  return {};
}

/// What follows solutions of all contacts.
std::optional<Plan> later_plan(const Contacts& contacts, double accuracy, double seconds) {
  if (auto plan = within(contacts, accuracy, seconds, false)) return plan;
  const std::size_t model = *answer(contacts);
  const auto plan = plan_or_keep(contacts, model, accuracy, true);
  if (plan && plan->unsolved > 0 && plan->seconds <= seconds) return plan;
  return closest(contacts, accuracy, seconds, std::isfinite(seconds));
}

}  // namespace

std::optional<Plan> plan_of(const Contacts& contacts, std::size_t model, double accuracy) {
  return plan_or_keep(contacts, model, accuracy, false);
}

std::optional<Plan> cheapest(const Contacts& contacts, double accuracy) {
  return within(contacts, accuracy, std::numeric_limits<double>::infinity(), false);
}

const Level* best_solved(const Forecast& forecast) {
  const Level* best = nullptr;
  for (const Level& level : forecast.levels)
    if (level.reached && (best == nullptr || *level.reached < *best->reached)) best = &level;
  return best;
}

bool all_solved(const Contacts& contacts, std::size_t model) {
  return std::all_of(contacts.begin(), contacts.end(), [&](const std::vector<Forecast>& models) {
    return best_solved(models[model]) != nullptr;
  });
}

std::size_t worst_contact(const Contacts& contacts, std::size_t model) {
  const auto worst =
      std::max_element(contacts.begin(), contacts.end(),
                       [&](const std::vector<Forecast>& a, const std::vector<Forecast>& b) {
                         return *best_solved(a[model])->reached < *best_solved(b[model])->reached;
                       });
  return static_cast<std::size_t>(worst - contacts.begin());
}

std::optional<std::size_t> answer(const Contacts& contacts) {
  const auto error = [&](std::size_t m) {
    return *best_solved(contacts[worst_contact(contacts, m)][m])->reached;
  };
  std::optional<std::size_t> best;
  for (std::size_t m = 0; m < models_of(contacts); ++m)
    if (all_solved(contacts, m) && (!best || error(m) < error(*best))) best = m;
  return best;
}

std::optional<Plan> next_plan(const Contacts& contacts, double accuracy, double seconds) {
  Contacts hoped = hopes(contacts, accuracy);
  std::size_t first = 0;
  while (first < models_of(contacts) && !able(contacts, first)) ++first;
  if (first == models_of(contacts)) return {};
  if (all_solved(contacts, first)) {
    const auto plan = later_plan(hoped, accuracy, seconds);
    return plan && plan->unsolved > 0 ? plan : std::nullopt;
  }
  for (std::vector<Forecast>& models : hoped) models = {models[first]};
  std::optional<Plan> plan = within(hoped, accuracy, seconds, false);
  if (!plan) plan = closest(hoped, accuracy, seconds, false);
  // Without any solution yet, the quickest is worth its time.
  if (!plan) plan = plan_of(hoped, 0, largest_target);
  if (plan) plan->model = first;
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

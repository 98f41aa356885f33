// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/choice/forecast.hpp"

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

/// Where no grid meets the accuracy, one within this factor of the smallest error is as good.
constexpr double near_enough = 1.25;

/// Expected model errors are known to a factor of two or three. Until one is found, it takes at
/// most half the accuracy; where it is expected to be far beyond, the grid need not be fine.
Contacts optimistic(Contacts contacts, double accuracy) {
  constexpr double worth_of_grid = 0.25;
  for (std::vector<Forecast>& models : contacts)
    for (Forecast& forecast : models)
      if (!forecast.model_error_found)
        forecast.model_error = std::min({forecast.model_error, 0.5 * accuracy,
                                         accuracy - worth_of_grid * forecast.model_error});
  return contacts;
}

/// The first solution of all contacts, on coarser grids where the time does not suffice.
Plan first_plan(const Contacts& contacts, std::size_t model, double accuracy, double seconds) {
  constexpr double largest = 100.0;  // 10 000 %
  Plan plan = *plan_of(contacts, model, accuracy);
  for (double coarse = accuracy; plan.seconds > seconds && coarse < largest; coarse *= near_enough)
    plan = *plan_of(contacts, model, coarse);
  return plan;
}

}  // namespace

std::optional<Plan> plan_of(const Contacts& contacts, std::size_t model, double accuracy) {
  Plan plan;
  plan.model = model;
  for (const std::vector<Forecast>& models : contacts) {
    const Forecast& forecast = models[model];
    if (!forecast.cannot.empty() || forecast.levels.empty()) return {};
    double least = std::numeric_limits<double>::infinity();
    for (const Level& level : forecast.levels) least = std::min(least, forecast.error(level));
    const double allowed = std::max(accuracy, least > accuracy ? near_enough * least : 0.0);
    const Level* best = nullptr;
    for (const Level& level : forecast.levels)
      if (forecast.error(level) <= allowed && (best == nullptr || level.cost() < best->cost()))
        best = &level;
    plan.levels.push_back(static_cast<std::size_t>(best - forecast.levels.data()));
    plan.error = std::max(plan.error, forecast.error(*best));
    plan.seconds += best->cost();
    plan.unsolved += best->reached ? 0 : 1;
  }
  return plan;
}

std::optional<Plan> cheapest(const Contacts& contacts, double accuracy, double seconds) {
  std::optional<Plan> best;
  for (std::size_t m = 0; m < models_of(contacts); ++m) {
    const std::optional<Plan> plan = plan_of(contacts, m, accuracy);
    if (plan && plan->error <= accuracy && plan->seconds <= seconds &&
        (!best || plan->seconds < best->seconds))
      best = plan;
  }
  return best;
}

const Level* best_solved(const Forecast& forecast) {
  const Level* best = nullptr;
  for (const Level& level : forecast.levels)
    if (level.reached && (best == nullptr || *level.reached < *best->reached)) best = &level;
  return best;
}

std::optional<std::size_t> worst_contact(const Contacts& contacts, std::size_t model) {
  std::optional<std::size_t> worst;
  double most = -1.0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Level* level = best_solved(contacts[c][model]);
    if (level == nullptr) return {};
    if (*level->reached > most) worst = c;
    most = std::max(most, *level->reached);
  }
  return worst;
}

std::optional<std::size_t> answer(const Contacts& contacts) {
  std::optional<std::size_t> best;
  double least = 0.0;
  for (std::size_t m = 0; m < models_of(contacts); ++m)
    if (const auto worst = worst_contact(contacts, m)) {
      const double error = *best_solved(contacts[*worst][m])->reached;
      if (best && error >= least) continue;
      best = m;
      least = error;
    }
  return best;
}

std::optional<Plan> next_plan(const Contacts& contacts, double accuracy, double seconds) {
  const Contacts hoped = optimistic(contacts, accuracy);
  std::size_t first = 0;
  while (first < models_of(hoped) && !plan_of(hoped, first, accuracy)) ++first;
  if (first == models_of(hoped)) return {};
  if (!worst_contact(hoped, first)) return first_plan(hoped, first, accuracy, seconds);
  std::optional<Plan> best = cheapest(hoped, accuracy, seconds);
  const std::size_t now = *answer(hoped);
  if (!best) best = plan_of(hoped, now, accuracy);  // finer grids where they help
  if (best && best->unsolved > 0 && best->seconds <= seconds) return best;
  if ((best && best->error <= accuracy) || std::isfinite(seconds)) return {};
  double least = *best_solved(hoped[*worst_contact(hoped, now)][now])->reached / near_enough;
  best.reset();
  for (std::size_t m = 0; m < models_of(hoped); ++m)
    if (const auto plan = plan_of(hoped, m, accuracy); plan && plan->error < least) {
      best = plan;
      least = plan->error;
    }
  return best;
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

void inherit_error(Forecast& forecast, const Forecast& corrected) {
  if (forecast.corrects != corrected.model || !corrected.model_error_found ||
      !std::isfinite(corrected.model_error))
    return;
  forecast.model_error = forecast.uncertain_part * corrected.model_error;
  forecast.model_error_found = true;
}

void learn_from(Forecast& forecast, const Forecast& solved, std::size_t at) {
  const Level& found = solved.levels.at(at);
  const bool corrects = forecast.corrects == solved.model;
  for (Level& level : forecast.levels) {
    if (level.solved || !std::isfinite(found.discretisation)) continue;
    const double expected = expected_of(level, found.across, found.discretisation);
    level.discretisation = corrects ? expected : std::max(level.discretisation, expected);
  }
  inherit_error(forecast, solved);
}

}  // namespace rollfem::modelling

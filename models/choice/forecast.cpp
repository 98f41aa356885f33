// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/choice/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollfem::modelling {

namespace {

template <class Visit>
void each_level(const std::vector<Forecast>& forecasts, bool unsolved, const Visit& visit) {
  for (std::size_t m = 0; m < forecasts.size(); ++m) {
    if (!forecasts[m].cannot.empty()) continue;
    for (std::size_t k = 0; k < forecasts[m].levels.size(); ++k)
      if (!unsolved || !forecasts[m].levels[k].solved) visit(m, k, forecasts[m].levels[k]);
  }
}

/// Expected discretisation error of a grid, extrapolated from another grid's error.
double expected_of(const Level& level, int across, double discretisation) {
  return discretisation * std::pow(static_cast<double>(across) / level.across, assumed_order);
}

}  // namespace

std::optional<Plan> cheapest(const std::vector<Forecast>& forecasts, double accuracy,
                             bool unsolved) {
  std::optional<Plan> plan;
  double least = std::numeric_limits<double>::infinity();
  each_level(forecasts, unsolved, [&](std::size_t m, std::size_t k, const Level& level) {
    if (!(forecasts[m].error(level) <= accuracy) || !(level.seconds < least)) return;
    least = level.seconds;
    plan = Plan{m, k};
  });
  return plan;
}

double least_error(const std::vector<Forecast>& forecasts, bool unsolved) {
  double least = std::numeric_limits<double>::infinity();
  each_level(forecasts, unsolved, [&](std::size_t m, std::size_t, const Level& level) {
    least = std::min(least, forecasts[m].error(level));
  });
  return least;
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

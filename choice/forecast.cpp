#include "choice/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollfem::choice {

namespace {

template <class Visit>
void each_level(const std::vector<Forecast>& forecasts, bool unsolved, const Visit& visit) {
  for (std::size_t m = 0; m < forecasts.size(); ++m) {
    if (!forecasts[m].cannot.empty()) continue;
    for (std::size_t k = 0; k < forecasts[m].levels.size(); ++k)
      if (!unsolved || !forecasts[m].levels[k].solved) visit(m, k, forecasts[m].levels[k]);
  }
}

/// Errors of levels that were not solved, from one that is so good.
void follow(std::vector<Level>& levels, int across, double discretisation) {
  for (Level& level : levels)
    if (!level.solved)
      level.discretisation =
          discretisation * std::pow(static_cast<double>(across) / level.across, assumed_order);
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
  follow(forecast.levels, level.across, discretisation);
}

void learn_from_corrected(Forecast& forecast, const Forecast& corrected, std::size_t at) {
  const Level& level = corrected.levels.at(at);
  follow(forecast.levels, level.across, level.discretisation);
  if (!corrected.model_error_found || !std::isfinite(corrected.model_error)) return;
  forecast.model_error = forecast.uncertain_part * corrected.model_error;
  forecast.model_error_found = true;
}

}  // namespace rollfem::choice

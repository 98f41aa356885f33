// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/solving/expected_choice.hpp"

#include "contact/base/errors.hpp"
#include "contact/result/quantities.hpp"
#include "halfspace/model/model.hpp"
#include "models/caches/machine_speed.hpp"
#include "models/choice/laws.hpp"
#include "models/solving/auto_model.hpp"
#include "models/solving/case_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace rollfem::modelling {

namespace {

using contact::Scene;

/// The worst bar of a level among the quantities with requested accuracy, as part of value or mu.
double worst_bar(const postprocess::StudyLevel& level, const contact::AccuracyRequest& asked,
                 double friction) {
  double worst = 0.0;
  for (const auto& [key, bar] : level.bars) {
    const std::string name = key.substr(0, key.find(':'));
    if (std::find(asked.of.begin(), asked.of.end(), name) == asked.of.end()) continue;
    const double whole =
        postprocess::is_coefficient(key) ? friction : std::abs(level.values.at(key));
    if (whole > 0.0) worst = std::max(worst, bar / whole);
  }
  return worst;
}

/// Elements across the smaller extent of the patch at a level of grids or cells.
int elements_across(const postprocess::StudySeries& series, const postprocess::StudyLevel& level,
                    const Scene& scene) {
  const bool cells = series.vary != "grid" || scene.contact_grid.cell_size.has_value();
  if (!cells) return static_cast<int>(level.parameter);
  const halfspace::PatchExtent extent = halfspace::PatchSearch(scene).extent();
  return static_cast<int>(std::lround(std::min(extent.length, extent.width) / level.parameter));
}

/// Replaces expected levels of a model by the levels that a study has solved.
void take_levels(const postprocess::StudySeries& series, const Scene& scene, double friction,
                 Forecast& forecast) {
  if (series.levels.empty() || (series.vary != "grid" && series.vary != "cell")) return;
  forecast.levels.clear();
  for (const postprocess::StudyLevel& level : series.levels)
    if (!level.bars.empty())
      forecast.levels.push_back({elements_across(series, level, scene),
                                 worst_bar(level, scene.accuracy, friction), level.seconds, true});
}

/// Computes the half-space's model error on the few elements that its estimate uses anyway.
void find_model_error(const Scene& scene, const Solving& how, Forecast& half) {
  if (!scene.geometry.has_surfaces() || scene.geometry.line || !how.first) return;
  Scene few = scene;
  few.contact_grid = {};
  few.contact_grid.elements_across = modelling::grids_across().front();
  few.accuracy.relative.reset();
  few.subsurface.clear();
  few.output.stress_maxima = false;
  few.options.halfspace.model_error = true;
  const auto result =
      contact::attempt([&] { return how.models->run(half.model, few, how.progress); });
  if (!result || !result->has_model_error()) return;  // the expected value stays
  half.model_error =
      contact::reached_by(*result, scene.accuracy, scene.friction_coefficient(), true).most_model;
  half.model_error_found = true;
}

/// Seconds of the expected solutions of a contact by all models.
double seconds_of(const std::vector<Forecast>& models) {
  double seconds = 0.0;
  for (const Forecast& model : models)
    for (const Level& level : model.levels) seconds += level.reached ? level.seconds : 0.0;
  return seconds;
}

/// The contacts that miss the accuracy, as expected by the model that solves all at last.
std::string missing_text(const ExpectedRun& run, std::size_t model, double accuracy) {
  const auto missing = std::count_if(
      run.contacts.begin(), run.contacts.end(),
      [&](const auto& models) { return *best_solved(models[model])->reached > accuracy; });
  return missing == 0 ? ""
                      : fmt::format("; {} of {} contacts {} expected to miss {}", missing,
                                    run.contacts.size(), missing == 1 ? "is" : "are",
                                    contact::percent(accuracy));
}

}  // namespace

ExpectedChoice expected_choice(const contact::Case& input, const contact::ModelRegistry& models) {
  const std::vector<Scene> scenes = unbalanced_scenes(input, placed_wheels(input));
  const Contacts forecasts = forecasts_here(scenes, models);
  ExpectedChoice choice;
  if (scenes.empty()) return choice;
  const contact::AccuracyRequest& asked = scenes.front().accuracy;  // the same for all scenes
  choice.accuracy = accuracy_of(asked);
  const ExpectedRun run = expected_run(forecasts, choice.accuracy, seconds_for(asked));
  choice.seconds = run.seconds;
  for (std::size_t c = 0; c < scenes.size(); ++c)
    choice.contacts.push_back({scenes[c].place, forecasts[c],
                               verdict(forecasts[c], choice.accuracy),
                               seconds_of(run.contacts[c])});
  if (run.plans.empty()) return choice;
  const std::size_t last = run.plans.back().model;
  for (std::size_t c = 0; c < scenes.size(); ++c) {
    Level level = *best_solved(run.contacts[c][last]);
    level.seconds = choice.contacts[c].seconds;
    choice.contacts[c].sentence = grid_text(run.contacts[c][last], level);
  }
  choice.sentence = time_text(run) + (input.has_profiles() ? ", after the balance" : "") +
                    missing_text(run, last, choice.accuracy);
  for (std::size_t m = 0; m < models_of(run.contacts); ++m)
    if (m != last) choice.sentence += "; " + not_taken(forecasts, m, choice.accuracy);
  return choice;
}

std::string expected_choice_text(const contact::Case& input, const contact::ModelRegistry& models) {
  const auto choice = contact::attempt([&] { return expected_choice(input, models); });
  if (!choice) return "";  // the solver will report it
  const std::optional<MachineSpeed> speed = machine_speed();
  std::string text = fmt::format(
      "\nexpected choice of the model auto, from the size of the contact alone{}\n",
      speed
          ? fmt::format("; times are for this machine, {:.2f} times those of the reference "
                        "machine (rollfem bench, {})",
                        speed->times, speed->made.substr(0, 10))
          : "; times are for an idle 2.5 GHz core; rollfem bench calibrates them to this machine");
  for (const ExpectedContact& contact : choice->contacts)
    text += fmt::format("  {}{}\n", contact.place ? contact.place->label() + ": " : "",
                        contact.sentence);
  if (!choice->sentence.empty())
    text += fmt::format("  for {}: {}\n", contact::percent(choice->accuracy), choice->sentence);
  return text;
}

void add_choice(const Scene& scene, const Solving& how, double friction,
                postprocess::StudyPlace& place) {
  auto found = contact::attempt([&] { return forecasts_of(scene, *how.models); });
  if (!found) return;  // no patch, so no expectation
  std::vector<Forecast>& forecasts = *found;
  Forecast& half = forecasts.front();
  for (const postprocess::StudySeries& series : place.series)
    for (Forecast& forecast : forecasts)
      if (series.model == forecast.model) take_levels(series, scene, friction, forecast);
  const bool solved = std::any_of(half.levels.begin(), half.levels.end(),
                                  [](const Level& level) { return level.solved; });
  if (solved && half.cannot.empty()) {
    find_model_error(scene, how, half);
    for (Forecast& other : forecasts) inherit_error(other, half);
  }
  for (const double percent : {5.0, 1.0, 0.2})
    place.choice.emplace_back(percent, modelling::verdict(forecasts, 0.01 * percent));
}

}  // namespace rollfem::modelling

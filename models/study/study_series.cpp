// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/base/errors.hpp"
#include "contact/base/threads.hpp"
#include "contact/result/derived.hpp"
#include "contact/result/quantities.hpp"
#include "contact/result/record.hpp"
#include "models/study/study.hpp"
#include "theories/theory_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>
#include <tuple>

namespace rollfem::modelling {

namespace {

using contact::InputError;
using postprocess::StudyLevel;
using postprocess::StudyPlace;
using postprocess::StudySeries;
using postprocess::StudyValues;

/// Keys of a study with their load point (from 0) and quantity. The value is 0 if the model does
/// not give the quantity.
std::vector<std::tuple<std::string, std::size_t, std::string>> keys_of(
    const contact::ModelResult& result, bool patch) {
  std::vector<std::tuple<std::string, std::size_t, std::string>> keys;
  if (result.points.empty()) return keys;
  const auto put = [&](const char* name) {
    if (contact::quantity(result.points.front(), name) != 0.0) keys.emplace_back(name, 0, name);
  };
  put("max_pressure");
  // A patch of profiles is no ellipse.
  put(patch ? "contact_length" : "semi_axis_x");
  put(patch ? "contact_width" : "semi_axis_y");
  put("approach");
  for (std::size_t k = 0; k < result.points.size(); ++k) {
    if (!(result.points[k].max_traction > 0.0)) continue;
    const auto add = [&](const char* name) {
      keys.emplace_back(fmt::format("{}:{}", name, k + 1), k, name);
    };
    const auto found = [&](const char* name) {
      return contact::found_for_force(result.points[k], name);
    };
    add(found("longitudinal_creepage") ? "longitudinal_creepage" : "traction_coefficient");
    if (found("lateral_creepage")) add("lateral_creepage");
  }
  return keys;
}

StudyValues values_of(const contact::ModelResult& result, bool patch) {
  StudyValues values;
  for (const auto& [key, point, name] : keys_of(result, patch))
    values[key] = contact::quantity(result.points[point], name);
  return values;
}

StudyValues bars_of(const contact::ModelResult& result, bool patch) {
  StudyValues bars;
  for (const auto& [key, point, name] : keys_of(result, patch)) {
    const auto& estimates = result.points[point].error_estimate;
    if (const auto bar = estimates.find(name); bar != estimates.end()) bars[key] = bar->second;
  }
  return bars;
}

/// Hertz's values if they are exact for the case.
StudyValues exact_values(const contact::Scene& scene) {
  if (scene.has_profiles()) return {};
  try {
    return values_of(theories::models().run("hertz", scene, {}), false);
  } catch (const InputError&) {
    return {};
  }
}

bool parallel(const LevelPlan& plan, const StudyRun& work) {
  return work.how.models->at(plan.series.model).parallel;
}

/// The load points of one level. Their records carry the seconds spent on the level so far, so that
/// the cost of a resumed level covers all calls.
class LevelPoints : public contact::CheckpointPart {
 public:
  using CheckpointPart::CheckpointPart;
  std::optional<std::string> find(const std::string& name) override {
    const std::optional<std::string> bytes = CheckpointPart::find(name);
    if (!bytes) return {};
    double seconds = 0.0;
    std::string content;
    if (!contact::reads(contact::Record(*bytes), [&](auto& r) { r.values(seconds, content); })) {
      refuse(name);
      return {};
    }
    before_ = std::max(before_, seconds);
    return content;
  }
  void keep(const std::string& name, const std::string& content) override {
    const double seconds = before_ + std::chrono::duration<double>(Clock::now() - begin_).count();
    CheckpointPart::keep(name, contact::record_of(seconds, content));
  }
  /// Seconds of earlier calls; known after the level is solved.
  double seconds_before() const { return before_; }

 private:
  using Clock = std::chrono::steady_clock;
  double before_ = 0.0;
  Clock::time_point begin_ = Clock::now();
};

void exchange(contact::Record& record, StudyLevel& level) {
  record.values(level.label, level.parameter, level.unknowns, level.contact_elements);
  record.values(level.seconds, level.values, level.bars, level.noise);
}

/// Name of a stored level, from place, model and level as the study shows them.
std::string record_name(const std::string& place, const StudySeries& series,
                        const StudyLevel& level) {
  // The exact parameter is part of the name, because labels are rounded; it belongs to the last
  // refined quantity.
  std::string name = fmt::format("level-{}-{}-{}-{}-{:.12g}", place, series.model, series.vary,
                                 level.label, level.parameter);
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return std::isalnum(c) == 0 && c != '.' && c != '-'; }, '-');
  return name;
}

/// The level as stored by an earlier call, otherwise solved. Collective for a parallel model.
StudyLevel level_of(const LevelPlan& plan, const contact::RefinedInput& wanted,
                    const StudySeries& series, const std::string& place,
                    const std::vector<std::string>& notes, const StudyRun& work) {
  StudyLevel level;
  level.label = wanted.label;
  level.parameter = wanted.parameter;
  const std::string name = record_name(place, series, level);
  std::string kept;
  if (work.kept != nullptr) kept = work.kept->find(name).value_or("");
  // Several processes agree on what the first one has stored.
  if (parallel(plan, work) && !work.how.together && work.how.session != nullptr)
    kept = work.how.session->from_first(kept);
  const StudyLevel empty = level;
  const auto read = [&](contact::Record& record) { exchange(record, level); };
  if (!kept.empty() && contact::reads(contact::Record(kept), read)) {
    work.say(fmt::format("{} {}: resumed", plan.series.model, level.label));
    return level;
  }
  level = empty;
  if (!kept.empty() && work.kept != nullptr) work.kept->refuse(name);
  const std::string prefix = name + "-of-";
  LevelPoints points(work.kept, prefix);
  Solving how = work.how;
  how.checkpoint = &points;
  how.progress = [&](contact::ProgressEvent event) {
    event.stage = wanted.label + ": " + event.stage;
    contact::report(work.how.progress, event);
  };
  const contact::ModelResult result = solve_scene(plan.series.model, wanted.input, notes, how);
  level.unknowns = result.unknowns;
  level.contact_elements = result.contact_elements;
  level.seconds = points.seconds_before() + result.total_seconds();
  level.values = values_of(result, wanted.input.has_profiles());
  level.bars = bars_of(result, wanted.input.has_profiles());
  for (const contact::PointResult& point : result.points)
    level.noise = std::max(level.noise, point.residual);
  if (work.kept != nullptr) {
    contact::Record record;
    exchange(record, level);
    work.kept->keep(name, record.bytes());
    work.kept->drop(prefix);
  }
  work.say(fmt::format("{} {}: {:.2g} s", plan.series.model, level.label, level.seconds));
  return level;
}

/// If a level is too coarse to be meshed or solved, the series begins with a finer one. After a
/// solved level a failure ends the series, because limits need consecutive levels.
StudySeries run_series(const LevelPlan& plan, const std::string& place,
                       const std::vector<std::string>& notes, const StudyRun& work) {
  StudySeries series = plan.series;
  const contact::ModelInfo& model = work.how.models->at(series.model);
  series.measures_others = model.name == work.how.models->reference().name;
  series.limit_of_its_own = !model.half_spaces;
  const bool on_all_threads = parallel(plan, work);
  if (!on_all_threads && !work.how.first) return series;
  std::vector<StudyLevel> levels(plan.levels.size());
  std::vector<std::exception_ptr> errors(levels.size());
  const auto solve = [&](std::size_t k) {
    if (!work.how.share.holds(k)) return;
    try {
      levels[k] = level_of(plan, plan.levels[k], series, place, notes, work);
    } catch (const contact::Failure&) {
      errors[k] = std::current_exception();
    }
  };
  if (!on_all_threads) contact::for_each_index(levels.size(), solve);
  for (std::size_t k = 0; k < levels.size(); ++k) {
    if (!work.how.share.holds(k)) continue;
    const contact::RefinedInput& wanted = plan.levels[k];
    if (on_all_threads) solve(k);
    try {
      if (errors[k]) std::rethrow_exception(errors[k]);
      series.levels.push_back(std::move(levels[k]));
      continue;
    } catch (const contact::Failure& error) {
      if (!work.how.together) throw;  // the others may be inside a collective call
      work.say(fmt::format("{} {}: no result: {}", plan.series.model, wanted.label, error.what()));
      const bool too_coarse =
          series.levels.empty() && error.cause() != contact::Failure::Cause::solution;
      std::string& list = too_coarse ? series.left_out : series.failure;
      if (list.find(error.what()) == std::string::npos)
        list += fmt::format("{}{}: {}", list.empty() ? "" : "; ", wanted.label, error.what());
    }
    if (!series.levels.empty() && work.how.share.whole()) break;
  }
  if (series.levels.empty() && !series.left_out.empty()) {
    series.failure += (series.failure.empty() ? "" : "; ") + series.left_out;
    series.left_out.clear();
  }
  return series;
}

/// The places of the case, before any level is solved.
std::vector<StudyPlace> places_of(const Scenes& scenes) {
  std::vector<StudyPlace> places;
  for (const contact::Scene& scene : scenes.list) {
    StudyPlace place;
    place.place = scene.place;
    for (const contact::LoadPoint& point : scene.points) place.creepages.push_back(point.creepage);
    place.exact = exact_values(scene);
    places.push_back(std::move(place));
  }
  return places;
}

/// All series of a place. A theory that does not accept it throws when it runs; "all" then leaves
/// it out.
void run_place(const StudyWishes& wishes, const std::vector<std::string>& models,
               const contact::Scene& scene, const std::vector<std::string>& notes,
               StudyPlace& place, StudyRun work) {
  const std::string name = place_name(place);
  const auto say = work.say;
  std::mutex one_at_a_time;
  work.say = [&](const std::string& text) {
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    say(name.empty() ? text : name + ": " + text);
  };
  for (const std::string& model : models)
    for (const LevelPlan& plan : level_plans(scene, work.how.models->at(model), wishes.vary,
                                             wishes.together, wishes.levels)) {
      StudySeries series = run_series(plan, place_key(place), notes, work);
      if (series.levels.empty() && wishes.all())
        work.say(fmt::format("{} is left out: {}", model, series.failure));
      else
        place.series.push_back(std::move(series));
    }
}

}  // namespace

Study::Study(StudyWishes wishes, const contact::Case& input, const contact::ModelRegistry& known,
             postprocess::Provenance provenance, const contact::Progress& progress)
    : wishes_(std::move(wishes)),
      scenes_(scenes_of(input, placed_wheels(input), progress)),
      models_(models_of(wishes_, scenes_, known)) {
  record_.title = input.title;
  record_.case_file = input.file;
  record_.case_text = input.text;
  record_.friction = input.friction_coefficient;
  record_.provenance = std::move(provenance);
  record_.places = places_of(scenes_);
  if (input.has_profiles()) {
    record_.notes = scenes_.notes;
    record_.notes.emplace_back(
        "the balance of the wheelset is found once: all levels of a patch have the same normal "
        "force and creepages, so that only the discretisation differs");
  }
  read_references(wishes_, record_);
}

void Study::solve(const StudyRun& run) {
  for (std::size_t k = 0; k < scenes_.list.size(); ++k)
    run_place(wishes_, models_, scenes_.list[k], scenes_.notes, record_.places[k], run);
}

std::string Study::finish() {
  std::string failures;
  bool any = false;
  std::vector<StudyPlace> places;
  for (StudyPlace& place : record_.places) {
    for (const StudySeries& series : place.series) {
      any = any || !series.levels.empty();
      if (!series.failure.empty()) failures += (failures.empty() ? "" : "; ") + series.failure;
    }
    // Without series, all models were left out: the place has no results.
    if (!place.series.empty()) places.push_back(std::move(place));
  }
  record_.places = std::move(places);
  if (!any) throw contact::SolveError(failures);
  return failures;
}

}  // namespace rollfem::modelling

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/study/study.hpp"

#include "app/frame/parts.hpp"
#include "app/study/study_checkpoint.hpp"
#include "app/study/study_checks.hpp"
#include "app/study/study_levels.hpp"
#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "contact/result/quantities.hpp"
#include "models/registry.hpp"
#include "models/solving/case_scenes.hpp"
#include "models/solving/expected_choice.hpp"
#include "models/solving/solving.hpp"
#include "postprocess/files/files_together.hpp"
#include "postprocess/study/study.hpp"
#include "theories/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <tuple>

namespace rollfem::app {

namespace {

using contact::InputError;
using postprocess::StudyLevel;
using postprocess::StudyPlace;
using postprocess::StudySeries;
using postprocess::StudyValues;

/// Keys of a study, each with its load point (from 0) and quantity. A value of 0 means that the
/// model does not give it.
std::vector<std::tuple<std::string, std::size_t, std::string>> keys_of(
    const contact::ModelResult& result, bool patch) {
  std::vector<std::tuple<std::string, std::size_t, std::string>> keys;
  if (result.points.empty()) return keys;
  const auto put = [&](const char* name) {
    if (contact::quantity(result.points.front(), name) != 0.0) keys.emplace_back(name, 0, name);
  };
  put("max_pressure");
  // A patch of profiles is not an ellipse.
  put(patch ? "contact_length" : "semi_axis_x");
  put(patch ? "contact_width" : "semi_axis_y");
  put("approach");
  for (std::size_t k = 0; k < result.points.size(); ++k)
    if (result.points[k].max_traction > 0.0)
      keys.emplace_back(fmt::format("traction_coefficient:{}", k + 1), k, "traction_coefficient");
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

/// Hertz's values, if they are exact for the case.
StudyValues exact_values(const contact::Scene& scene) {
  if (scene.has_profiles()) return {};
  try {
    return values_of(theories::models().run("hertz", scene, {}), false);
  } catch (const InputError&) {
    return {};
  }
}

/// Data shared by all series of a study.
struct Work {
  modelling::Solving how;
  postprocess::CheckpointFolder* kept = nullptr;  ///< on the first process
  std::vector<std::string> notes;                 ///< on the scenes
  std::function<void(const std::string&)> say;
};

bool parallel(const LevelPlan& plan, const Work& work) {
  return work.how.models->at(plan.model).parallel;
}

/// Takes the level from an earlier call or solves it. Collective for a parallel model.
StudyLevel level_of(const LevelPlan& plan, const contact::RefinedInput& wanted,
                    const StudySeries& series, const std::string& place, const Work& work) {
  StudyLevel level;
  level.label = wanted.label;
  level.parameter = wanted.parameter;
  const std::string name = level_record_name(place, series, level);
  const bool several = parallel(plan, work) && !work.how.together;
  if (const auto kept = find_level(work.kept, name, several ? work.how.session : nullptr)) {
    work.say(fmt::format("{} {}: resumed", plan.model, level.label));
    return *kept;
  }
  LevelPoints points(work.kept, name);
  modelling::Solving how = work.how;
  how.checkpoint = &points;
  how.progress = [&](contact::ProgressEvent event) {
    event.stage = wanted.label + ": " + event.stage;
    contact::report(work.how.progress, event);
  };
  const contact::ModelResult result =
      modelling::solve_scene(plan.model, wanted.input, work.notes, how);
  const auto total = result.seconds.find("total");
  level.unknowns = result.unknowns;
  level.contact_elements = result.contact_elements;
  level.seconds = points.seconds_before() + (total == result.seconds.end() ? 0.0 : total->second);
  level.values = values_of(result, wanted.input.has_profiles());
  level.bars = bars_of(result, wanted.input.has_profiles());
  for (const contact::PointResult& point : result.points)
    level.noise = std::max(level.noise, point.residual);
  keep_level(work.kept, name, level);
  points.drop();
  work.say(fmt::format("{} {}: {:.2g} s", plan.model, level.label, level.seconds));
  return level;
}

/// If a level is too coarse to be meshed or solved, the series starts with a finer one. After a
/// solved level a failure ends the series, because extrapolation needs consecutive levels.
StudySeries run_series(const LevelPlan& plan, const std::string& place, const Work& work) {
  StudySeries series;
  series.model = plan.model;
  series.vary = plan.vary;
  series.parameter = plan.parameter;
  series.ratio = plan.ratio;
  const contact::ModelInfo& model = work.how.models->at(plan.model);
  series.measures_others = model.name == work.how.models->reference().name;
  series.limit_of_its_own = model.keeps_bodies;
  if (!parallel(plan, work) && !work.how.first) return series;
  for (std::size_t k = 0; k < plan.levels.size(); ++k) {
    if (!work.how.share.holds(k)) continue;
    const contact::RefinedInput& wanted = plan.levels[k];
    const auto failed = [&](const std::exception& error, std::string& list) {
      if (!work.how.together) throw;  // the others may be inside a collective call
      work.say(fmt::format("{} {}: no result: {}", plan.model, wanted.label, error.what()));
      if (list.find(error.what()) == std::string::npos)
        list += fmt::format("{}{}: {}", list.empty() ? "" : "; ", wanted.label, error.what());
    };
    try {
      series.levels.push_back(level_of(plan, wanted, series, place, work));
      continue;
    } catch (const contact::UnfitGrid& error) {
      failed(error, series.levels.empty() ? series.left_out : series.failure);
    } catch (const contact::SolveError& error) {
      failed(error, series.failure);
    } catch (const InputError& error) {
      failed(error, series.levels.empty() ? series.left_out : series.failure);
    }
    if (!series.levels.empty() && work.how.share.whole()) break;
  }
  if (series.levels.empty() && !series.left_out.empty()) {
    series.failure += (series.failure.empty() ? "" : "; ") + series.left_out;
    series.left_out.clear();
  }
  return series;
}

/// The places of the case with the values known before any level is solved.
std::vector<StudyPlace> places_of(const modelling::Scenes& scenes) {
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

/// Runs all series of a place. Under "all", a theory that turns out unable to take the place is
/// left out.
void run_place(const StudyRequest& request, const std::vector<std::string>& models,
               const contact::Scene& scene, StudyPlace& place, Work work) {
  const std::string name = place_name(place);
  const auto say = work.say;
  work.say = [&](const std::string& text) { say(name.empty() ? text : name + ": " + text); };
  const bool all = !request.models.empty() && request.models.front() == "all";
  for (const std::string& model : models)
    for (const LevelPlan& plan : level_plans(scene, work.how.models->at(model), request.vary,
                                             request.together, request.levels)) {
      StudySeries series = run_series(plan, place_key(place), work);
      if (series.levels.empty() && all)
        work.say(fmt::format("{} is left out: {}", model, series.failure));
      else
        place.series.push_back(std::move(series));
    }
}

/// Failures of all series in one text; throws if no level was solved.
std::string failures_of(const postprocess::StudyRecord& record) {
  std::string failures;
  bool any = false;
  for (const StudyPlace& place : record.places)
    for (const StudySeries& series : place.series) {
      any = any || !series.levels.empty();
      if (!series.failure.empty()) failures += (failures.empty() ? "" : "; ") + series.failure;
    }
  if (!any) throw contact::SolveError(failures);
  return failures;
}

void write_and_tell(const StudyRequest& request, const postprocess::StudyRecord& record) {
  const std::string directory = directory_of(request).string();
  postprocess::FilesTogether files(directory);
  files.write("study.json", postprocess::study_json(record));
  files.write("study.csv", postprocess::study_csv(record));
  files.commit();
  const bool drawn = request.report && report_drawn(directory);
  if (request.quiet) return;
  std::cout << record.title << "\n\n" << postprocess::study_table(record);
  for (const std::string& note : record.notes) std::cout << '\n' << note << '\n';
  std::cout << "\nresults: " << directory << '\n';
  if (drawn) std::cout << "report:  " << directory << "/study.html\n";
}

postprocess::StudyRecord record_of(const StudyRequest& request, const contact::Case& input,
                                   const modelling::Scenes& scenes, const CommandFrame& frame) {
  postprocess::StudyRecord record;
  record.title = input.title;
  record.case_file = input.file;
  record.case_text = input.text;
  record.friction = input.friction_coefficient;
  record.provenance = frame.provenance();
  record.places = places_of(scenes);
  if (input.has_profiles()) {
    record.notes = scenes.notes;
    record.notes.emplace_back(
        "the balance of the wheelset is computed once: all levels of a patch have the same normal "
        "force and creepages, so that only the discretisation differs");
  }
  read_references(request, record);
  return record;
}

/// Removes places without any series (every model left out).
void forget_empty(std::vector<StudyPlace>& places) {
  places.erase(std::remove_if(places.begin(), places.end(),
                              [](const StudyPlace& place) { return place.series.empty(); }),
               places.end());
}

void study_at_once(const StudyRequest& request, const contact::ModelRegistry& known) {
  const contact::Case input =
      contact::read_case(request.case_file, modelling::model_words(known), request.changes);
  CommandFrame frame(request, known, named_models(request, known));
  if (frame.idle()) return;
  if (frame.first()) warn_of_doubts(input);
  check_call(request, input, known);
  frame.own(directory_of(request));
  const modelling::Scenes scenes =
      modelling::scenes_of(input, modelling::placed_wheels(input), frame.progress());
  const std::vector<std::string> models = models_of(request, scenes, known);
  postprocess::StudyRecord record = record_of(request, input, scenes, frame);
  frame.compute("--model", "levels", [&](const modelling::Solving& how) {
    Work work;
    work.how = how;
    work.how.share = request.share;
    work.notes = scenes.notes;
    work.say = [&](const std::string& text) { frame.say("study: " + text); };
    work.kept = frame.keep_in(directory_of(request), input);
    for (std::size_t k = 0; k < scenes.list.size(); ++k)
      run_place(request, models, scenes.list[k], record.places[k], work);
    frame.clear_line();
    if (!how.first || frame.ends_part()) return;
    for (std::size_t k = 0; k < scenes.list.size(); ++k)
      if (!record.places[k].series.empty())
        modelling::add_choice(scenes.list[k], how, record.friction, record.places[k]);
    forget_empty(record.places);
    const std::string failures = failures_of(record);
    write_and_tell(request, record);
    if (!failures.empty())
      throw contact::SolveError("the study was written without the levels that failed: " +
                                failures);
    frame.forget_kept();
  });
}

}  // namespace

void study(StudyRequest request, const contact::ModelRegistry& known) {
  check_division(request, 2, "");  // a study has several levels
  const bool divisible = !modelling::any_parallel(known, named_models(request, known));
  in_parts(request, divisible, directory_of(request), [&] { study_at_once(request, known); });
}

}  // namespace rollfem::app

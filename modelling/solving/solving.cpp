// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/solving/solving.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "halfspace/patch/load_sharing.hpp"
#include "modelling/solving/auto_model.hpp"
#include "modelling/solving/history_run.hpp"
#include "result/bars.hpp"
#include "result/patch_size.hpp"
#include "result/quantities.hpp"
#include "result/refinement.hpp"
#include "track/balance/balance.hpp"
#include "track/motion/placed_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <iterator>
#include <optional>
#include <utility>

namespace rollfem::modelling {

namespace {

using result::MissingModel;

/// Results, and the models without one.
struct Solved {
  std::vector<contact::ModelResult> results;
  std::vector<MissingModel> missing;
  std::exception_ptr conformal;  ///< the contact::ConformalContact for which a model is missing
};

/// What a call finds at the positions of its part.
struct Part {
  Scenes scenes;
  Solved solved;
  std::string advice;

  void append(Part&& other) {
    const auto move_to = [](auto& from, auto& to) {
      std::move(from.begin(), from.end(), std::back_inserter(to));
    };
    move_to(other.scenes.list, scenes.list);
    move_to(other.scenes.pairs, scenes.pairs);
    move_to(other.solved.results, solved.results);
    for (MissingModel& model : other.solved.missing)
      if (std::none_of(solved.missing.begin(), solved.missing.end(),
                       [&](const MissingModel& known) { return known.model == model.model; }))
        solved.missing.push_back(std::move(model));
    if (advice.empty()) advice = std::move(other.advice);
  }
};

/// Adds model and patch to progress events, because a model may run another one.
contact::Progress labelled(const contact::ModelInfo& model, const contact::Scene& scene,
                           const contact::Progress& progress) {
  const std::string patch = scene.place ? scene.place->label() + ": " : "";
  return [name = model.name, patch, progress](contact::ProgressEvent event) {
    event.model = name;
    event.stage = patch + event.stage;
    contact::report(progress, event);
  };
}

/// Note on the regions of one contact that share its load on one grid, at the first load point.
std::string parts_note(const contact::ContactPlace& place, const contact::ModelResult& result) {
  const auto parts = contact::patch_parts(result.grid, result.points.front().fields);
  std::string text = fmt::format(
      "{} patches on one grid share the load and interact elastically (first load point, the most "
      "loaded first): ",
      parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k)
    text += fmt::format("{}y_track {:.3f} mm (y {:.3f}) {:.4g} by {:.4g} mm, F_n {:.5g} N",
                        k > 0 ? "; " : "", track::track_y(place, parts[k].y), parts[k].y,
                        parts[k].length, parts[k].width, parts[k].normal_force);
  return text;
}

/// Note on the force along y that a single plane neglects where its patches have other normals.
/// Empty if it is small.
std::string normals_note(const contact::Scene& scene, const contact::ModelResult& result,
                         bool joins_planes) {
  constexpr double worth_a_note = 0.01;  // part of the normal force
  if (scene.follows_surface > 0.0 || !joins_planes) return {};
  const contact::HeightCurve& rail = scene.geometry.surface.profiles->rail();
  double along_y = 0.0, least = contact::infinity, largest = -contact::infinity;
  for (const auto& part : contact::patch_parts(result.grid, result.points.front().fields)) {
    const double slope = rail.at(part.y).slope;
    along_y -= part.normal_force * slope;
    least = std::min(least, std::atan(slope));
    largest = std::max(largest, std::atan(slope));
  }
  if (std::abs(along_y) <= worth_a_note * result.points.front().normal_force) return {};
  return fmt::format(
      "the normals of these patches differ by {:.3g} rad: treated separately, they would exert "
      "{:.4g} N more along y than in one plane; do: run with halfspace.surface = \"curved\", which "
      "uses their own normals",
      largest - least, along_y);
}

/// Adds forces and height in the track frame with the bars that follow from those in the frame of
/// the patch. A given or exact value has no bar, nor has a share found by the wheelset's balance.
void add_on_track(const contact::ContactPlace& place, contact::PointResult& point) {
  const auto bar = [&](const char* name) { return point.bar_of(name).value_or(0.0); };
  const auto add_force = [&](const char* name, std::optional<double> contact::PointResult::*member,
                             const auto& turned) {
    point.*member = turned(point.normal_force, point.lateral_force, place);
    if (place.patches > 1)
      point.no_bar[name] = contact::NoBar::balance;
    else if (point.has_bar("normal_force") || point.has_bar("lateral_force"))
      point.error_estimate[name] = std::abs(turned(bar("normal_force"), 0.0, place)) +
                                   std::abs(turned(0.0, bar("lateral_force"), place));
    else
      point.no_bar[name] = point.no_bar["lateral_force"];
  };
  add_force("vertical_force", &contact::PointResult::vertical_force, track::vertical_force);
  add_force("lateral_force_track", &contact::PointResult::lateral_force_track,
            track::lateral_force);
  const double level = halfspace::upwards(place)[1];
  point.loaded_height = place.height + (point.approach + place.separation) / level;
  if (point.has_bar("approach"))
    point.error_estimate["loaded_height"] = bar("approach") / level;
  else
    point.no_bar["loaded_height"] = point.no_bar["approach"];
}

/// Adds to the result of a patch what the model does not know.
void finish(const contact::Scene& scene, const std::vector<contact::Note>& notes,
            const contact::ModelRegistry& models, contact::ModelResult& result) {
  if (!scene.place) return;
  const bool joins_planes = models.at(result.name).joins_planes;
  result.place = scene.place;
  result.notes.insert(result.notes.end(), notes.begin(), notes.end());
  if (!result.points.empty() && result.points.front().patch_count > 1) {
    result.notes.push_back({"patches", parts_note(*scene.place, result)});
    if (const std::string note = normals_note(scene, result, joins_planes); !note.empty())
      result.notes.push_back({"normals", note});
  }
  if (scene.place->patches > 1) {
    std::string text =
        "the contacts of this wheel lie in different planes: they share its load through a common "
        "vertical approach of half-spaces, including their mutual displacement; friction for this "
        "is taken from a solution with 24 elements across";
    if (!joins_planes) text += "; this model neglects the mutual displacement of the contacts";
    result.notes.push_back({"shared_load", std::move(text)});
  }
  for (contact::PointResult& point : result.points) add_on_track(*scene.place, point);
}

/// The models that can take every scene. For the others: a sentence, or the registry's exception.
std::vector<std::string> able_models(const contact::Case& input, const Scenes& scenes,
                                     const Solving& how, std::vector<MissingModel>& missing) {
  std::vector<std::string> able;
  for (const std::string& name : input.models) try {
      for (const contact::Scene& scene : scenes.list) how.models->check(scene, name);
      able.push_back(name);
    } catch (const contact::InputError& error) {
      if (!how.go_on) throw;
      missing.push_back({name, error.what(), false});
    }
  return able;
}

/// Notes that the model has no result, or rethrows the exception being handled.
void miss(const std::string& name, const contact::Failure& error, const Solving& how,
          Solved& solved) {
  const bool together = !how.models->at(name).parallel || how.together;
  if (!how.go_on || !together) throw;
  if (dynamic_cast<const contact::ConformalContact*>(&error) != nullptr)
    solved.conformal = std::current_exception();
  solved.missing.push_back({name, error.what(), error.cause() != contact::Failure::Cause::input});
}

/// What one model found on one scene.
struct Outcome {
  std::optional<contact::ModelResult> result;
  std::exception_ptr error;
};

/// Outcomes scene by scene, models by name. Models that run on one thread are solved side by side,
/// and beside them those that use all threads, one after the other. Without Solving::go_on what
/// follows a failure may have no outcome.
std::vector<Outcome> outcomes_of(const std::vector<std::string>& able, const Scenes& scenes,
                                 const Solving& how) {
  std::vector<Outcome> outcomes(scenes.list.size() * able.size());
  std::atomic<std::size_t> failed{outcomes.size()};
  const auto solve_one = [&](std::size_t k) {
    if (!how.go_on && k > failed) return;
    try {
      outcomes[k].result =
          solve_scene(able[k % able.size()], scenes.list[k / able.size()], scenes.notes, how);
    } catch (...) {
      outcomes[k].error = std::current_exception();
      for (std::size_t first = failed; k < first && !failed.compare_exchange_weak(first, k);) {
      }
    }
  };
  std::vector<std::size_t> on_all_threads, alone;
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    const bool parallel = how.models->at(able[k % able.size()]).parallel;
    if (parallel || how.first) (parallel ? on_all_threads : alone).push_back(k);
  }
  contact::for_each_index(1 + alone.size(), [&](std::size_t n) {
    if (n > 0) return solve_one(alone[n - 1]);
    std::vector<bool> failed_before(able.size(), false);
    for (const std::size_t k : on_all_threads) {
      if (!failed_before[k % able.size()]) solve_one(k);
      failed_before[k % able.size()] = outcomes[k].error != nullptr;
    }
  });
  return outcomes;
}

/// Models by name, scene by scene; one that fails is left out of the later scenes.
void solve_named(const std::vector<std::string>& able, const Scenes& scenes, const Solving& how,
                 Solved& solved) {
  std::vector<Outcome> outcomes = outcomes_of(able, scenes, how);
  std::vector<bool> left_out(able.size(), false);
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    const std::size_t m = k % able.size();
    if (left_out[m]) continue;
    try {
      if (outcomes[k].error) std::rethrow_exception(outcomes[k].error);
      if (outcomes[k].result) solved.results.push_back(*std::move(outcomes[k].result));
    } catch (const contact::Failure& error) {
      const auto* partly = dynamic_cast<const contact::PartlySolved*>(&error);
      if (partly != nullptr && !how.go_on) {
        solved.results.push_back(partly->result);
        continue;
      }
      miss(able[m], error, how, solved);
      left_out[m] = true;
    }
  }
}

/// `auto`, for all scenes; returns Chosen::advice.
std::string solve_chosen(const std::string& name, const Scenes& scenes, const Solving& how,
                         Solved& solved) {
  if (scenes.list.empty()) return {};
  try {
    Chosen chosen = solve_by_choice(scenes.list, how);
    for (std::size_t c = 0; c < scenes.list.size(); ++c)
      finish(scenes.list[c], scenes.notes, *how.models, chosen.results[c]);
    solved.results = std::move(chosen.results);
    return chosen.advice;
  } catch (const contact::Failure& error) {
    const auto* partly = dynamic_cast<const contact::PartlySolved*>(&error);
    if (partly == nullptr || how.go_on || scenes.list.size() > 1) {
      miss(name, error, how, solved);
    } else {
      solved.results.push_back(partly->result);
      finish(scenes.list.front(), scenes.notes, *how.models, solved.results.back());
    }
  }
  return {};
}

}  // namespace

contact::ModelResult run_model(const std::string& name, const contact::Scene& scene,
                               const Solving& how) {
  // Patches do not resume from each other's load points.
  contact::CheckpointPart kept(how.checkpoint,
                               scene.place ? scene.place->key('-') + '-' : std::string());
  return how.models->run(name, scene, labelled(how.models->at(name), scene, how.progress),
                         how.checkpoint != nullptr ? &kept : nullptr);
}

contact::ModelResult solve_scene(const std::string& model, const contact::Scene& scene,
                                 const std::vector<contact::Note>& notes, const Solving& how) {
  const auto completed = [&](contact::ModelResult result) {
    if (result.label.empty()) result.label = how.models->at(model).label;
    finish(scene, notes, *how.models, result);
    return result;
  };
  try {
    return completed(run_model(model, scene, how));
  } catch (contact::SolveError& error) {
    if (auto* partly = dynamic_cast<contact::PartlySolved*>(&error))
      partly->result = completed(std::move(partly->result));
    contact::FailurePlace place = scene.where();
    place.push_back("model " + model);
    error.put_at(place);
    throw;
  }
}

namespace {

Part solve_part(const contact::Case& input, const Placed& wheels, const Solving& how) {
  Part part;
  part.scenes = scenes_of(input, wheels, how.progress, how.checkpoint, how.own);
  const auto able = able_models(input, part.scenes, how, part.solved.missing);
  if (input.is_wheel_history())
    for (const std::string& model : able) {
      auto results = solve_history(input, *wheels, model, part.scenes, how);
      std::move(results.begin(), results.end(), std::back_inserter(part.solved.results));
    }
  else if (any_choice(*how.models, able))
    part.advice = solve_chosen(able.front(), part.scenes, how, part.solved);
  else
    solve_named(able, part.scenes, how, part.solved);
  track::check_results(input, part.solved.results);
  return part;
}

/// One position whose contacts are too close for planes of their own.
Part solve_on_common_surface(const contact::Case& input, const Placed& wheels, Solving how) {
  contact::CheckpointPart kept(how.checkpoint, "curved-");
  Solving curved = how;
  if (how.checkpoint != nullptr) curved.checkpoint = &kept;
  const contact::Case on_surface = on_common_surface(input);
  auto part =
      contact::attempt([&] { return solve_part(on_surface, placed_wheels(on_surface), curved); });
  if (!part || part->solved.conformal) return solve_part(input, wheels, how);
  for (contact::ModelResult& result : part->solved.results)
    result.notes.push_back(
        {"surface",
         "in planes of their own the contacts of a wheel grow into each other at this position: "
         "halfspace.surface = \"auto\" took their common surface (\"curved\")"});
  return *std::move(part);
}

/// With the surface chosen where the case leaves it open: position by position as soon as one of
/// them needs the common surface; finished load points of the others are in the checkpoint.
Part solve_on_fitting_surface(const contact::Case& input, const Placed& wheels,
                              const Solving& how) {
  const std::size_t positions = input.wheelset.positions();
  if (!wheels || input.surface != contact::SurfaceForm::automatic || !how.together)
    return solve_part(input, wheels, how);
  try {
    Part part = solve_part(input, wheels, how);
    if (!part.solved.conformal) return part;
  } catch (const contact::ConformalContact&) {
  }
  if (static_cast<std::size_t>(how.own.of) >= positions || input.is_wheel_history())
    return solve_on_common_surface(input, wheels, how);
  Part all;
  for (std::size_t k = 0; k < positions; ++k) {
    if (!how.own.holds(k)) continue;
    Solving here = how;
    here.own = {static_cast<int>(k), static_cast<int>(positions)};
    all.append(solve_on_fitting_surface(input, wheels, here));
  }
  return all;
}

}  // namespace

std::vector<MissingModel> solve(result::RunRecord& record, const Solving& how) {
  const Placed wheels = how.placed ? how.placed : placed_wheels(record.input);
  auto [scenes, solved, advice] = solve_on_fitting_surface(record.input, wheels, how);
  record.models = std::move(solved.results);
  record.pairs = std::move(scenes.pairs);
  std::vector<std::string> said;
  if (!record.models.empty()) {
    const contact::Scene& first = scenes.list.front();
    said = {contact::missed_text(record.models, first.accuracy, first.friction_coefficient()),
            advice};
  }
  if (wheels)
    for (const std::string& text : track::untouched_wheels(record.input, *wheels))
      said.push_back(text + ";");
  for (const std::string& text : said)
    if (!text.empty()) record.verdict += (record.verdict.empty() ? "" : " ") + text;
  if (!record.verdict.empty() && record.verdict.back() == ';') record.verdict.pop_back();
  return solved.missing;
}

}  // namespace rollfem::modelling

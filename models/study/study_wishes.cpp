// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/base/errors.hpp"
#include "contact/base/text_fields.hpp"
#include "models/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace rollfem::modelling {

namespace {

using contact::InputError;
using contact::ModelInfo;
using contact::ModelInput;
using contact::RefinedInput;
using contact::Refinement;
using postprocess::ReferenceRule;
using postprocess::StudyPlace;

/// Throws unless the program chooses the domain, so that it can be varied.
void check_domain(const contact::Case& input) {
  const char* why = nullptr;
  if (input.has_profiles())
    why = "the bodies are true sections of rail and rim, or end where their profiles do";
  else if (!input.wheel.mesh.empty() || !input.rail.mesh.empty())
    why = "the bodies end where the meshes named by the case end";
  if (why != nullptr)
    throw InputError(
        fmt::format("{}: study --vary domain: {}; allowed for this case: grid, cell, degree; do: "
                    "vary one of these, or compare runs with other [fem] length, depth and "
                    "rim_thickness, or other meshes",
                    input.file, why));
}

/// One of the models of the study must have it.
void check_varied(const StudyWishes& wishes, const std::string& word,
                  const contact::ModelRegistry& known) {
  const std::vector<std::string> names = named_models(wishes, known);
  if (std::any_of(names.begin(), names.end(),
                  [&](const std::string& name) { return can_vary(known.at(name), word); }))
    return;
  std::string allowed;
  for (const std::string& other : varied_words(known))
    allowed += fmt::format("{}{} of {}", allowed.empty() ? "" : "; ", other,
                           contact::listed(models_that_vary(known, other)));
  throw InputError(
      fmt::format("--vary {}: no model of this study can refine it; allowed: {}; do: add --model "
                  "{}, or vary something else",
                  word, allowed, models_that_vary(known, word).back()));
}

/// Prefix "left_3_1." if there are several places.
std::string prefix_of(const StudyPlace& place) {
  const std::string key = place_key(place);
  return key.empty() ? key : key + ".";
}

std::vector<std::string> quantities_of(const StudyPlace& place) {
  std::vector<std::string> all{"max_pressure", "approach"};
  if (place.place)
    all.insert(all.end(), {"contact_length", "contact_width"});
  else
    all.insert(all.end(), {"semi_axis_x", "semi_axis_y"});
  for (std::size_t k = 1; k <= place.creepages.size(); ++k)
    all.push_back(fmt::format("traction_coefficient:{}", k));
  return all;
}

[[noreturn]] void refuse_reference(const std::string& word, const std::string& why,
                                   const std::vector<StudyPlace>& places) {
  const bool patches = places.front().place.has_value();
  std::string allowed = fmt::format(
      "allowed: exact, finest, extrapolated, or QUANTITY=VALUE with max_pressure, {}, approach or "
      "traction_coefficient:N of load point N",
      patches ? "contact_length, contact_width" : "semi_axis_x, semi_axis_y");
  if (places.size() > 1)
    allowed += fmt::format(", as PLACE.QUANTITY=VALUE with one of the places {} to {}",
                           place_key(places.front()), place_key(places.back()));
  throw InputError(fmt::format("--reference {}: {}; {}; do: correct it", word, why, allowed));
}

/// Reads PLACE.QUANTITY=VALUE; with a single place PLACE may be omitted.
void read_number(const std::string& word, std::vector<StudyPlace>& places) {
  const std::size_t at = word.find('=');
  if (at == std::string::npos) refuse_reference(word, "not a reference", places);
  std::string key = word.substr(0, at);
  StudyPlace* meant = places.size() == 1 ? &places.front() : nullptr;
  for (StudyPlace& place : places)
    if (place.place && key.rfind(prefix_of(place), 0) == 0) {
      meant = &place;
      key = key.substr(prefix_of(place).size());
      break;
    }
  if (meant == nullptr)
    refuse_reference(word, "the case has several patches, and this does not name one", places);
  const auto known = quantities_of(*meant);
  if (std::find(known.begin(), known.end(), key) == known.end())
    refuse_reference(word, "unknown quantity in this case", places);
  const std::optional<double> value = contact::number_of(word.substr(at + 1));
  if (!value) refuse_reference(word, "the value is not a number", places);
  meant->given[key] = *value;
}

/// Removes output and estimates that a study does not need.
ModelInput bare(ModelInput input) {
  input.accuracy.relative.reset();
  input.subsurface.clear();
  input.output.stress_maxima = false;
  input.output.fields = false;
  return input;
}

bool is_named(const Refinement& way, const std::string& word) {
  return way.word == word || (!way.also.empty() && way.also == word);
}

LevelPlan plan_of(const ModelInput& input, const std::string& model,
                  const std::vector<Refinement>& ways, int levels) {
  LevelPlan plan;
  postprocess::StudySeries& series = plan.series;
  series.model = model;
  series.ratio = ways.empty() ? 0.0 : ways.front().ratio;
  int count = ways.empty() ? 1 : levels;
  for (const Refinement& way : ways) {
    series.vary += (series.vary.empty() ? "" : " and ") + way.word;
    series.parameter += (series.parameter.empty() ? "" : ", ") + way.parameter;
    if (way.ratio != series.ratio) series.ratio = 0.0;
    if (levels == 0) count = count == 0 ? way.levels : std::min(count, way.levels);
    if (way.fixed) count = std::min(count, way.levels);
  }
  for (int k = 0; k < count; ++k) {
    RefinedInput level{"as in the case", 0.0, bare(input)};
    std::string label;
    for (const Refinement& way : ways) {
      level = way.level(std::move(level.input), k, count);
      label += (label.empty() ? "" : ", ") + level.label;
    }
    if (!label.empty()) level.label = label;
    plan.levels.push_back(std::move(level));
  }
  return plan;
}

}  // namespace

void check_wishes(const StudyWishes& wishes, const contact::Case& input,
                  const contact::ModelRegistry& known) {
  const std::vector<std::string> words = varied_words(known);
  for (const std::string& word : wishes.vary) {
    if (std::find(words.begin(), words.end(), word) == words.end())
      throw InputError(
          fmt::format("--vary {}: cannot be refined; {}allowed: {}; do: name one of them", word,
                      contact::did_you_mean(word, words), contact::listed(words)));
    check_varied(wishes, word, known);
    if (word == "domain") check_domain(input);
  }
  if (wishes.levels != 0 && (wishes.levels < 2 || wishes.levels > 8))
    throw InputError(fmt::format("--levels {}: allowed: 2 to 8; do: correct it", wishes.levels));
}

std::vector<std::string> named_models(const StudyWishes& wishes,
                                      const contact::ModelRegistry& known) {
  if (wishes.models.empty()) return {known.reference().name};
  if (!wishes.all()) return wishes.models;
  std::vector<std::string> all;
  for (const contact::ModelInfo& model : known.all())
    if (model.built && !model.chooses) all.push_back(model.name);
  return all;
}

std::vector<std::string> models_of(const StudyWishes& wishes, const Scenes& scenes,
                                   const contact::ModelRegistry& known) {
  std::vector<std::string> able;
  for (const std::string& name : named_models(wishes, known)) try {
      for (const contact::Scene& scene : scenes.list) known.check(scene, name);
      able.push_back(name);
    } catch (const InputError&) {  // "all" means all that can
      if (!wishes.all()) throw;
    }
  return able;
}

void read_references(const StudyWishes& wishes, postprocess::StudyRecord& record) {
  for (const std::string& word : wishes.references) {
    if (word == "exact") {
      record.rule = ReferenceRule::exact;
      if (record.places.front().exact.empty())
        refuse_reference(word, "no exact value is known for this case", record.places);
    } else if (word == "finest") {
      record.rule = ReferenceRule::finest;
    } else if (word == "extrapolated") {
      record.rule = ReferenceRule::extrapolated;
    } else {
      read_number(word, record.places);
    }
  }
}

std::vector<std::string> varied_words(const contact::ModelRegistry& models) {
  std::vector<std::string> words;
  for (const ModelInfo& model : models.all())
    for (const Refinement& way : model.refinements)
      if (std::find(words.begin(), words.end(), way.word) == words.end()) words.push_back(way.word);
  return words;
}

std::vector<std::string> models_that_vary(const contact::ModelRegistry& models,
                                          const std::string& word) {
  std::vector<std::string> names;
  for (const ModelInfo& model : models.all())
    if (can_vary(model, word)) names.push_back(model.name);
  return names;
}

bool can_vary(const ModelInfo& model, const std::string& word) {
  return std::any_of(model.refinements.begin(), model.refinements.end(),
                     [&](const Refinement& way) { return is_named(way, word); });
}

std::vector<LevelPlan> level_plans(const ModelInput& input, const ModelInfo& model,
                                   const std::vector<std::string>& vary, bool together,
                                   int levels) {
  std::vector<Refinement> ways;
  if (vary.empty() && !model.refinements.empty()) ways.push_back(model.refinements.front());
  for (const std::string& word : vary)
    for (const Refinement& way : model.refinements)
      if (is_named(way, word)) ways.push_back(way);
  if (ways.size() < 2 || together) return {plan_of(input, model.name, ways, levels)};
  std::vector<LevelPlan> plans;
  for (const Refinement& way : ways) plans.push_back(plan_of(input, model.name, {way}, levels));
  return plans;
}

}  // namespace rollfem::modelling

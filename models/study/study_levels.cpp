// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/study/study_levels.hpp"

#include <algorithm>

namespace rollfem::modelling {

using contact::ModelInfo;
using contact::ModelInput;
using contact::RefinedInput;
using contact::Refinement;

namespace {

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
  plan.model = model;
  plan.ratio = ways.empty() ? 0.0 : ways.front().ratio;
  int count = ways.empty() ? 1 : levels;
  for (const Refinement& way : ways) {
    plan.vary += (plan.vary.empty() ? "" : " and ") + way.word;
    plan.parameter += (plan.parameter.empty() ? "" : ", ") + way.parameter;
    if (way.ratio != plan.ratio) plan.ratio = 0.0;
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

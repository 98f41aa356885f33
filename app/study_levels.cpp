#include "app/study_levels.hpp"

#include "contact/base/errors.hpp"
#include "halfspace/model/expected_patch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::app {

namespace {

using contact::Case;

/// Half of the patch's extents along x and y, from which the model fem takes what the case does not
/// say.
std::array<double, 2> half_extents(const Case& input, const char* key) {
  try {
    const halfspace::ExpectedPatch patch = halfspace::expected_patch(input);
    return {std::max(-patch.x_lower, patch.x_upper), 0.5 * patch.width()};
  } catch (const contact::InputError& error) {
    throw contact::InputError(
        fmt::format("{}: study: fem.{} is where the study starts, and this case has no patch to "
                    "take it from ({}); do: give fem.{}",
                    input.file, key, error.what(), key));
  }
}

/// One way to refine: the case of level k of n, its label and parameter.
struct Way {
  const char* word;
  const char* parameter;
  double ratio;
  int levels;  ///< unless the user says how many
  LevelPlan::Level (*level)(Case input, int k, int n);
};

LevelPlan::Level strips_level(Case input, int k, int /*n*/) {
  const int factor = 1 << k;
  const auto scaled = [&](int count) { return std::max(1, count / 4) * factor; };
  input.fastsim.strips = scaled(input.fastsim.strips);
  input.fastsim.strip_elements = scaled(input.fastsim.strip_elements);
  input.strip.strips = scaled(input.strip.strips);
  input.strip.strip_elements = scaled(input.strip.strip_elements);
  input.carter.strips = scaled(input.carter.strips);
  const int shown = input.models.front() == "carter"    ? input.carter.strips
                    : input.models.front() == "fastsim" ? input.fastsim.strips
                                                        : input.strip.strips;
  return {fmt::format("{} strips", shown), static_cast<double>(shown), std::move(input)};
}

/// The case's own grid is the third level.
LevelPlan::Level grid_level(Case input, int k, int /*n*/) {
  const double factor = std::exp2(k - 2);
  if (auto& cell = input.contact_grid.cell_size) {
    for (double& side : *cell) side /= factor;
    return {fmt::format("{:.4g} mm", (*cell)[0]), (*cell)[0], std::move(input)};
  }
  int& across = input.contact_grid.elements_across;
  across = std::max(2, across / 4) << k;
  return {fmt::format("{} across", across), static_cast<double>(across), std::move(input)};
}

/// The case's own cell is the last level.
LevelPlan::Level cell_level(Case input, int k, int n) {
  if (!input.fem.cell_size) {
    const auto half = half_extents(input, "cell_size");
    input.fem.cell_size = std::min(half[0], half[1]) / 8.0;
  }
  const double size = *input.fem.cell_size * std::exp2(n - 1 - k);
  input.fem.cell_size = size;
  return {fmt::format("{:.4g} mm", size), size, std::move(input)};
}

LevelPlan::Level degree_level(Case input, int k, int /*n*/) {
  input.fem.degree = k + 1;
  return {fmt::format("degree {}", k + 1), k + 1.0, std::move(input)};
}

/// The case's own domain is the last but one.
LevelPlan::Level domain_level(Case input, int k, int n) {
  if (!input.fem.extent) {
    const auto half = half_extents(input, "extent");
    input.fem.extent = 8.0 * std::max(half[0], half[1]);
  }
  const double factor = std::exp2(k - (n - 2));
  for (auto* length : {&input.fem.extent, &input.fem.width, &input.fem.depth, &input.fem.length})
    if (*length) **length *= factor;
  const double size = *input.fem.extent;
  return {fmt::format("extent {:.4g} mm", size), size, std::move(input)};
}

const std::vector<Way>& fem_ways() {
  static const std::vector<Way> all{{"cell", "FE cell", 2.0, 3, cell_level},
                                    {"degree", "degree", 0.0, 2, degree_level},
                                    {"domain", "extent", 2.0, 3, domain_level}};
  return all;
}

const std::vector<Way>& ways_of(const std::string& model) {
  static const std::vector<Way> none;
  static const std::vector<Way> strips{{"grid", "strips", 2.0, 5, strips_level}};
  static const std::vector<Way> grid{{"grid", "contact grid", 2.0, 5, grid_level}};
  if (model == "fem") return fem_ways();
  if (model == "halfspace") return grid;
  if (model == "fastsim" || model == "strip" || model == "carter") return strips;
  return none;
}

/// What is not part of the question costs nothing in a study.
Case bare(Case input, const std::string& model) {
  input.models = {model};
  input.accuracy.reset();
  input.subsurface.clear();
  input.output.stress_maxima = false;
  input.output.fields = false;
  return input;
}

/// In a study of finite elements the contact element is the cell.
std::string word_for(const std::string& model, const std::string& word) {
  return model == "fem" && word == "grid" ? "cell" : word;
}

LevelPlan plan_of(const Case& input, const std::string& model, const std::vector<Way>& ways,
                  int levels) {
  LevelPlan plan;
  plan.model = model;
  plan.ratio = ways.empty() ? 0.0 : ways.front().ratio;
  int count = ways.empty() ? 1 : levels;
  for (const Way& way : ways) {
    plan.vary += (plan.vary.empty() ? "" : " and ") + std::string(way.word);
    plan.parameter += (plan.parameter.empty() ? "" : ", ") + std::string(way.parameter);
    if (way.ratio != plan.ratio) plan.ratio = 0.0;
    if (levels == 0) count = count == 0 ? way.levels : std::min(count, way.levels);
    if (std::string(way.word) == "degree") count = std::min(count, way.levels);
  }
  for (int k = 0; k < count; ++k) {
    LevelPlan::Level level{"as in the case", 0.0, bare(input, model)};
    std::string label;
    for (const Way& way : ways) {
      level = way.level(std::move(level.input), k, count);
      label += (label.empty() ? "" : ", ") + level.label;
    }
    if (!label.empty()) level.label = label;
    plan.levels.push_back(std::move(level));
  }
  return plan;
}

}  // namespace

const std::vector<std::string>& varied_words() {
  static const std::vector<std::string> all{"grid", "cell", "degree", "domain"};
  return all;
}

bool can_vary(const std::string& model, const std::string& word) {
  const auto& ways = ways_of(model);
  return std::any_of(ways.begin(), ways.end(),
                     [&](const Way& way) { return way.word == word_for(model, word); });
}

std::vector<LevelPlan> level_plans(const Case& input, const std::string& model,
                                   const std::vector<std::string>& vary, bool together,
                                   int levels) {
  std::vector<Way> ways;
  const auto& all = ways_of(model);
  if (vary.empty() && !all.empty()) ways.push_back(all.front());
  for (const std::string& word : vary)
    for (const Way& way : all)
      if (way.word == word_for(model, word)) ways.push_back(way);
  if (ways.size() < 2 || together) return {plan_of(input, model, ways, levels)};
  std::vector<LevelPlan> plans;
  for (const Way& way : ways) plans.push_back(plan_of(input, model, {way}, levels));
  return plans;
}

}  // namespace rollfem::app

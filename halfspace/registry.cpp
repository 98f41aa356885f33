#include "halfspace/registry.hpp"

#include "contact/abilities.hpp"
#include "contact/errors.hpp"
#include "halfspace/carter.hpp"
#include "halfspace/fastsim.hpp"
#include "halfspace/hertz.hpp"
#include "halfspace/linear_theory.hpp"
#include "halfspace/model.hpp"
#include "halfspace/stress_maxima.hpp"
#include "halfspace/strip.hpp"
#include "halfspace/subsurface_fields.hpp"
#include "halfspace/vermeulen_johnson.hpp"

#include <fmt/format.h>

#include <chrono>
#include <utility>

namespace rollfem::halfspace {

using contact::Case;
using contact::ModelResult;
using contact::Progress;

namespace {

ModelResult run_fastsim_of_case(const Case& input, const Progress& progress) {
  FastsimOptions options;
  options.bound = input.fastsim.bound == contact::BoundForm::parabolic ? BoundShape::parabolic
                                                                       : BoundShape::elliptic;
  options.flexibilities = input.fastsim.flexibilities == contact::FlexibilityCount::three
                              ? Flexibilities::three
                              : Flexibilities::one;
  options.elements = input.fastsim.elements == contact::StripElementPlace::chord
                         ? FastsimElements::chord
                         : FastsimElements::grid;
  options.strips = input.fastsim.strips;
  options.strip_elements = input.fastsim.strip_elements;
  return run_fastsim(input, progress, options);
}

ModelResult run_halfspace_with_depth(const Case& input, const Progress& progress,
                                     contact::Checkpoint* checkpoint = nullptr) {
  ModelResult result = run_halfspace(input, progress, checkpoint);
  const bool maxima = input.output.stress_maxima.value_or(false);
  if (input.subsurface.empty() && !maxima) return result;
  const auto begin = std::chrono::steady_clock::now();
  for (contact::PointResult& point : result.points) {
    point.subsurface = subsurface_fields(input, result.grid, point.fields.traction);
    if (maxima) point.stress_maxima = stress_maxima(input, result.grid, point);
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.seconds["subsurface"] = seconds;
  result.seconds["total"] += seconds;
  return result;
}

const std::vector<std::pair<std::string, contact::Model>>& models() {
  static const std::vector<std::pair<std::string, contact::Model>> all{
      {"hertz", run_hertz},
      {"linear", run_linear},
      {"vermeulen-johnson", run_vermeulen_johnson},
      {"carter",
       [](const Case& c, const Progress& p) { return run_carter(c, p, c.carter.strips); }},
      {"fastsim", run_fastsim_of_case},
      {"strip",
       [](const Case& c, const Progress& p) {
         return run_strip(c, p, {c.strip.strips, c.strip.strip_elements});
       }},
      {"halfspace",
       [](const Case& c, const Progress& p) { return run_halfspace_with_depth(c, p); }},
  };
  return all;
}

}  // namespace

const std::vector<std::string>& model_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const auto& [name, model] : models()) list.push_back(name);
    return list;
  }();
  return names;
}

ModelResult run_model(const std::string& name, const Case& input, const Progress& progress,
                      contact::Checkpoint* checkpoint) {
  contact::check_able(input, name);
  if (name == "halfspace") return run_halfspace_with_depth(input, progress, checkpoint);
  for (const auto& [known, model] : models())
    if (known == name) return model(input, progress);
  throw contact::InputError(fmt::format("{}: there is no model of that name", name));
}

}  // namespace rollfem::halfspace

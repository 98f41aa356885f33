#include "halfspace/model/registry.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/abilities.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/model.hpp"
#include "halfspace/stress/stress_maxima.hpp"
#include "halfspace/stress/subsurface_fields.hpp"
#include "halfspace/theories/carter.hpp"
#include "halfspace/theories/equivalent_ellipse.hpp"
#include "halfspace/theories/fastsim.hpp"
#include "halfspace/theories/linear_theory.hpp"
#include "halfspace/theories/strip.hpp"
#include "halfspace/theories/vermeulen_johnson.hpp"

#include <fmt/format.h>

#include <chrono>
#include <utility>

namespace rollfem::halfspace {

using contact::Case;
using contact::ModelResult;
using contact::Progress;

namespace {

ModelResult run_fastsim_of_case(const Case& input, const Progress& progress) {
  return run_fastsim(input, progress, input.fastsim);
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

/// A theory of an elliptic patch, on the equivalent ellipse where the case has true profiles.
contact::Model elliptic(contact::Model theory, bool no_spin = false) {
  const auto model = [theory = std::move(theory), no_spin](const Case& c, const Progress& p) {
    return c.patch ? run_on_ellipse(theory, c, p, no_spin) : theory(c, p);
  };
  return [model](const Case& c, const Progress& p) { return run_each_load(model, c, p); };
}

ModelResult run_strip_of_case(const Case& input, const Progress& progress) {
  return run_strip(input, progress, {input.strip.strips, input.strip.strip_elements});
}

const std::vector<std::pair<std::string, contact::Model>>& models() {
  static const std::vector<std::pair<std::string, contact::Model>> all{
      {"hertz",
       [](const Case& c, const Progress& p) {
         return c.patch ? run_hertz_of_patch(c, p) : run_hertz(c, p);
       }},
      {"linear", elliptic(run_linear)},
      {"vermeulen-johnson", elliptic(run_vermeulen_johnson, true)},
      {"carter",
       [](const Case& c, const Progress& p) { return run_carter(c, p, c.carter.strips); }},
      {"fastsim", elliptic(run_fastsim_of_case)},
      {"strip",
       [](const Case& c, const Progress& p) { return run_each_load(run_strip_of_case, c, p); }},
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

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/registry.hpp"

#include "base/errors.hpp"
#include "halfspace/halfspace_models.hpp"
#include "modelling/fem/fem_models.hpp"
#include "modelling/solving/auto_model.hpp"
#include "result/quantities.hpp"
#include "theories/theory_models.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rollfem::modelling {

using contact::ModelInfo;
using contact::ModelRegistry;

ModelRegistry built_in_models() {
  ModelRegistry models;
  models.add(auto_model());
  for (const ModelInfo& model : theories::models().all()) models.add(model);
  models.add(halfspace::models().at("halfspace"));
  models.add(hybrid_model());
  models.add(fem_model());
  return models;
}

contact::KnownNames known_names(const ModelRegistry& models) {
  return {models.names(), models.names(&ModelInfo::in_run), contact::accuracy_words()};
}

std::vector<std::string> checked_names(const ModelRegistry& models,
                                       const std::vector<std::string>& names,
                                       const std::string& option) {
  std::vector<std::string> once;
  for (const std::string& name : names) {
    static_cast<void>(models.at(name, option));
    if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
  }
  return once;
}

std::vector<std::string> built_of(const ModelRegistry& models, std::vector<std::string> names) {
  names.erase(std::remove_if(names.begin(), names.end(),
                             [&](const std::string& name) { return !models.at(name).built; }),
              names.end());
  return names;
}

void check_built(const ModelRegistry& models, const std::vector<std::string>& names,
                 const std::string& asked_by) {
  for (const std::string& name : names)
    if (!models.at(name).built)
      throw contact::InputError(
          fmt::format("{}: model {} is not in this build, which was made without deal.II; allowed: "
                      "{}; do: choose from these with --model, or build with ROLLFEM_FEM=ON",
                      asked_by, name, contact::listed(models.names(&ModelInfo::built))));
}

bool any_parallel(const ModelRegistry& models, const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return models.at(name).parallel; });
}

namespace {

/// The models of `all` for which `holds`, as "`a`, `b`", or as "all but `c`" where that is shorter.
template <class Condition>
std::string which_models(const std::vector<ModelInfo>& all, const Condition& holds) {
  std::vector<std::string> yes, no;
  for (const ModelInfo& model : all) (holds(model) ? yes : no).push_back("`" + model.name + "`");
  if (yes.empty()) return "none";
  if (no.empty()) return "all";
  return yes.size() <= no.size() + 1 ? contact::listed(yes) : "all but " + contact::listed(no);
}

}  // namespace

std::string models_markdown(const ModelRegistry& models) {
  std::string text =
      "# Models\n\n<!-- Made by `rollfem docs models` from the registry; do not edit. -->\n\nThe "
      "models that `--model` and `models` of a case file accept, cheapest first. [Which "
      "model](choice.md)\nsays where each ends. *by default in*: used by that command if neither "
      "call nor case names a model;\n*study*: what `rollfem study` refines, the first unless "
      "`--vary` says otherwise.\n\n| model | in figures | what it is | by default in | study |\n"
      "|---|---|---|---|---|\n";
  for (const ModelInfo& model : models.all()) {
    std::vector<std::string> where;
    if (model.in_run) where.emplace_back("run");
    if (model.in_compare) where.emplace_back("compare");
    std::vector<std::string> ways;
    for (const contact::Refinement& way : model.refinements) ways.push_back(way.word);
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", model.name, model.label, model.sentence,
                        contact::listed(where), contact::listed(ways));
  }
  text +=
      "\nAll models accept longitudinal creepage, force or approach, and unlike materials. For "
      "anything else a\nmodel that cannot solve the case refuses it (exit status 2) and names "
      "those that can. `hertz` gives patch and pressure of any case and leaves its friction "
      "out.\n\n| a case with | is accepted by |\n|---|---|";
  std::vector<ModelInfo> solving;  // auto checks its own candidates
  for (const ModelInfo& model : models.all())
    if (!model.chooses) solving.push_back(model);
  for (const contact::Demand demand : contact::all_demands()) {
    const auto takes = [demand](const ModelInfo& model) {
      return std::find(model.takes.begin(), model.takes.end(), demand) != model.takes.end();
    };
    text +=
        fmt::format("\n| {} | {} |", contact::demand_words(demand), which_models(solving, takes));
  }
  text +=
      fmt::format("\n| stress below the surface (the others note its absence) | {} |",
                  which_models(solving, [](const ModelInfo& model) { return model.has_stress; }));
  return text + "\n";
}

}  // namespace rollfem::modelling

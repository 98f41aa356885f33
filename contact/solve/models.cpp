#include "contact/solve/models.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/nearest_name.hpp"
#include "contact/result/validity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace rollfem::contact {

namespace {

/// Names become those of groups in files, of checkpoints, and words of a case file.
bool is_plain(const std::string& name) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  };
  return !name.empty() && name.front() != '-' && std::all_of(name.begin(), name.end(), plain);
}

}  // namespace

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

ModelRegistry& ModelRegistry::add(ModelInfo model) {
  if (!is_plain(model.name) || !(model.run || model.chooses))
    throw std::logic_error(fmt::format(
        "model \"{}\" has no run function, or a name with characters other than a-z, 0-9 and -",
        model.name));
  if (find(model.name) != nullptr)
    throw std::logic_error(fmt::format("two models are named {}", model.name));
  if (model.label.empty()) model.label = model.name;
  models_.push_back(std::move(model));
  return *this;
}

std::vector<std::string> ModelRegistry::names() const {
  std::vector<std::string> all;
  for (const ModelInfo& model : models_) all.push_back(model.name);
  return all;
}

std::vector<std::string> ModelRegistry::names(bool ModelInfo::*wanted) const {
  std::vector<std::string> all;
  for (const ModelInfo& model : models_)
    if (model.*wanted) all.push_back(model.name);
  return all;
}

const ModelInfo& ModelRegistry::reference() const {
  for (const ModelInfo& model : models_)
    if (model.has_stress) return model;
  throw std::logic_error("no registered model solves the elastic problem");
}

const ModelInfo* ModelRegistry::find(const std::string& name) const {
  const auto found = std::find_if(models_.begin(), models_.end(),
                                  [&](const ModelInfo& model) { return model.name == name; });
  return found == models_.end() ? nullptr : &*found;
}

const ModelInfo& ModelRegistry::at(const std::string& name, const std::string& asked_by) const {
  if (const ModelInfo* model = find(name)) return *model;
  throw InputError(fmt::format("{} {}: no such model; {}allowed: {}; do: name one of them",
                               asked_by, name, did_you_mean(name, names()), listed(names())));
}

std::string ModelRegistry::advice(const ModelInput& input) const {
  std::vector<std::string> able;
  const ModelInfo* best = nullptr;
  for (const ModelInfo& model : models_) {
    if (model.chooses || model.cannot(input)) continue;
    able.push_back(model.name);
    // The cheapest that solves the elastic problem; theories only where nothing else can.
    if (best == nullptr || (model.has_stress && !best->has_stress)) best = &model;
  }
  if (best == nullptr) return "allowed: no model can solve all of this case; do: change it";
  return fmt::format("allowed: {}; do: run with --model {}, or change the case", listed(able),
                     best->name);
}

void ModelRegistry::check(const ModelInput& input, const std::string& name) const {
  if (const auto reason = at(name).cannot(input))
    throw InputError(fmt::format("{}: model {}: {}; {}", input.file, name, *reason, advice(input)));
}

ModelResult ModelRegistry::run(const std::string& name, const ModelInput& input,
                               const Progress& progress, Checkpoint* checkpoint) const {
  check(input, name);
  const ModelInfo& model = at(name);
  if (!model.run) throw std::logic_error(name + " chooses one of the other models, which are run");
  ModelResult result = model.run(input, progress, checkpoint);
  const ResultKind kind{model.has_stress, model.bounded, model.half_spaces};
  check_validity(input, result, kind);
  for (std::string& warning : validity_warnings(input, result, kind))
    result.notes.push_back(std::move(warning));
  explain_bars(input, model.bars, result);
  if (result.model_error_source.empty()) result.model_error_source = model.no_model_error;
  return result;
}

}  // namespace rollfem::contact

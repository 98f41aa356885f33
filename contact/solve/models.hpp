// The registry of models, which commands, checks, help, documents, comparisons and studies
// read. A model is registered by one call of ModelRegistry::add.
#pragma once

#include "contact/solve/model.hpp"

#include <string>
#include <vector>

namespace rollfem::contact {

class ModelRegistry {
 public:
  /// Behind those that are there; the cheaper come first. Throws std::logic_error for a model
  /// without a run, a name that is there already, or one that could not name a file.
  ModelRegistry& add(ModelInfo model);

  const std::vector<ModelInfo>& all() const { return models_; }
  std::vector<std::string> names() const;
  /// Names of those that `wanted` (a member of ModelInfo) is set for.
  std::vector<std::string> names(bool ModelInfo::*wanted) const;

  /// What others are measured against where nothing else is asked for: the first that solves the
  /// elastic problem. Throws std::logic_error when there is none.
  const ModelInfo& reference() const;

  /// nullptr when there is none.
  const ModelInfo* find(const std::string& name) const;
  /// Throws InputError that lists the names. `asked_by` begins the message: "--model".
  const ModelInfo& at(const std::string& name, const std::string& asked_by = "model") const;

  /// Throws InputError when the model cannot take the problem; it names the models that can.
  void check(const ModelInput& input, const std::string& name) const;
  /// Checks and runs. What the model gives passes the gate of contact/result/validity.hpp, which
  /// throws SolveError and adds warnings to the notes.
  ModelResult run(const std::string& name, const ModelInput& input, const Progress& progress,
                  Checkpoint* checkpoint = nullptr) const;

 private:
  /// "allowed: hertz, halfspace; do: run with --model halfspace, or change the case".
  std::string advice(const ModelInput& input) const;

  std::vector<ModelInfo> models_;
};

/// "a, b, c"
std::string listed(const std::vector<std::string>& names);

}  // namespace rollfem::contact

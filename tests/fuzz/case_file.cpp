// SPDX-License-Identifier: LGPL-2.1-or-later
// A case file: read, checked, said back, and the arithmetic that `rollfem check` does with it.
#include "base/errors.hpp"
#include "case/checks/plausibility.hpp"
#include "case/reading/case_reader.hpp"
#include "scene/scene.hpp"
#include "theories/elliptic_patch.hpp"

#include "fuzz/target.hpp"
#include "support/model_keys.hpp"

using namespace rollfem;

std::string outcome_of(const std::string& input) {
  try {
    const contact::ModelRegistry& models = rollfem::testing::registered;
    const contact::KnownNames words = modelling::known_names(models);
    const contact::Case read = contact::parse_case(input, "case.toml", words);
    static_cast<void>(contact::describe(read, words));
    static_cast<void>(contact::derived_values(read));
    static_cast<void>(contact::implausible_values(read));
    if (read.has_profiles()) return "";
    const contact::Scene scene(read);
    for (const contact::ModelInfo& model : models.all()) static_cast<void>(model.cannot(scene));
    // The closed form alone: the model "hertz" would solve a half-space for its model error.
    if (!models.at("hertz").cannot(scene)) static_cast<void>(theories::run_hertz(scene, {}));
  } catch (const contact::InputError& error) {
    return error.what();
  } catch (const contact::SolveError& error) {
    return std::string("no solution: ") + error.what() + "; do: (status 1)";
  }
  return "";
}

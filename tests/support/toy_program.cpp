// SPDX-License-Identifier: LGPL-2.1-or-later
// The command-line program with an additional model and friction law, as in docs/developing.md
// under "Add a model". tests/cli/test_toy_model.py calls it.
#include "app/program.hpp"
#include "case/checks/case_checks.hpp"
#include "case/keys/key_builder.hpp"
#include "halfspace/halfspace_models.hpp"
#include "modelling/registry.hpp"

#include "support/power_law.hpp"

namespace {

using namespace rollfem;

struct StiffOptions {
  double compliance = 0.9;
};

/// The half-space with a scaled compliance.
contact::ModelResult run_stiff(const contact::ModelInput& input, const contact::Progress& progress,
                               contact::Checkpoint* checkpoint) {
  contact::ModelInput stiff = input;
  const double compliance = input.options.of<StiffOptions>().compliance;
  stiff.wheel.material.young_modulus /= compliance;
  stiff.rail.material.young_modulus /= compliance;
  stiff.material = contact::combine(stiff.wheel.material, stiff.rail.material);
  contact::ModelResult result = halfspace::models().run("halfspace", stiff, progress, checkpoint);
  result.name = "stiff";
  return result;
}

void check_stiff(const contact::GivenCase& given, contact::Case& input) {
  if (input.options.of<StiffOptions>().compliance > 0.5 || input.layer == std::nullopt) return;
  fail_at(given, "stiff.compliance", "is too small for a layer", "above 0.5", "leave out [layer]");
}

void add_stiff_keys() {
  contact::Keys<StiffOptions> keys("stiff", "Model `stiff`");
  keys.add("compliance", &StiffOptions::compliance, contact::between(0.1, 1.0),
           "Compliance over that of the bodies.");
  keys.section().complete = check_stiff;
  contact::add_section(keys);
}

contact::ModelInfo stiff_model() {
  contact::ModelInfo stiff{"stiff", "stiff half-space", "the half-space, less compliant"};
  stiff.takes = halfspace::models().at("halfspace").takes;
  stiff.run = run_stiff;
  stiff.add_keys = add_stiff_keys;
  stiff.refinements = halfspace::models().at("halfspace").refinements;
  stiff.has_stress = stiff.in_compare = true;
  return stiff;
}

}  // namespace

int main(int argc, char** argv) {
  test::add_power_law();
  return app::run_program(argc, argv, modelling::built_in_models().add(stiff_model()));
}

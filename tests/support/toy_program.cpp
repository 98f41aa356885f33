// SPDX-License-Identifier: LGPL-2.1-or-later
// The command-line program with an additional model and friction law, as in docs/developing.md
// under "Add a model". tests/cli/test_toy_model.py calls it.
#include "app/program.hpp"
#include "halfspace/halfspace_models.hpp"
#include "modelling/registry.hpp"

#include "support/power_law.hpp"

namespace {

using namespace rollfem;

/// The half-space with a compliance scaled by 0.9: bodies stiffer by 1/0.9.
contact::ModelResult run_stiff(const contact::ModelInput& input, const contact::Progress& progress,
                               contact::Checkpoint* checkpoint) {
  contact::ModelInput stiff = input;
  stiff.wheel.material.young_modulus /= 0.9;
  stiff.rail.material.young_modulus /= 0.9;
  stiff.material = contact::combine(stiff.wheel.material, stiff.rail.material);
  contact::ModelResult result = halfspace::models().run("halfspace", stiff, progress, checkpoint);
  result.name = "stiff";
  return result;
}

contact::ModelInfo stiff_model() {
  contact::ModelInfo stiff{"stiff", "stiff half-space", "the half-space, its compliance times 0.9"};
  stiff.takes = halfspace::models().at("halfspace").takes;
  stiff.run = run_stiff;
  stiff.refinements = halfspace::models().at("halfspace").refinements;
  stiff.has_stress = stiff.in_compare = true;
  return stiff;
}

}  // namespace

int main(int argc, char** argv) {
  test::add_power_law();
  return app::run_program(argc, argv, modelling::built_in_models().add(stiff_model()));
}

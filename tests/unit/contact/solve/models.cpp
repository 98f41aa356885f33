// SPDX-License-Identifier: LGPL-2.1-or-later
// The registry of models: order, refused names, and messages about models that cannot take a case.
#include "base/errors.hpp"
#include "contact/solve/model.hpp"

#include "support/temporary_folder.hpp"

namespace {

ModelInfo model(const std::string& name, const Demands& takes, bool has_stress) {
  ModelInfo info{name, "", "a model"};
  info.takes = takes;
  info.has_stress = has_stress;
  info.run = [name](const ModelInput&, const Progress&, Checkpoint*) {
    ModelResult result;
    result.name = name;
    return result;
  };
  return info;
}

std::string refused(const ModelRegistry& models, const ModelInput& input, const char* name) {
  try {
    return models.run(name, input, {}).name + " ran";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(ModelRegistry, KeepsTheOrderAndRefusesWhatCouldNotBeNamed) {
  ModelRegistry models;
  models.add(model("theory", {}, false)).add(model("solver", {Demand::rigid_body}, true));
  EXPECT_EQ(models.names(), (std::vector<std::string>{"theory", "solver"}));
  EXPECT_EQ(models.names(&ModelInfo::has_stress), std::vector<std::string>{"solver"});
  EXPECT_EQ(models.reference().name, "solver");
  EXPECT_EQ(models.at("theory").label, "theory");
  EXPECT_EQ(models.find("none"), nullptr);
  EXPECT_THROW(models.add(model("theory", {}, false)), std::logic_error);
  for (const char* name : {"", "-x", "Two", "a b", "a/b"})
    EXPECT_THROW(models.add(model(name, {}, false)), std::logic_error) << name;
  ModelInfo no_run{"empty", "", ""};
  EXPECT_THROW(models.add(no_run), std::logic_error);
  EXPECT_THROW(static_cast<void>(ModelRegistry().reference()), std::logic_error);
  EXPECT_EQ(refusal<InputError>([&] { static_cast<void>(models.at("none", "--model")); }),
            "--model none: no such model; allowed: theory, solver; do: name one of them");
}

TEST(ModelRegistry, RefusesAndNamesTheModelsThatCan) {
  ModelRegistry models;
  models.add(model("rough", {Demand::rigid_body}, false))
      .add(model("theory", {}, false))
      .add(model("solver", {Demand::rigid_body}, true));
  ModelInput input;
  input.file = "a.toml";
  EXPECT_EQ(refused(models, input, "theory"), "theory ran");
  input.rail.material.young_modulus = infinity;
  EXPECT_EQ(refused(models, input, "solver"), "solver ran");
  EXPECT_EQ(refused(models, input, "theory"),
            "a.toml: model theory: young_modulus = inf: it cannot handle a rigid body; allowed: "
            "rough, solver; do: run with --model solver, or change the case");
  input.speed = 1.0;
  input.options.fem.inertia = true;
  EXPECT_EQ(refused(models, input, "solver"),
            "a.toml: model solver: fem.inertia: it cannot handle the inertia of moving bodies; "
            "allowed: no model can solve all of this case; do: change it");
}

}  // namespace

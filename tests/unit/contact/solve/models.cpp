// SPDX-License-Identifier: LGPL-2.1-or-later
// The registry of models: order and refused names. Models that cannot take a case:
// tests/cli/test_models.py.
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

}  // namespace

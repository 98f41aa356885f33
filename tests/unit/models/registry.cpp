// SPDX-License-Identifier: LGPL-2.1-or-later
// The models of the program: refusals of each in one message that names the able models.
#include "models/registry.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"

#include "support/case_examples.hpp"

namespace {

const contact::ModelRegistry& models() {
  static const contact::ModelRegistry all = modelling::built_in_models();
  return all;
}

std::string refused(const contact::Scene& scene, const std::string& model) {
  return refusal<contact::InputError>([&] { models().check(scene, model); });
}

std::string refused(const std::string& text, const std::string& model) {
  return refused(contact::parse_case(text, "case.toml"), model);
}

void expect_refusal(const std::string& text, const std::string& model, const std::string& part) {
  EXPECT_TRUE(says(refused(text, model), part));
}

const std::string fast = "[rolling]\nspeed = 5e4\n[fem]\ninertia = true\n";

const std::string pressure = R"([friction]
coefficient = 0.4
[wheel]
rolling_radius = 500.0
[given_pressure]
semi_axis_x = 6.0
semi_axis_y = 4.0
max_pressure = 1e3
)";

TEST(ProgramModels, RefuseWhatTheyLeaveOutAndNameThoseThatCan) {
  const std::string shift =
      plus("[rolling]\nproblem = \"shift\"\n[history]\nlateral_shift = 0.1\n");
  const std::string force = plus("[rolling]\nlongitudinal_force = 1.0\n");
  for (const char* model : {"halfspace", "hybrid", "fem"}) {
    EXPECT_EQ(refused(shift, model), "");
    EXPECT_EQ(refused(force, model), "");
    EXPECT_EQ(refused(pressure, model) == "", std::string(model) != "hybrid") << model;
  }
  for (const char* model :
       {"linear", "vermeulen-johnson", "polach", "carter", "fastsim", "fastrip", "strip"}) {
    expect_refusal(shift, model,
                   "allowed: hertz, halfspace, hybrid, fem; do: run with --model halfspace");
    EXPECT_EQ(refused(small_case, model), "") << model;
  }
  for (const char* model : {"linear", "vermeulen-johnson", "polach", "carter"})
    expect_refusal(force, model, "prescribed tangential force");
  for (const char* model : {"fastsim", "fastrip", "strip"}) EXPECT_EQ(refused(force, model), "");
  EXPECT_EQ(refused(pressure, "fastsim"), "");
  const std::string rigid = with("[rail]\n", "[rail]\nyoung_modulus = inf\n");
  EXPECT_EQ(refused(rigid, "fem"), "");
  const std::string point = "[[subsurface.point]]\nbody = \"rail\"\nat = [0, 0, -1]\n";
  expect_refusal(rigid + point, "fem",
                 "subsurface: it cannot handle the stress in a rigid body; allowed: hertz, linear");
}

TEST(ProgramModels, FeelInertiaWhereItIsAskedForAndOnlyAsFiniteElements) {
  // A speed alone is no more than that, however high.
  for (const char* model : {"hertz", "carter", "halfspace", "hybrid", "fem"})
    EXPECT_EQ(refused(plus("[rolling]\nspeed = 5e6\n"), model), "") << model;
  EXPECT_EQ(refused(plus(fast), "fem"), "");
  for (const char* model : {"hertz", "carter", "halfspace", "hybrid"})
    expect_refusal(plus(fast), model,
                   "fem.inertia: it cannot handle the inertia of moving bodies; allowed: fem; do: "
                   "run with --model fem");
}

TEST(ProgramModels, RefuseCreepagesThatTheirTheoryLeavesOut) {
  const std::string spin = plus("[rolling]\nspin = 1e-4\n");
  expect_refusal(spin, "carter",
                 "rolling.spin: it cannot handle spin; allowed: hertz, linear, "
                 "vermeulen-johnson, polach, fastsim, fastrip, strip, halfspace, hybrid, fem; do: "
                 "run with --model halfspace");
  EXPECT_EQ(refused(spin, "linear"), "");
  expect_refusal(
      plus("[rolling]\nlateral_creepage = 1e-4\n"), "carter",
      "rolling.lateral_creepage: it cannot handle lateral creepage; allowed: hertz, "
      "linear, vermeulen-johnson, polach, fastsim, fastrip, strip, halfspace, hybrid, fem");
}

TEST(ProgramModels, RefuseSlipFromAFileButNotWhatTheSurfaceBrings) {
  contact::Scene scene = contact::parse_case(small_case, "case.toml");
  EXPECT_EQ(refused(scene, "linear"), "");
  scene.geometry.extra_slip = contact::ExtraSlip::file;
  scene.geometry.extra_slip_values = contact::Lattice{};
  scene.geometry.extra_slip_values->file = "slip.csv";
  EXPECT_TRUE(says(refused(scene, "linear"),
                   "rolling.extra_slip: it cannot handle extra slip from a file; allowed: hertz, "
                   "carter, fastsim, fastrip, strip, halfspace, hybrid, fem; do: run with --model "
                   "halfspace"));
}

TEST(ProgramModels, AreNamedOnlyWhereTheyTakeAllThatTheCaseAsksFor) {
  // Others take the stress in a rigid body, but not the inertia that is asked for beside it.
  expect_refusal(with("[rail]\n", fast + "[rail]\nyoung_modulus = inf\n") +
                     "[[subsurface.point]]\nbody = \"rail\"\nat = [0, 0, -1]\n",
                 "fem", "allowed: no model can solve all of this case");
}

TEST(ProgramModels, HalfSpacesEndAtTheirSurface) {
  // Wheel of -40 mm across: its surface is 0.453 mm below z = 0 at y = 6.
  std::string text = with("transverse_radius = inf", "transverse_radius = -40.0");
  text.replace(text.find("2000.0"), 6, "35.0");
  text += "[[subsurface.point]]\nat = [0, 6, -0.4]\n";
  for (const char* model : {"hybrid", "fem"}) EXPECT_EQ(refused(text, model), "") << model;
  for (const char* part : {"case.toml", "model halfspace", "beyond z = 0", "--model hybrid"})
    expect_refusal(text, "halfspace", part);
}

}  // namespace

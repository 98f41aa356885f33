// SPDX-License-Identifier: LGPL-2.1-or-later
// Case files of bodies that yield: what they become, and messages.
#include "contact/case/case_reader.hpp"
#include "contact/scene/scene.hpp"

#include "support/case_examples.hpp"

namespace {

/// A case of three creepages whose rail yields, four passes.
std::string yielding(const std::string& more) {
  return plus(
      "[rolling]\nlongitudinal_creepage = [0.0, 0.001, 0.002]\n"
      "[fem]\npasses = 4\n[rail_plasticity]\n" +
      more);
}

TEST(PlasticityKeys, GiveSteelOfOneBodyAndPassesInTurn) {
  const Case input = parse_case(
      yielding("yield_stress = 520.0\nhardening = [60e3, 15e3]\nrecovery = 300.0\n"
               "isotropic_rise = -50.0\nisotropic_rate = 20.0\nresidual_depth = [0.0, 5.0]\n"
               "residual_along = [-100.0, 0.0]\n"),
      "case.toml");
  EXPECT_FALSE(input.wheel.plasticity);
  ASSERT_TRUE(input.rail.plasticity);
  const contact::BodyPlasticity& steel = *input.rail.plasticity;
  EXPECT_EQ(steel.yield_stress, 520.0);
  EXPECT_EQ(steel.back_stresses[1].modulus, 15e3);
  EXPECT_EQ(steel.back_stresses[1].recovery, 300.0);
  EXPECT_EQ(steel.back_stresses[2].modulus, 0.0);
  EXPECT_EQ(steel.residual.along, (std::vector<double>{-100.0, 0.0}));
  const contact::Scene scene(input);
  EXPECT_TRUE(scene.yields());
  ASSERT_EQ(scene.points.size(), 4U);
  EXPECT_EQ(scene.points[2].creepage.longitudinal, 0.002);
  EXPECT_EQ(scene.points[3].creepage.longitudinal, 0.0);
}

TEST(PlasticityKeys, AreRefusedWhereTheyMeanNothing) {
  expect_error(yielding("hardening = 60e3\n"), {"rail_plasticity.yield_stress: is missing"});
  expect_error(yielding("yield_stress = 520.0\nrecovery = 300.0\n"),
               {"rail_plasticity.hardening: is missing"});
  expect_error(yielding("yield_stress = 520.0\nhardening = [1e3, 2e3, 3e3, 4e3]\n"),
               {"rail_plasticity.hardening", "has 4 back stresses"});
  expect_error(yielding("yield_stress = 520.0\nisotropic_rise = -520.0\n"),
               {"rail_plasticity.isotropic_rise", "softens the steel to nothing"});
  expect_error(yielding("yield_stress = 520.0\nresidual_depth = [5.0, 1.0]\n"
                        "residual_along = [0.0, 0.0]\n"),
               {"rail_plasticity.residual_depth", "does not ascend"});
  expect_error(plus("[fem]\npasses = 4\n"), {"fem.passes", "is for bodies that yield"});
  expect_error(plus("[rail_plasticity]\nyield_stress = 520.0\n[rolling]\nproblem = \"shift\"\n"),
               {"rail_plasticity.yield_stress", "is for steady rolling"});
}

}  // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Case files of bodies that yield: what they become.
#include "case/reading/case_reader.hpp"
#include "fem/fem_options.hpp"
#include "scene/scene.hpp"

#include "support/case_examples.hpp"
#include "support/model_keys.hpp"

namespace {

const fem::FemOptions& options_of(const Case& input) {
  return input.options.of<fem::FemOptions>();
}

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

TEST(PlasticityKeys, ListsThatBelongTogetherAreEquallyLong) {
  const std::string steel = "yield_stress = 520.0\n";
  // Those of the wheel are lists of their own.
  const Case both = parse_case(
      yielding(steel + "hardening = [60e3, 60e3]\nrecovery = 40.0\nresidual_depth = [0.0, 5.0]\n"
                       "residual_across = -100.0\n[wheel_plasticity]\nyield_stress = 400.0\n"
                       "hardening = [1e3, 2e3, 3e3]\nrecovery = [1.0, 0.0, 3.0]\n"),
      "case.toml");
  EXPECT_EQ(both.rail.plasticity->residual.across, (std::vector<double>{-100.0, -100.0}));
  EXPECT_TRUE(both.rail.plasticity->residual.along.empty());
  EXPECT_EQ(both.wheel.plasticity->back_stresses[2].recovery, 3.0);
  const std::string read = contact::describe(both);
  EXPECT_TRUE(says(read, "hardening              [60000, 60000] MPa", "recovery               40",
                   "recovery               [1, 0, 3]"));
}

TEST(PlasticityKeys, ReadResidualStressFromAFileAsFromLists) {
  const rollfem::testing::TemporaryFolder folder;
  const std::string head =
      yielding("yield_stress = 520.0\n") + "residual_file = \"measured.csv\"\n";
  const auto read = [&](const std::string& lines, const std::string& more = "") {
    folder.file("measured.csv", lines);
    return contact::read_case(folder.file("case.toml", head + more));
  };
  const Case from_lists = parse_case(
      yielding("yield_stress = 520.0\nresidual_depth = [0.0, 2.0, 5.5]\nresidual_along = "
               "[-100.0, 20.0, 0.0]\nresidual_across = [-80.0, 10.0, 0.0]\n"),
      "case.toml");
  for (const char* lines :
       {"depth, along, across\n0, -100, -80\n2, 20, 10\n5.5, 0, 0\n",
        "# X-ray, etched\n0.0 -100.0 -80.0\n\n2.0\t20.0\t10.0  # MPa\n5.5 0 0\n"}) {
    const auto found = contact::Scene(read(lines)).rail.plasticity->residual;
    const auto& expected = from_lists.rail.plasticity->residual;
    EXPECT_EQ(found.depth, expected.depth);
    EXPECT_EQ(found.along, expected.along);
    EXPECT_EQ(found.across, expected.across);
  }
  // A case that is stored elsewhere finds its file.
  const Case stored = read("0, -100, -80\n2, 20, 10\n");
  const std::string moved = contact::text_in_folder(stored, folder.path("results/run"));
  EXPECT_NE(moved.find("residual_file = \"../../measured.csv\""), std::string::npos) << moved;
}

TEST(PlasticityKeys, CountTheLoadPointsOfACycle) {
  const Case alternating = parse_case(yielding("yield_stress = 520.0\n"), "case.toml");
  EXPECT_EQ(options_of(alternating).cycle, 3);
  const Case one =
      parse_case(plus("[fem]\npasses = 4\n[rail_plasticity]\nyield_stress = 520.0\n"), "case.toml");
  EXPECT_EQ(options_of(one).cycle, 1);
}

TEST(PlasticityKeys, NoLoadPointIsLeftOut) {
  const std::string steel = "[rail_plasticity]\nyield_stress = 520.0\n";
  const std::string cycle = "[rolling]\nlongitudinal_creepage = [0.03, -0.03, 0.01]\n";
  const Case once = parse_case(plus(cycle + steel), "case.toml");
  EXPECT_EQ(options_of(once).passes, 3);
  EXPECT_EQ(contact::Scene(once).points.size(), 3U);
  EXPECT_EQ(options_of(parse_case(plus(steel), "case.toml")).passes, 1);
  const Case by_force =
      parse_case(plus("[rolling]\nlongitudinal_force = [-1e3, -2e3]\n" + steel), "case.toml");
  EXPECT_EQ(contact::Scene(by_force).points.size(), 2U);
}

}  // namespace

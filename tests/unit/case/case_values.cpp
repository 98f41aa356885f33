// SPDX-License-Identifier: LGPL-2.1-or-later
// The case from a valid file: values, defaults, broadcasting, and the texts derived from the
// declarations.
#include "case/keys/case_keys.hpp"
#include "case/reading/case_reader.hpp"
#include "scene/scene.hpp"

#include "support/case_examples.hpp"
#include "support/places.hpp"

namespace {

/// As the program has them from its registry.
const contact::KnownNames models{
    {"hertz", "strip", "halfspace", "fem"}, {"hertz", "halfspace", "fem"}, {}};

TEST(CaseValues, SmallCaseHasItsValuesAndDefaults) {
  const Case input = parse_case(small_case, "folder/small.toml", models);
  EXPECT_EQ(input.title, "small");
  EXPECT_EQ(input.file, "folder/small.toml");
  EXPECT_EQ(input.text, small_case);
  EXPECT_EQ(input.models, (std::vector<std::string>{"hertz", "halfspace", "fem"}));
  EXPECT_EQ(input.load.normal_force, 50e3);
  EXPECT_FALSE(input.load.approach);
  EXPECT_EQ(input.friction_coefficient, 0.55);
  EXPECT_EQ(input.wheel.rolling_radius, 405.0);
  EXPECT_TRUE(std::isinf(input.wheel.transverse_radius));
  EXPECT_EQ(input.rail.transverse_radius, 2000.0);
  EXPECT_EQ(input.rail.material.young_modulus, 210e3);
  EXPECT_EQ(input.wheel.material.poisson_ratio, 0.3);
  ASSERT_EQ(input.rolling.creepages.size(), 1u);
  EXPECT_EQ(input.rolling.creepages[0].longitudinal, 0.0);
  EXPECT_EQ(input.rolling.upwind_order, contact::UpwindOrder::second);
  EXPECT_EQ(input.rolling.extra_slip, contact::ExtraSlip::automatic);
  EXPECT_EQ(input.contact_grid.elements_across, 40);
  EXPECT_FALSE(input.contact_grid.cell_size);
  EXPECT_EQ(input.fem.degree, 2);
  EXPECT_EQ(input.output.paths, (std::vector<std::string>{"x", "y"}));
  EXPECT_TRUE(input.output.fields);
}

const char* const every_key = R"(title = "all keys: \"quoted\""
models = ["fem", "hertz"]
[load]
approach = 0.05
[friction]
coefficient = 0
[wheel]
rolling_radius = 460
transverse_radius = -300.0
young_modulus = 200e3
poisson_ratio = 0.25
density = 7.2e-9
[rail]
transverse_radius = 250
young_modulus = 100000
poisson_ratio = 0.0
[rolling]
longitudinal_creepage = [0, 0.001]
speed = 4e4
lateral_creepage = -0.002
spin = [1e-4, 0.0]
upwind_order = "first"
extra_slip = "none"
[contact_grid]
cell_size = [0.2, 0.3]
[fem]
cell_size = 0.5
degree = 1
extent = 60.0
fine_extent = 1.5
linear_solver = "multigrid"
inertia = true
[output]
paths = ["y"]
fields = false
)";

TEST(CaseValues, EveryKeyArrives) {
  const Case input = parse_case(every_key, "all.toml");
  EXPECT_EQ(input.title, "all keys: \"quoted\"");
  EXPECT_EQ(input.models, (std::vector<std::string>{"fem", "hertz"}));
  EXPECT_FALSE(input.load.normal_force);
  EXPECT_EQ(input.load.approach, 0.05);
  EXPECT_EQ(input.friction_coefficient, 0.0);
  EXPECT_EQ(input.wheel.rolling_radius, 460.0);
  EXPECT_EQ(input.wheel.transverse_radius, -300.0);
  EXPECT_EQ(input.wheel.material.young_modulus, 200e3);
  EXPECT_EQ(input.wheel.material.poisson_ratio, 0.25);
  EXPECT_EQ(input.wheel.material.density, 7.2e-9);
  EXPECT_EQ(input.rail.material.density, 7.85e-9);
  EXPECT_EQ(input.rolling.speed, 4e4);
  EXPECT_TRUE(contact::feels_inertia(input));
  EXPECT_EQ(input.rail.transverse_radius, 250.0);
  EXPECT_EQ(input.rail.material.young_modulus, 100e3);
  EXPECT_EQ(input.rail.material.poisson_ratio, 0.0);
  ASSERT_EQ(input.rolling.creepages.size(), 2u);
  EXPECT_EQ(input.rolling.creepages[1].longitudinal, 0.001);
  EXPECT_EQ(input.rolling.creepages[0].lateral, -0.002);
  EXPECT_EQ(input.rolling.creepages[1].lateral, -0.002);
  EXPECT_EQ(input.rolling.creepages[0].spin, 1e-4);
  EXPECT_EQ(input.rolling.creepages[1].spin, 0.0);
  EXPECT_EQ(input.rolling.upwind_order, contact::UpwindOrder::first);
  EXPECT_EQ(input.rolling.extra_slip, contact::ExtraSlip::none);
  ASSERT_TRUE(input.contact_grid.cell_size);
  EXPECT_EQ((*input.contact_grid.cell_size)[1], 0.3);
  EXPECT_EQ(input.fem.cell_size, 0.5);
  EXPECT_EQ(input.fem.degree, 1);
  EXPECT_EQ(input.fem.extent, 60.0);
  EXPECT_EQ(input.fem.fine_extent, 1.5);
  EXPECT_EQ(input.fem.linear_solver, contact::LinearSolver::multigrid);
  EXPECT_EQ(input.output.paths, std::vector<std::string>{"y"});
  EXPECT_FALSE(input.output.fields);
}

TEST(CaseValues, NoPathsAreAllowed) {
  EXPECT_TRUE(parse_case(plus("[output]\npaths = []\n"), "b.toml").output.paths.empty());
}

TEST(CaseValues, ScalarsAreBroadcastWhateverTheOrderOfTheLists) {
  for (const char* lines :
       {"[rolling]\nspin = [0.1, 0.2, 0.3]\nlongitudinal_creepage = 0.01\n",
        "[rolling]\nlongitudinal_creepage = [0.01]\nspin = [0.1, 0.2, 0.3]\n"}) {
    const Case input = parse_case(plus(lines), "b.toml");
    ASSERT_EQ(input.rolling.creepages.size(), 3u);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(input.rolling.creepages[i].longitudinal, 0.01);
      EXPECT_EQ(input.rolling.creepages[i].lateral, 0.0);
      EXPECT_EQ(input.rolling.creepages[i].spin, 0.1 * (i + 1) + (i == 2 ? 0.3 - 0.1 * 3 : 0.0));
    }
  }
}

TEST(CaseValues, DottedKeysWindowsLineEndsAndListsOverManyLinesAreRead) {
  const Case input = parse_case(
      "load.normal_force = 1_000\r\nfriction = {coefficient = 0.3}\r\nwheel.rolling_radius = "
      "405\r\n"
      "wheel.transverse_radius = inf\r\nrail.transverse_radius = 300\r\n[rolling]\r\n"
      "longitudinal_creepage = [ # braking\r\n 0.0,\r\n 0.001,\r\n]\r\n",
      "d.toml");
  EXPECT_EQ(input.load.normal_force, 1000.0);
  EXPECT_EQ(input.friction_coefficient, 0.3);
  EXPECT_EQ(input.rolling.creepages.size(), 2u);
}

TEST(CaseValues, TemplateIsAValidCaseWithTheDefaultsInIt) {
  const Case input = parse_case(contact::case_template(models), "template.toml", models);
  const Case defaults = contact::default_case();
  EXPECT_EQ(input.models, models.default_models);
  EXPECT_EQ(input.contact_grid.elements_across, defaults.contact_grid.elements_across);
  EXPECT_EQ(input.rolling.creepages.size(), 7u);
  // A caller without models accepts any name, and an empty list.
  EXPECT_TRUE(parse_case(contact::case_template(), "template.toml").models.empty());
  EXPECT_EQ(parse_case("models = [\"novel\"]\n" + small_case, "n.toml").models.front(), "novel");
}

TEST(CaseValues, DescriptionTellsValuesUnitsDefaultsAndWhatFollows) {
  const Case input = parse_case(small_case, "small.toml");
  const std::string text = contact::describe(input) + contact::derived_values(input);
  EXPECT_TRUE(
      says(text, "normal_force           50000 N\n", "young_modulus          210000 MPa  (default)",
           "A                      0.00123457 1/mm", "B                      0.00025 1/mm"));
  // E* = 210000 / (2 (1 - 0.09)), G = 210000 / 2.6
  EXPECT_TRUE(
      says(text, "E*                     115385 MPa", "G                      80769.2 MPa"));
  EXPECT_FALSE(says(text, "approach"));
}

TEST(CaseValues, AGivenValueIsNoDefaultEvenWhereItEqualsOne) {
  const std::string text = with("[wheel]", "[wheel]\nyoung_modulus = 210000");
  EXPECT_TRUE(says(contact::describe(parse_case(text, "small.toml")),
                   "young_modulus          210000 MPa\n"));
}

TEST(CaseValues, CommittedCasesAreValidAndHaveTheEllipsesOfTheStudy) {
  const std::string folder = std::string(ROLLFEM_SOURCE_DIR) + "/cases/thesis_";
  for (const char name : std::string("abcdef")) {
    const Case input = contact::read_case(folder + name + ".toml", models);
    EXPECT_EQ(input.load.normal_force, 50e3);
    EXPECT_EQ(input.friction_coefficient, 0.55);
    EXPECT_EQ(input.rolling.creepages.size(), 7u);
    EXPECT_EQ(input.rolling.extra_slip, contact::ExtraSlip::automatic);
    EXPECT_EQ(input.models.size(), 3u);
  }
}

}  // namespace

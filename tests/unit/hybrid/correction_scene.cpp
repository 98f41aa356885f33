// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hybrid/correction_scene.hpp"

#include "case/reading/case_reader.hpp"
#include "fem/fem_options.hpp"

#include "support/model_keys.hpp"
#include "support/places.hpp"
#include "support/test.hpp"

namespace {

contact::Case case_of(const std::string& name) {
  return contact::read_case(std::string(ROLLFEM_SOURCE_DIR) + "/cases/" + name + ".toml");
}

std::string key_of(const contact::Case& input) {
  return hybrid::correction_key(hybrid::correction_scene(input));
}

}  // namespace

TEST(CorrectionScene, IsThatOfTheNextPowerOfLoads) {
  contact::Case input = case_of("thesis_f");
  for (const double force : {50.0, 10e3, 50e3, 1e6}) {
    input.load.normal_force = force;
    const contact::Scene scene = hybrid::correction_scene(input);
    ASSERT_EQ(scene.points.size(), 1u);
    EXPECT_GE(*scene.points[0].load.force, force);
    EXPECT_LT(*scene.points[0].load.force, hybrid::correction_load_ratio * force * 1.000001);
    // Its own correction scene is itself.
    const contact::Scene again = hybrid::correction_scene(scene);
    EXPECT_EQ(*again.points[0].load.force, *scene.points[0].load.force);
    EXPECT_EQ(hybrid::correction_key(again), hybrid::correction_key(scene));
  }
}

TEST(CorrectionScene, KnowsNoFrictionCreepageNorGrid) {
  contact::Case input = case_of("thesis_f");
  const std::string key = key_of(input);
  input.friction_coefficient = 0.1;
  input.rolling.creepages.resize(1);
  input.rolling.creepages[0].longitudinal = 0.02;
  input.contact_grid.elements_across = 77;
  input.load.normal_force = 49e3;
  EXPECT_EQ(key_of(input), key);
}

TEST(CorrectionScene, HasTheSymmetryOfTheLoadPoints) {
  contact::Case input = case_of("thesis_a");
  EXPECT_TRUE(hybrid::correction_scene(input).is_symmetric());
  input.rolling.creepages[2].spin = 1e-4;
  EXPECT_FALSE(hybrid::correction_scene(input).is_symmetric());
}

TEST(CorrectionScene, KeyIsOfTheBodies) {
  const contact::Case input = case_of("thesis_f");
  const std::string key = key_of(input);
  const auto differs = [&](auto change) {
    contact::Case other = input;
    change(other);
    return key_of(other) != key;
  };
  EXPECT_TRUE(differs([](contact::Case& c) { c.wheel.rolling_radius += 1e-3; }));
  EXPECT_TRUE(differs([](contact::Case& c) { c.rail.transverse_radius += 1e-3; }));
  EXPECT_TRUE(differs([](contact::Case& c) { c.rail.round_to = 0.8; }));
  EXPECT_TRUE(differs([](contact::Case& c) { c.wheel.round_to = 0.8; }));
  EXPECT_TRUE(differs([](contact::Case& c) { c.rail.material.poisson_ratio = 0.29; }));
  EXPECT_TRUE(differs([](contact::Case& c) { c.wheel.material.young_modulus = 209e3; }));
  EXPECT_TRUE(differs([](contact::Case& c) { c.body_extent = 50.0; }));
  EXPECT_TRUE(differs([](contact::Case& c) { c.options.set<fem::FemOptions>().degree = 1; }));
  EXPECT_TRUE(differs(
      [](contact::Case& c) { c.options.set<fem::FemOptions>().mesh = fem::MeshFamily::gmsh; }));
  EXPECT_TRUE(differs([](contact::Case& c) { c.rail.mesh = "rail.msh"; }));
  EXPECT_TRUE(differs([](contact::Case& c) { c.load.normal_force = 100e3; }));
}

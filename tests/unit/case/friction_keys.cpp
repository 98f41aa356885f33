// SPDX-License-Identifier: LGPL-2.1-or-later
// Case files of friction that falls with the slip velocity and of a layer: what they become.
#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"
#include "scene/scene.hpp"

#include "support/case_examples.hpp"
#include <string>
#include <vector>

namespace {

/// The example case with more keys of friction and of rolling.
std::string falling(const std::string& keys, const std::string& rolling = "speed = 10e3\n",
                    const std::string& more = "") {
  return with("coefficient = 0.55", "coefficient = 0.4\n" + keys) + "[rolling]\n" + rolling + more;
}

const std::string exponential =
    "law = \"exponential\"\nkinetic_coefficient = 0.2\nhalf_velocity = 900.0\n";

TEST(FrictionKeys, Arrive) {
  const Case input =
      parse_case(falling("law = \"rational\"\nkinetic_coefficient = 0.1\nhalf_velocity = 900.0\n"
                         "second_part = 0.05\nsecond_half_velocity = 5e3\nmemory_distance = 2e-3\n"
                         "memory_velocity = 3.0\nbranch = \"sliding\"",
                         "speed = 10e3\n", "[layer]\nthickness = 0.02\nshear_modulus = 800.0\n"),
                 "case.toml");
  const contact::FrictionFall& fall = input.friction_fall;
  EXPECT_EQ(fall.shape, FallShape::rational);
  EXPECT_EQ(fall.kinetic_coefficient, 0.1);
  EXPECT_EQ(fall.half_velocity, 900.0);
  EXPECT_EQ(fall.second_part, 0.05);
  EXPECT_EQ(fall.second_half_velocity, 5e3);
  EXPECT_EQ(fall.memory_distance, 2e-3);
  EXPECT_EQ(fall.memory_velocity, 3.0);
  EXPECT_EQ(contact::friction_of(input)->branch, contact::FrictionBranch::sliding);
  EXPECT_EQ(contact::Scene(input).material.layer, 0.02 / 800.0);
  EXPECT_EQ(contact::Scene(input).material.uncoupled().layer, 0.02 / 800.0);
  EXPECT_FALSE(contact::Scene(input).feels_inertia());  // a speed is not inertia
}

TEST(FrictionKeys, PolachsSpellingIsTheExponentialLaw) {
  const Case given = parse_case(falling(exponential), "case.toml");
  const Case polach = parse_case(
      falling("law = \"exponential\"\npolach_a = 0.5\npolach_b = 0.7701635339554948"), "case.toml");
  for (const double slip : {1e-4, 1e-2, 0.3})
    EXPECT_NEAR(contact::friction_of(given)->at(slip).value,
                contact::friction_of(polach)->at(slip).value, 1e-12);
}

TEST(FrictionKeys, ALayerMayYieldWithoutBeingElastic) {
  const Case input =
      parse_case(plus("[layer]\nyield_stress = 200.0\nhardening = -40.0\n"), "case.toml");
  EXPECT_EQ(contact::Scene(input).material.layer, 0.0);
  const auto layer = contact::Scene(input).friction()->plasticity;
  ASSERT_TRUE(layer);
  EXPECT_EQ(layer->yield_stress, 200.0);
  EXPECT_EQ(layer->hardening, -40.0);
}

/// A case of profiles with these keys of friction and of the wheelset.
std::string over_rail(const std::string& friction, const std::string& wheelset = "") {
  return "[load]\nnormal_force = 50e3\n[friction]\n" + friction +
         "\n[wheel]\nrolling_radius = 460.0\nprofile = \"S1002\"\n[rail]\nprofile = \"60E1\"\n"
         "[track]\ninclination = \"1:40\"\n[wheelset]\n" +
         wheelset + "\n[rolling]\nspeed = 10e3\n";
}

TEST(FrictionKeys, ListsBelongToPointsOverTheRail) {
  const Case input =
      parse_case(over_rail("coefficient = [0.1, 0.4, 0.2]\nlaw = \"linear\"\n"
                           "kinetic_coefficient = [0.05, 0.2, 0.1]\nhalf_velocity = 500.0\n"
                           "inclination = [-1.2, -0.4, 0.0]\n"),
                 "case.toml");
  const contact::FrictionVariation& over = input.friction_variation;
  EXPECT_EQ(over.inclination, (std::vector<double>{-1.2, -0.4, 0.0}));
  ASSERT_EQ(over.points.size(), 3U);
  EXPECT_EQ(over.points[0].coefficient, 0.1);
  EXPECT_EQ(over.points[2].fall.kinetic_coefficient, 0.1);
  EXPECT_EQ(over.points[2].fall.half_velocity, 500.0);
  EXPECT_EQ(input.friction_coefficient, 0.4);  // the scale
  EXPECT_EQ(input.friction_fall.shape, FallShape::linear);
}

TEST(FrictionKeys, BetweenPointsTheNumbersAreLinearAndOutsideConstant) {
  const Case input = parse_case(
      over_rail("coefficient = [0.1, 0.4]\nlaw = \"linear\"\nkinetic_coefficient = [0.05, 0.2]\n"
                "half_velocity = [500.0, 900.0]\ninclination = [-1.0, 0.0]\n"),
      "case.toml");
  const auto law_at = [&](double inclination) {
    return contact::friction_of(input, 0, [=](double) { return inclination; })->of_row(0.0);
  };
  // mu_kin + mu_1 (1 - s/(2 s_h)) at s = 350 mm/s of 10 m/s; s_h = 700 mm/s in the middle.
  EXPECT_NEAR(law_at(-0.5)->at(0.035).value, 0.125 + 0.125 * 0.75, 1e-15);
  EXPECT_NEAR(law_at(-0.5)->coefficient(), 0.25, 1e-15);
  EXPECT_NEAR(law_at(-1.4)->coefficient(), 0.1, 1e-15);
  EXPECT_NEAR(law_at(0.3)->coefficient(), 0.4, 1e-15);
  EXPECT_NEAR(contact::friction_of(input)->coefficient(), 0.4, 1e-15);
}

}  // namespace

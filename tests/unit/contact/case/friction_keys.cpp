// SPDX-License-Identifier: LGPL-2.1-or-later
// Case files of friction that falls with the slip velocity and of a layer: what they become, and
// what is refused.
#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "contact/scene/scene.hpp"

#include <gtest/gtest.h>

#include "support/case_examples.hpp"
#include <string>

namespace rollfem {
namespace {

using contact::Case;
using contact::FallShape;
using contact::parse_case;
using testing::expect_error;
using testing::plus;
using testing::with;

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
                         "memory_velocity = 3.0",
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
  expect_error(plus("[layer]\nhardening = 40.0\n"), {"layer.yield_stress: is missing"});
  expect_error(plus("[layer]\nyield_stress = 0.0\n"),
               {"layer.yield_stress = 0.0: is out of bounds"});
}

TEST(FrictionKeys, AShiftNeedsNoSpeed) {
  EXPECT_NO_THROW(parse_case(
      falling(exponential, "problem = \"shift\"\n", "[history]\nlongitudinal_shift = 1e-3\n"),
      "case.toml"));
}

TEST(FrictionKeys, WhatIsRefused) {
  expect_error(falling(exponential, ""),
               {"rolling.speed: is missing, and the friction depends on the slip velocity",
                "do: add `speed = 10e3`"});
  expect_error(falling(exponential, "speed = 0.0\n"),
               {"rolling.speed = 0.0: leaves the friction at rest", "above 0 mm/s"});
  expect_error(falling("half_velocity = 900.0"),
               {"friction.half_velocity = 900.0: is of friction that falls", "law is constant"});
  expect_error(falling("law = \"linear\"\nhalf_velocity = 900.0"),
               {"friction.kinetic_coefficient: is missing"});
  expect_error(falling("law = \"linear\"\nkinetic_coefficient = 0.2"),
               {"friction.half_velocity: is missing"});
  expect_error(falling("law = \"linear\"\npolach_a = 0.5\nhalf_velocity = 900.0"),
               {"friction.polach_a = 0.5: is of the exponential law, but friction.law is linear"});
  expect_error(falling(exponential + "polach_a = 0.5"),
               {"contradicts friction.kinetic_coefficient"});
  expect_error(falling("law = \"linear\"\nkinetic_coefficient = 0.5\nhalf_velocity = 900.0"),
               {"friction.kinetic_coefficient = 0.5: does not fit friction.coefficient = 0.4",
                "0.004 to 0.4"});
  expect_error(falling(exponential + "second_part = 0.3\nsecond_half_velocity = 9e3"),
               {"friction.second_part = 0.3: is more than friction falls, 0.2"});
  expect_error(falling(exponential + "second_part = 0.1"),
               {"friction.second_half_velocity: is missing"});
  expect_error(falling(exponential + "memory_velocity = 5.0"),
               {"friction.memory_velocity = 5.0: is not used"});
  expect_error(plus("[layer]\nthickness = 0.02\n"), {"layer.shear_modulus: is missing"});
  expect_error(plus("[layer]\nthickness = 0.0\nshear_modulus = 1.0\n"),
               {"layer.thickness = 0.0: is out of bounds"});
}

}  // namespace
}  // namespace rollfem

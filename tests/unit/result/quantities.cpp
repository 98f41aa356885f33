// SPDX-License-Identifier: LGPL-2.1-or-later
// The table of scalars: every row refers to a different member, and its information on errors.
#include "result/quantities.hpp"

#include "support/test.hpp"

TEST(Quantities, EachReachesAMemberOfItsOwn) {
  PointResult point;
  double number = 0.0;
  for (const Quantity& quantity : quantities()) {
    EXPECT_EQ(quantity.value(point).has_value(), !quantity.member.may_be_absent) << quantity.name;
    quantity.member.set(point, ++number);
  }
  number = 0.0;
  for (const Quantity& quantity : quantities()) {
    ++number;
    EXPECT_EQ(quantity.value(point), quantity.member.kind == QuantityKind::truth ? 1.0 : number)
        << quantity.name;
  }
  EXPECT_EQ(point.creepage.lateral, 2.0);
  EXPECT_EQ(point.step, 4);
  EXPECT_TRUE(point.converged);
}

TEST(Quantities, HaveNamesOfTheirOwnAndWords) {
  std::set<std::string> names;
  for (const Quantity& quantity : quantities()) {
    EXPECT_TRUE(names.insert(quantity.name).second) << quantity.name;
    EXPECT_EQ(find_quantity(quantity.name), &quantity);
    for (const char* text : {quantity.title, quantity.unit, quantity.meaning})
      EXPECT_NE(std::string(text), "") << quantity.name;
  }
  EXPECT_EQ(find_quantity("beauty"), nullptr);
  EXPECT_THROW(quantity_named("beauty"), std::logic_error);
}

TEST(Quantities, AccuracyIsAskedOnlyOfWhatHasAnErrorEverywhere) {
  const std::vector<std::string> words = accuracy_words();
  for (const char* name : {"max_pressure", "semi_axis_x", "semi_axis_y", "approach", "normal_force",
                           "traction_coefficient", "max_traction_x"})
    EXPECT_EQ(std::count(words.begin(), words.end(), name), 1) << name;
  for (const std::string& name : words) {
    EXPECT_NE(quantity_named(name).scale, ErrorScale::none) << name;
    EXPECT_FALSE(quantity_named(name).member.may_be_absent) << name;
  }
}

TEST(Quantities, FullSlidingIsWhatCoulombGives) {
  PointResult point;
  point.normal_force = 1000.0;
  point.max_pressure = 600.0;
  point.semi_axis_x = 4.0;
  point.semi_axis_y = 9.0;
  const auto sliding = [&](const char* name) {
    return full_sliding(quantity_named(name), point, 0.5);
  };
  EXPECT_DOUBLE_EQ(sliding("traction_coefficient"), 0.5);
  EXPECT_DOUBLE_EQ(sliding("longitudinal_force"), 500.0);
  EXPECT_DOUBLE_EQ(sliding("lateral_force"), 500.0);
  EXPECT_DOUBLE_EQ(sliding("spin_moment"), 3000.0);
  EXPECT_DOUBLE_EQ(sliding("max_traction_x"), 300.0);
  EXPECT_DOUBLE_EQ(sliding("max_pressure"), 0.0);
  EXPECT_DOUBLE_EQ(sliding("step"), 0.0);
}

TEST(Quantities, WhatAModelDoesNotGiveHasNoValue) {
  PointResult point;
  EXPECT_THROW(quantity(point, "elastic_energy"), std::logic_error);
  point.elastic_energy = 3.0;
  EXPECT_EQ(quantity(point, "elastic_energy"), 3.0);
}

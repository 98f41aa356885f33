// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables over lateral shifts: at and between their points, at a jump of the contact, in physical
// units.
#include "support/shifted_table.hpp"

#include "base/errors.hpp"
#include "tables/files/table_reader.hpp"

#include <tuple>

namespace {

using tables::CreepTable;
using tables::CreepTableReader;
using tables::Scaled;

TEST(ShiftedTable, IsItsPointsOfBothSigns) {
  const CreepTableReader reader(table_of_shifts(3));
  const CreepTable& table = reader.table();
  for (const double shift : table.lateral_shift)
    for (const double x : table.creepage[0])
      for (const double y : table.creepage[1])
        for (const double z : table.creepage[2]) {
          const auto found = reader.at(shift, {x, y, z});
          const Scaled exact = law_of_shift(shift, {x, y, z});
          for (std::size_t q = 0; q < 3; ++q) EXPECT_NEAR(found.forces[q], exact[q], 1e-13);
          EXPECT_NEAR(found.along_normal, 0.1 * exact[1], 1e-13);
        }
}

TEST(ShiftedTable, ErrorBetweenPointsFallsWithTheirNumber) {
  const auto largest = [](int count) {
    const CreepTableReader reader(table_of_shifts(count));
    double error = 0.0;
    for (const double shift : {-0.7, 0.4, 2.6})
      for (double x = -2.9; x < 3.0; x += 0.37)
        for (double z = -3.9; z < 4.0; z += 0.43)
          for (std::size_t q = 0; q < 3; ++q)
            error = std::max(error, std::abs(reader.at(shift, {x, 0.6, z}).forces[q] -
                                             law_of_shift(shift, {x, 0.6, z})[q]));
    return error;
  };
  // The law is linear in the shift, so that creepages alone make errors.
  const double coarse = largest(5), fine = largest(13);
  EXPECT_LT(fine, 0.01);
  EXPECT_GT(coarse / fine, 5.0);
}

TEST(ShiftedTable, NothingIsInterpolatedAcrossAJump) {
  const CreepTableReader reader(table_of_shifts(3));
  const Scaled creepage{1.0, -0.5, 0.7};
  const auto left = reader.at(1.0, creepage), right = reader.at(2.0, creepage);
  const double force =
                   std::hypot(left.forces[0] - right.forces[0], left.forces[1] - right.forces[1],
                              left.along_normal - right.along_normal),
               moment = std::abs(left.forces[2] - right.forces[2]);
  ASSERT_GT(force, 0.1);
  for (const double shift : {1.001, 1.3, 1.499, 1.501, 1.7, 1.999}) {
    const auto& side = shift < 1.5 ? left : right;
    const auto found = reader.at(shift, creepage);
    EXPECT_EQ(found.forces, side.forces) << shift;
    EXPECT_NEAR(found.force_bar, side.force_bar + force, 1e-14) << shift;
    EXPECT_NEAR(found.moment_bar, side.moment_bar + moment, 1e-14) << shift;
    EXPECT_EQ(reader.wheel_at(shift).contacts, shift < 1.5 ? 1.0 : 2.0);
    EXPECT_EQ(reader.wheel_at(shift).jump_after, 1.0);
    // Either side lies within the bars.
    const auto& other = shift < 1.5 ? right : left;
    EXPECT_LE(std::hypot(found.forces[0] - other.forces[0], found.forces[1] - other.forces[1]),
              found.force_bar);
  }
  EXPECT_NEAR(left.force_bar, 0.012, 1e-15);
  EXPECT_NEAR(right.force_bar, 0.012, 1e-15);
  // The slope before a jump does not know of what is behind it.
  const double h = 1e-4;
  const double slope = (left.forces[0] - reader.at(1.0 - h, creepage).forces[0]) / h;
  const double exact = (law_of_shift(1.0, creepage)[0] - law_of_shift(1.0 - h, creepage)[0]) / h;
  EXPECT_NEAR(slope, exact, 0.1 * std::abs(exact));
}

TEST(ShiftedTable, PhysicalForcesAreThoseOfTheScaledCreepages) {
  const CreepTableReader reader(table_of_shifts(4));
  const double a = 7.0, b = 5.0, c = std::sqrt(a * b), bound = 15e3;
  const double stiffness = 80e3 * a * b / bound;
  const Scaled creepage{0.002, -0.001, 3e-4};
  const auto scaled = reader.at(1.0, {2.1 * stiffness * creepage[0], 1.8 * stiffness * creepage[1],
                                      1.5 * stiffness * c * creepage[2]});
  const auto found = reader.of_wheel(1.0, bound, creepage);
  for (std::size_t q = 0; q < 2; ++q) EXPECT_NEAR(found.forces[q], bound * scaled.forces[q], 1e-8);
  EXPECT_NEAR(found.forces[2], bound * c * scaled.forces[2], 1e-8);
  EXPECT_NEAR(found.along_normal, bound * scaled.along_normal, 1e-8);
  EXPECT_NEAR(found.force_bar, bound * scaled.force_bar, 1e-9);
  EXPECT_NEAR(reader.wheel_at(0.5).rolling_radius, 449.5, 1e-10);
  // At a jump both sides have their own scale.
  const auto other = reader.of_wheel(2.0, bound, creepage);
  const auto between = reader.of_wheel(1.2, bound, creepage);
  EXPECT_EQ(between.forces, found.forces);
  EXPECT_NEAR(between.force_bar,
              found.force_bar + std::hypot(found.forces[0] - other.forces[0],
                                           found.forces[1] - other.forces[1],
                                           found.along_normal - other.along_normal),
              1e-8);
}

TEST(ShiftedTable, BeyondAJumpATableForOneFrictionBoundHasAnotherOne) {
  CreepTable table = table_of_shifts(4);
  table.only_for = "falling friction";
  for (std::size_t k = 3; k < 5; ++k) table.wheels[k].normal_force = 52e3;
  const CreepTableReader reader(table);
  const Scaled creepage{2e-4, -1e-4, 3e-5};
  const auto left = reader.of_wheel(1.0, 15e3, creepage);
  const auto right = reader.of_wheel(2.0, 15.6e3, creepage);
  const double force =
      std::hypot(left.forces[0] - right.forces[0], left.forces[1] - right.forces[1],
                 left.along_normal - right.along_normal);
  for (const auto& [shift, bound, side] : {std::tuple{1.2, 15e3, left}, {1.8, 15.6e3, right}}) {
    const auto found = reader.of_wheel(shift, bound, creepage);
    EXPECT_EQ(found.forces, side.forces);
    EXPECT_NEAR(found.force_bar, side.force_bar + force, 1e-8);
  }
  // The bound of the other side stays refused.
  EXPECT_THROW(reader.of_wheel(1.2, 15.6e3, creepage), contact::InputError);
  EXPECT_THROW(reader.of_wheel(1.8, 15e3, creepage), contact::InputError);
}

TEST(ShiftedTable, RefusesShiftsOutsideAndQuestionsOfTheOtherKind) {
  const CreepTableReader reader(table_of_shifts(2));
  EXPECT_NO_THROW(reader.at(3.0, {}));
  EXPECT_THROW(reader.at(3.001, {}), contact::InputError);
  EXPECT_THROW(reader.at(-1.001, {}), contact::InputError);
  EXPECT_THROW(reader.at(std::nan(""), {}), contact::InputError);
  EXPECT_THROW(reader.physical(5.0, 5.0, 80e3, 15e3, {}), contact::InputError);
  EXPECT_THROW(reader.of_wheel(0.0, 0.0, {}), contact::InputError);
  EXPECT_THROW(reader.of_wheel(0.0, 15e3, {std::nan(""), 0.0, 0.0}), contact::InputError);
  CreepTable broken = table_of_shifts(2);
  broken.wheels.pop_back();
  EXPECT_THROW(CreepTableReader{broken}, contact::InputError);
  broken = table_of_shifts(2);
  broken.along_normal.pop_back();
  EXPECT_THROW(CreepTableReader{broken}, contact::InputError);
  broken = table_of_shifts(2);
  broken.wheels[1].semi_axis_y = 0.0;
  EXPECT_THROW(CreepTableReader{broken}, contact::InputError);
  broken = table_of_shifts(2);
  broken.creepage[0].front() = -9.0;
  EXPECT_THROW(CreepTableReader{broken}, contact::InputError);
}

}  // namespace

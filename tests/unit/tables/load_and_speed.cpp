// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables with axes of load and speed against single solutions between their values, of other bodies
// too; at their values; and refusals.
#include "base/errors.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "tables/files/table_files.hpp"
#include "tables/files/table_reader.hpp"
#include "tables/filling/table_filling.hpp"
#include "tables/filling/table_grid.hpp"

#include "support/temporary_folder.hpp"
#include "support/worn_wheels.hpp"

namespace {

using tables::CreepTable;
using tables::CreepTableReader;
using tables::Scaled;

void add_law(contact::Case& input) {
  input.file = "c.toml";
  input.friction_coefficient = 0.3;
  input.friction_fall.shape = contact::FallShape::exponential;
  input.friction_fall.kinetic_coefficient = 0.1;
  input.friction_fall.half_velocity = 300.0;
  input.friction_fall.memory_distance = 0.003;
  input.rolling.speed = 20e3;
}

/// Steel of Poisson's ratio 0.3, radii in the same ratio whatever `size` is.
contact::Case bodies(double size, double force) {
  contact::Case input;
  add_law(input);
  input.load.normal_force = force;
  input.wheel.rolling_radius = size * 450.0;
  input.rail.transverse_radius = size * 300.0;
  return input;
}

contact::Case ellipse_case() {
  contact::Case input = bodies(1.0, 80e3);
  input.table.load = {50e3, 80e3};
  input.table.speed = {15e3, 20e3, 30e3};
  input.table.longitudinal = {0.0, 1.0, 3.0};
  input.table.lateral = {0.0, 1.0};
  input.table.spin = {0.5};
  input.table.check_points = 10;
  return input;
}

CreepTable filled_table(const contact::Case& input) {
  CreepTable table = tables::empty_table(input);
  tables::fill_table(table, input, {}, nullptr);
  return table;
}

/// Through its file.
const CreepTableReader& ellipses() {
  static const CreepTableReader reader = [] {
    const TemporaryFolder folder;
    return CreepTableReader(tables::read_table(
        folder.file("table.h5", tables::table_hdf5(filled_table(ellipse_case())))));
  }();
  return reader;
}

double between(const CreepTableReader& reader) {
  return reader.table().interpolation.by_axis[4] + reader.table().interpolation.by_axis[5];
}

/// Otherwise the bars would be those of a single load and speed.
TEST(LoadAndSpeed, FewCheckPointsAreAtManyLoadsAndSpeeds) {
  std::set<std::pair<double, double>> places;
  for (const tables::InterpolatedPoint& point : ellipses().table().checked)
    places.insert({point.place.load, point.place.speed});
  EXPECT_EQ(places.size(), 10U);
}

TEST(LoadAndSpeed, OfEllipsesHoldForBodiesOfOtherCurvature) {
  const CreepTableReader& reader = ellipses();
  const CreepTable& table = reader.table();
  for (const auto& [size, force, speed] :
       {std::array{1.0, 62e3, 17e3}, {0.7, 60e3, 17e3}, {1.5, 75e3, 26e3}}) {
    contact::Case input = bodies(size, force);
    input.rolling.speed = speed;
    input.contact_grid.elements_across = 40;
    const auto hertz = halfspace::hertz_of_scene(contact::Scene(input));
    const double c2 = hertz.semi_axis_x * hertz.semi_axis_y, bound = 0.3 * force;
    const double unit = bound / (table.shear_modulus * c2);
    const Scaled scale = reader.scale_at(hertz.semi_axis_x / hertz.semi_axis_y);
    const Scaled creepage{unit / scale[0], unit / scale[1], 0.5 * unit / scale[2] / std::sqrt(c2)};
    input.rolling.creepages = {{creepage[0], creepage[1], creepage[2]}};
    const auto solved = halfspace::run_halfspace(contact::Scene(input), {}).points.front();
    const auto found = reader.physical(hertz.semi_axis_x, hertz.semi_axis_y, table.shear_modulus,
                                       bound, creepage, speed);
    const double error = std::hypot(found.forces[0] - solved.longitudinal_force,
                                    found.forces[1] - solved.lateral_force);
    EXPECT_LT(error, 0.005 * bound) << size;  // bars of the table's points and of the solution
    EXPECT_LT(error, found.force_bar) << size;
    EXPECT_NEAR(found.forces[2], solved.spin_moment, 0.005 * bound * std::sqrt(c2)) << size;
  }
}

TEST(LoadAndSpeed, AtItsValuesIsTheTableOfThatLoadAndSpeed) {
  const CreepTableReader& reader = ellipses();
  contact::Case input = ellipse_case();
  input.table.load = {};
  input.table.speed = {};
  input.table.check_points = 0;
  const CreepTable one = filled_table(input);
  EXPECT_EQ(one.load, (std::vector<double>{80e3}));
  const std::size_t layer = 1 * 3 + 1;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      const Scaled& forces = reader.table().forces[reader.table().place(layer, i, 1, k)];
      for (std::size_t q = 0; q < 3; ++q)
        EXPECT_NEAR(forces[q], one.forces[one.place(0, i, 1, k)][q], 1e-9);
      const auto found =
          reader.at({one.axis_ratio[0], 80e3, 20e3}, {one.creepage[0][i], 1.0, one.creepage[2][k]});
      for (std::size_t q = 0; q < 3; ++q) EXPECT_NEAR(found.forces[q], forces[q], 1e-13);
    }
  // Alone it holds for its own pressure and size.
  const CreepTableReader alone(one);
  const auto hertz = halfspace::hertz_of_scene(contact::Scene(input));
  const auto at = [&](double bound) {
    return alone.physical(hertz.semi_axis_x, hertz.semi_axis_y, one.shear_modulus, bound, {});
  };
  EXPECT_NO_THROW(at(24e3));
  EXPECT_TRUE(says(refusal<contact::InputError>([&] { at(25e3); }), "load"));
}

TEST(LoadAndSpeed, OutsideIsRefused) {
  const CreepTableReader& reader = ellipses();
  const double ratio = reader.table().axis_ratio[0];
  const auto refused = [&](const tables::TablePlace& place) {
    return refusal<contact::InputError>([&] { reader.at(place, {}); });
  };
  EXPECT_TRUE(says(refused({ratio, 49e3, 20e3}), "load 49000 N", "allowed: 50000 to 80000"));
  EXPECT_TRUE(says(refused({ratio, 60e3, 31e3}), "speed 31000 mm/s", "allowed: 15000 to 30000"));
  EXPECT_TRUE(says(refused({ratio, 60e3}), "give it, or make a table"));
  contact::Case input = ellipse_case();
  const auto no_table = [&] {
    return refusal<contact::InputError>([&] { tables::empty_table(input); });
  };
  input.friction_fall.memory_distance = 0.0;
  EXPECT_TRUE(says(no_table(), "c.toml: table.load", "list table.speed instead"));
  input.friction_fall = {};
  input.table.load.clear();
  EXPECT_TRUE(says(no_table(), "c.toml: table.speed", "do not depend on the speed"));
}

TEST(LoadAndSpeed, OfAWheelAreThoseOfItsOwnTable) {
  contact::Case input = hollow_tread(0.0);
  input.load = {};
  input.load.normal_force = 80e3;
  add_law(input);
  input.contact_grid.elements_across = 12;
  input.table.lateral_shift = {1.0};
  input.table.longitudinal = {0.0, 1.0};
  input.table.lateral = {0.0, 1.0};
  input.table.spin = {0.5};
  input.table.check_points = 0;
  input.rolling.speed = 17e3;
  const CreepTable own = filled_table(input);
  input.table.check_points = 10;
  input.table.load = {70e3, 90e3};
  input.table.speed = {15e3, 20e3};
  const CreepTableReader reader(filled_table(input));
  ASSERT_EQ(reader.table().size(), 4 * own.size());
  EXPECT_EQ(reader.wheel_at({1.0, 80e3, 17e3}).contacts, 1.0);
  EXPECT_NEAR(reader.wheel_at({1.0, 80e3, 17e3}).normal_force, 80e3, 1e-6);
  double largest = 0.0;
  for (std::size_t n = 0; n < own.size(); ++n) {
    const std::size_t k = n % 2, j = n / 2 % 3, i = n / 6;
    const auto found =
        reader.at({1.0, 80e3, 17e3}, {own.creepage[0][i], own.creepage[1][j], own.creepage[2][k]});
    largest = std::max(largest, std::hypot(found.forces[0] - own.forces[n][0],
                                           found.forces[1] - own.forces[n][1]));
  }
  EXPECT_LT(largest, 1.5 * between(reader));  // that of 95 of 100 points of each axis
  EXPECT_LT(largest, 0.01);
  EXPECT_TRUE(says(refusal<contact::InputError>([&] { reader.of_wheel(1.0, 24e3, {}); }), "load"));
}

}  // namespace

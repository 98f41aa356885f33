// SPDX-License-Identifier: LGPL-2.1-or-later
// A table over the lateral shift with falling friction and a layer: full sliding has the friction
// of its slip velocity, and what the table does not hold for is refused.
#include "base/errors.hpp"
#include "tables/files/table_files.hpp"
#include "tables/files/table_reader.hpp"
#include "tables/filling/table_filling.hpp"
#include "tables/filling/table_grid.hpp"

#include "support/temporary_folder.hpp"
#include "support/worn_wheels.hpp"

namespace {

contact::Case falling_wheel() {
  contact::Case input = hollow_tread(0.0);
  input.file = "c.toml";
  input.load = {};
  input.load.normal_force = 80e3;
  input.friction_coefficient = 0.3;
  input.friction_fall.shape = contact::FallShape::exponential;
  input.friction_fall.kinetic_coefficient = 0.1;
  input.friction_fall.half_velocity = 300.0;
  input.friction_fall.memory_distance = 0.003;
  input.layer = contact::Layer{1.0, 8200.0};
  input.rolling.speed = 20e3;
  input.rolling.extra_slip = contact::ExtraSlip::none;
  input.contact_grid.elements_across = 16;
  input.table.lateral_shift = {1.0};
  input.table.points = {2, 2, 3};
  input.table.largest = {10.0, 10.0, 10.0};
  input.table.check_points = 0;
  return input;
}

TEST(FallingTable, InFullSlidingHasTheFrictionOfTheSlipVelocity) {
  const contact::Case input = falling_wheel();
  tables::CreepTable table = tables::empty_table(input);
  tables::fill_table(table, input, {}, nullptr);
  const TemporaryFolder folder;
  const tables::CreepTableReader reader(
      tables::read_table(folder.file("table.h5", tables::table_hdf5(table))));
  const tables::TableWheel wheel = reader.wheel_at(1.0);
  const double bound = 0.3 * wheel.normal_force, c2 = wheel.semi_axis_x * wheel.semi_axis_y;
  const double end = 10.0 * bound / (reader.scale_at(1.0)[0] * table.shear_modulus * c2);
  const auto found = reader.of_wheel(1.0, bound, {end, 0.0, 0.0});
  const double mu = 0.1 + 0.2 * std::exp2(-20e3 * end / 300.0);
  ASSERT_LT(mu, 0.2);
  EXPECT_NEAR(-found.forces[0] / wheel.normal_force, mu, 0.01 * mu);

  const auto refused = [&](double friction_bound, double creepage) {
    return refusal<contact::InputError>([&] {
      reader.of_wheel(1.0, friction_bound, {creepage, 0.0, 0.0});
    });
  };
  EXPECT_TRUE(says(refused(0.5 * bound, 0.5 * end),
                   "falling friction at a speed of 20000 mm/s and a layer"));
  EXPECT_TRUE(says(refused(bound, 2.0 * end), "2 times those at the end"));
}

}  // namespace

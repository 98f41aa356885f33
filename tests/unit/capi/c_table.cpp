// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables through rollfem.h: the numbers of the C++ reader, and refusals.
#include "tables/files/table_files.hpp"
#include "tables/files/table_reader.hpp"

#include "rollfem/rollfem.h"
#include "support/shifted_table.hpp"
#include "support/wheel_on_rail.hpp"
#include <atomic>
#include <cstddef>
#include <cstring>
#include <thread>

namespace {

using tables::CreepTable;

CreepTable some_table() {
  CreepTable table;
  table.axis_ratio = {0.5, 2.0};
  table.scale = {{1.0, 2.0, 3.0}, {2.0, 2.0, 5.0}};
  table.creepage = {tables::creepages_to(2.0, 3), tables::creepages_to(2.0, 3),
                    tables::spins_to(2.0, 3)};
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto x = static_cast<double>(k);
    table.forces.push_back({-0.01 * x, 0.02 * x, 0.003 * x});
    table.bars.push_back({0.002, 0.004});
    table.elements_across.push_back(20);
  }
  return table;
}

using Table = std::unique_ptr<rollfem_table, void (*)(rollfem_table*)>;

Table opened(const std::string& file) {
  return {rollfem_table_open(file.c_str(), nullptr, 0), rollfem_table_close};
}

Table opened(const CreepTable& table) {
  const TemporaryFolder folder;
  return opened(folder.file("table.h5", tables::table_hdf5(table)));
}

TEST(CTable, SaysWhatTheTableSays) {
  const TemporaryFolder folder;
  const std::string file = folder.file("table.h5", tables::table_hdf5(some_table()));
  char message[200] = "before";
  const Table table(rollfem_table_open(file.c_str(), message, sizeof message), rollfem_table_close);
  ASSERT_NE(table, nullptr) << message;
  EXPECT_STREQ(message, "");
  const rollfem_ellipse ellipse{sizeof ellipse, 6.0, 5.0, 80e3, 15e3, 0.001, -0.002, 3e-4, 0.0};
  auto forces = sized<rollfem_creep_forces>();
  ASSERT_EQ(rollfem_table_forces(table.get(), &ellipse, &forces, message, sizeof message),
            ROLLFEM_OK);
  const auto expected =
      tables::CreepTableReader(some_table()).physical(6.0, 5.0, 80e3, 15e3, {0.001, -0.002, 3e-4});
  EXPECT_EQ(forces.longitudinal_force, expected.forces[0]);
  EXPECT_EQ(forces.lateral_force, expected.forces[1]);
  EXPECT_EQ(forces.spin_moment, expected.forces[2]);
  EXPECT_EQ(forces.force_bar, expected.force_bar);
  EXPECT_EQ(forces.moment_bar, expected.moment_bar);
}

TEST(CTable, RefusesAnEllipseOutsideAndAFileThatIsNoTable) {
  const TemporaryFolder folder;
  char message[300];
  const std::string text = folder.file("text.h5", "no table");
  EXPECT_EQ(rollfem_table_open(text.c_str(), message, sizeof message), nullptr);
  EXPECT_TRUE(says(message, "text.h5"));
  EXPECT_EQ(rollfem_table_open(nullptr, nullptr, 0), nullptr);
  const Table table = opened(some_table());
  ASSERT_NE(table, nullptr);
  const rollfem_ellipse narrow{sizeof narrow, 1.0, 5.0, 80e3, 15e3, 0.001, 0.0, 0.0, 0.0};
  rollfem_creep_forces forces{sizeof forces, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  EXPECT_EQ(rollfem_table_forces(table.get(), &narrow, &forces, message, sizeof message),
            ROLLFEM_REFUSED);
  EXPECT_TRUE(says(message, "a/b = 0.2"));
  EXPECT_EQ(forces.longitudinal_force, 0.0);
}

TEST(CTable, ThreadsOpenOneFile) {
  const TemporaryFolder folder;
  const std::string file = folder.file("table.h5", tables::table_hdf5(some_table()));
  std::atomic<int> right = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t)
    threads.emplace_back([&] {
      for (int k = 0; k < 25; ++k) {
        const Table table = opened(file);
        const rollfem_ellipse ellipse{sizeof ellipse, 6.0, 5.0, 80e3, 15e3, 0.001, 0.0, 0.0, 0.0};
        auto forces = sized<rollfem_creep_forces>();
        if (table && rollfem_table_forces(table.get(), &ellipse, &forces, nullptr, 0) == ROLLFEM_OK)
          ++right;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(right, 200);
}

TEST(CTable, OfShiftsSaysWhatTheTableSaysInEveryUnit) {
  const CreepTable truth = table_of_shifts(3);
  const tables::CreepTableReader reader(truth);
  const Table table = opened(truth);
  ASSERT_NE(table, nullptr);
  const auto expected = reader.of_wheel(0.4, 12e3, {0.001, -0.002, 3e-4});
  struct Unit {
    rollfem_units units;
    double length, force;
  };
  for (const auto& [units, length, force] :
       {Unit{ROLLFEM_MM_N, 1.0, 1.0}, Unit{ROLLFEM_M_N, 1e3, 1.0}, Unit{ROLLFEM_MM_KN, 1.0, 1e3}}) {
    const rollfem_shifted_wheel wheel{
        sizeof wheel, units, 0.4 / length, 12e3 / force, 0.001, -0.002, 3e-4 * length, 0.0, 0.0};
    auto forces = sized<rollfem_wheel_forces>();
    ASSERT_EQ(rollfem_table_wheel_forces(table.get(), &wheel, &forces, nullptr, 0), ROLLFEM_OK);
    EXPECT_NEAR(force * forces.longitudinal_force, expected.forces[0], 1e-8);
    EXPECT_NEAR(force * forces.lateral_force, expected.forces[1], 1e-8);
    EXPECT_NEAR(force * length * forces.spin_moment, expected.forces[2], 1e-7);
    EXPECT_NEAR(force * forces.force_along_normal, expected.along_normal, 1e-8);
    EXPECT_NEAR(force * forces.force_bar, expected.force_bar, 1e-8);
    EXPECT_NEAR(force * length * forces.moment_bar, expected.moment_bar, 1e-7);
    EXPECT_NEAR(force * forces.friction_bound, 12e3, 1e-8);
    EXPECT_NEAR(force * forces.normal_force, 50e3, 1e-8);
    EXPECT_NEAR(length * forces.rolling_radius, 449.6, 1e-10);
    EXPECT_NEAR(forces.contact_angle, 0.12, 1e-14);
    EXPECT_EQ(forces.jumps, 0);
  }
}

TEST(CTable, OfShiftsRefusesUnknownUnits) {
  const CreepTable truth = table_of_shifts(3);
  const Table table = opened(truth);
  ASSERT_NE(table, nullptr);
  char message[500];
  rollfem_shifted_wheel wheel{};
  wheel.struct_size = sizeof wheel;
  for (const int units : {3, 9, -1}) {
    std::memcpy(&wheel.units, &units, sizeof units);
    auto forces = sized<rollfem_wheel_forces>();
    EXPECT_EQ(rollfem_table_wheel_forces(table.get(), &wheel, &forces, message, sizeof message),
              ROLLFEM_REFUSED);
    EXPECT_TRUE(says(message, "units = ", "ROLLFEM_MM_KN"));
    EXPECT_EQ(forces.normal_force, 0.0);
  }
}

TEST(CTable, OfShiftsTakesItsOwnFrictionAndTellsOfJumps) {
  const CreepTable truth = table_of_shifts(3);
  const Table table = opened(truth);
  ASSERT_NE(table, nullptr);
  const rollfem_shifted_wheel wheel{sizeof wheel, ROLLFEM_MM_N, 1.2, 0.0, 0.001,
                                    0.0,          0.0,          0.0, 0.0};
  auto forces = sized<rollfem_wheel_forces>();
  ASSERT_EQ(rollfem_table_wheel_forces(table.get(), &wheel, &forces, nullptr, 0), ROLLFEM_OK);
  const auto expected = tables::CreepTableReader(truth).of_wheel(1.2, 15e3, {0.001, 0.0, 0.0});
  EXPECT_NEAR(forces.friction_bound, 15e3, 1e-9);
  EXPECT_NEAR(forces.longitudinal_force, expected.forces[0], 1e-9);
  EXPECT_NEAR(forces.force_bar, expected.force_bar, 1e-9);
  EXPECT_EQ(forces.jumps, 1);
}

TEST(CTable, RefusesTheOtherKindAndAShiftOutside) {
  char message[300];
  const Table ratios = opened(some_table()), shifts = opened(table_of_shifts(2));
  ASSERT_TRUE(ratios && shifts);
  rollfem_shifted_wheel wheel{sizeof wheel, ROLLFEM_MM_N, 0.5, 0.0, 0.001, 0.0, 0.0, 0.0, 0.0};
  auto forces = sized<rollfem_wheel_forces>();
  EXPECT_EQ(rollfem_table_wheel_forces(ratios.get(), &wheel, &forces, message, sizeof message),
            ROLLFEM_REFUSED);
  EXPECT_TRUE(says(message, "over axis ratios"));
  wheel.lateral_shift = 4.0;
  EXPECT_EQ(rollfem_table_wheel_forces(shifts.get(), &wheel, &forces, message, sizeof message),
            ROLLFEM_REFUSED);
  EXPECT_TRUE(says(message, "lateral shift 4 mm"));
  EXPECT_EQ(forces.force_bar, 0.0);
  const rollfem_ellipse ellipse{sizeof ellipse, 6.0, 5.0, 80e3, 15e3, 0.001, -0.002, 3e-4, 0.0};
  auto of_ellipse = sized<rollfem_creep_forces>();
  EXPECT_EQ(rollfem_table_forces(shifts.get(), &ellipse, &of_ellipse, message, sizeof message),
            ROLLFEM_REFUSED);
}

/// Two speeds, at the second of which all forces are 0.8 times those of the first.
CreepTable of_two_speeds() {
  CreepTable table = table_of_shifts(2);
  table.only_for = "falling friction";
  table.speed = {10e3, 20e3};
  const std::size_t count = table.forces.size();
  for (std::size_t k = 0; k < count; ++k) {
    const tables::Scaled& force = table.forces[k];
    table.forces.push_back({0.8 * force[0], 0.8 * force[1], 0.8 * force[2]});
    table.along_normal.push_back(0.8 * table.along_normal[k]);
    table.bars.push_back(table.bars[k]);
    table.elements_across.push_back(20);
  }
  return table;
}

TEST(CTable, OfFallingFrictionTakesTheSpeedAndNoOtherFriction) {
  const CreepTable truth = of_two_speeds();
  const Table table = opened(truth);
  ASSERT_NE(table, nullptr);
  rollfem_shifted_wheel wheel{sizeof wheel, ROLLFEM_M_N, 0.4e-3, 0.0, 0.001, 0.0, 0.0, 0.0, 20.0};
  auto forces = sized<rollfem_wheel_forces>();
  char message[400];
  const auto status = [&] {
    return rollfem_table_wheel_forces(table.get(), &wheel, &forces, message, sizeof message);
  };
  ASSERT_EQ(status(), ROLLFEM_OK) << message;
  const double first =
      tables::CreepTableReader(truth).of_wheel({0.4, 0.0, 10e3}, 15e3, {0.001, 0.0, 0.0}).forces[0];
  EXPECT_NEAR(forces.longitudinal_force, 0.8 * first, 1e-8);
  wheel.speed = 0.0;
  EXPECT_EQ(status(), ROLLFEM_REFUSED);
  EXPECT_TRUE(says(message, "speed 0 mm/s"));
  wheel.struct_size = offsetof(rollfem_shifted_wheel, load);  // an earlier header knows no speed
  EXPECT_EQ(status(), ROLLFEM_REFUSED);
  wheel = {sizeof wheel, ROLLFEM_M_N, 0.4e-3, 14e3, 0.001, 0.0, 0.0, 0.0, 20.0};
  EXPECT_EQ(status(), ROLLFEM_REFUSED);
  EXPECT_TRUE(says(message, "falling friction"));
}

}  // namespace

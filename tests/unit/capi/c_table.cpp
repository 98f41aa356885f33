// Tables through rollfem.h: the numbers of the C++ reader, and refusals.
#include "postprocess/table/table_files.hpp"

#include <gtest/gtest.h>

#include "rollfem/rollfem.h"
#include "support/temporary_folder.hpp"
#include <memory>
#include <string>

namespace {

using namespace rollfem;
using postprocess::CreepTable;

CreepTable some_table() {
  CreepTable table;
  table.axis_ratio = {0.5, 2.0};
  table.scale = {{1.0, 2.0, 3.0}, {2.0, 2.0, 5.0}};
  table.creepage = {postprocess::creepages_to(2.0, 3), postprocess::creepages_to(2.0, 3),
                    postprocess::spins_to(2.0, 3)};
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto x = static_cast<double>(k);
    table.forces.push_back({-0.01 * x, 0.02 * x, 0.003 * x});
    table.bars.push_back({0.002, 0.004});
    table.elements_across.push_back(20);
  }
  return table;
}

using Table = std::unique_ptr<rollfem_table, void (*)(rollfem_table*)>;

TEST(CTable, SaysWhatTheTableSays) {
  const rollfem::testing::TemporaryFolder folder;
  const std::string file = folder.file("table.h5", postprocess::table_hdf5(some_table()));
  char message[200] = "before";
  const Table table(rollfem_table_open(file.c_str(), message, sizeof message), rollfem_table_close);
  ASSERT_NE(table, nullptr) << message;
  EXPECT_STREQ(message, "");
  const rollfem_ellipse ellipse{6.0, 5.0, 80e3, 15e3, 0.001, -0.002, 3e-4};
  rollfem_creep_forces forces;
  ASSERT_EQ(rollfem_table_forces(table.get(), &ellipse, &forces, message, sizeof message),
            ROLLFEM_OK);
  const auto expected = postprocess::CreepTableReader(some_table())
                            .physical(6.0, 5.0, 80e3, 15e3, {0.001, -0.002, 3e-4});
  EXPECT_EQ(forces.longitudinal_force, expected.forces[0]);
  EXPECT_EQ(forces.lateral_force, expected.forces[1]);
  EXPECT_EQ(forces.spin_moment, expected.forces[2]);
  EXPECT_EQ(forces.force_bar, expected.force_bar);
  EXPECT_EQ(forces.moment_bar, expected.moment_bar);
}

TEST(CTable, RefusesAnEllipseOutsideAndAFileThatIsNone) {
  const rollfem::testing::TemporaryFolder folder;
  char message[300];
  const std::string text = folder.file("text.h5", "no table");
  EXPECT_EQ(rollfem_table_open(text.c_str(), message, sizeof message), nullptr);
  EXPECT_NE(std::string(message).find("text.h5"), std::string::npos) << message;
  EXPECT_EQ(rollfem_table_open(nullptr, nullptr, 0), nullptr);
  const std::string file = folder.file("table.h5", postprocess::table_hdf5(some_table()));
  const Table table(rollfem_table_open(file.c_str(), message, sizeof message), rollfem_table_close);
  ASSERT_NE(table, nullptr) << message;
  const rollfem_ellipse narrow{1.0, 5.0, 80e3, 15e3, 0.001, 0.0, 0.0};
  rollfem_creep_forces forces{1.0, 1.0, 1.0, 1.0, 1.0};
  EXPECT_EQ(rollfem_table_forces(table.get(), &narrow, &forces, message, sizeof message),
            ROLLFEM_REFUSED);
  EXPECT_NE(std::string(message).find("a/b = 0.2"), std::string::npos) << message;
  EXPECT_EQ(forces.longitudinal_force, 0.0);
}

}  // namespace

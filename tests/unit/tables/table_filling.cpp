// SPDX-License-Identifier: LGPL-2.1-or-later
// Filled tables against single solutions, the symmetries of rolling, Kalker's coefficients and full
// sliding; and taken up after an end.
#include "tables/filling/table_filling.hpp"

#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"
#include "halfspace/closed_forms/kalker.hpp"
#include "halfspace/model/rolling_ellipse.hpp"
#include "tables/files/table_reader.hpp"
#include "tables/filling/table_grid.hpp"

#include "support/records_in_memory.hpp"

namespace {

using tables::CreepTable;
using tables::CreepTableReader;
using tables::Scaled;

contact::Case case_of(const std::string& table, double poisson_ratio = 0.25) {
  const std::string material = "poisson_ratio = " + std::to_string(poisson_ratio) + "\n";
  return contact::parse_case(
      "[load]\nnormal_force = 50e3\n[friction]\ncoefficient = 0.3\n[wheel]\nrolling_radius = "
      "450.0\ntransverse_radius = inf\n" +
          material + "[rail]\ntransverse_radius = 300.0\n" + material + "[table]\n" + table,
      "case");
}

CreepTable filled(const contact::Case& input, contact::Checkpoint* checkpoint = nullptr) {
  CreepTable table = tables::empty_table(input);
  tables::fill_table(table, input, {}, checkpoint);
  return table;
}

const CreepTable& small_table() {
  static const CreepTable table =
      filled(case_of("axis_ratio = [0.7, 1.4]\npoints = [4, 3, 7]\nlargest = [2.0, 1.5, "
                     "2.0]\ncheck_points = 20\n"));
  return table;
}

/// As the table solves: a correction of 0.15 % at most.
halfspace::EllipseForces solved(const halfspace::EllipseShape& shape,
                                const halfspace::ScaledCreepage& creepage) {
  return halfspace::roll_ellipse(shape, {creepage}, {0.0015})[0];
}

halfspace::ScaledCreepage point_of(const CreepTable& table, std::size_t r, const Scaled& s) {
  return {s[0] / table.scale[r][0], s[1] / table.scale[r][1], s[2] / table.scale[r][2]};
}

TEST(TableFilling, PointsAreSingleSolutions) {
  const CreepTable& table = small_table();
  ASSERT_EQ(table.forces.size(), 2U * 4U * 3U * 7U);
  for (std::size_t n = 3; n < table.size(); n += 17) {
    const std::size_t k = n % 7, j = n / 7 % 3, i = n / 21 % 4, r = n / 84;
    ASSERT_EQ(table.place(r, i, j, k), n);
    const auto alone = solved(
        {table.axis_ratio[r], table.poisson_ratio},
        point_of(table, r, {table.creepage[0][i], table.creepage[1][j], table.creepage[2][k]}));
    EXPECT_NEAR(table.forces[n][0], alone.limit.longitudinal, 1e-10) << n;
    EXPECT_NEAR(table.forces[n][1], alone.limit.lateral, 1e-10) << n;
    EXPECT_NEAR(table.forces[n][2], alone.limit.spin_moment, 1e-10) << n;
    EXPECT_GE(table.bars[n][0],
              std::hypot(alone.correction.longitudinal, alone.correction.lateral));
  }
}

TEST(TableFilling, SymmetriesThatTheReaderUsesAreThoseOfTheSolution) {
  const CreepTable& table = small_table();
  const CreepTableReader reader(table);
  const double x = table.creepage[0][2], y = table.creepage[1][1], z = table.creepage[2][5];
  for (const Scaled& s : {Scaled{-x, y, z}, Scaled{x, -y, z}, Scaled{x, y, -z}, Scaled{-x, -y, z},
                          Scaled{-x, y, -z}, Scaled{x, -y, -z}, Scaled{-x, -y, -z}}) {
    const auto alone = solved({0.7, table.poisson_ratio}, point_of(table, 0, s)).limit;
    const Scaled found = reader.at(0.7, s).forces;
    EXPECT_NEAR(found[0], alone.longitudinal, 1e-9);
    EXPECT_NEAR(found[1], alone.lateral, 1e-9);
    EXPECT_NEAR(found[2], alone.spin_moment, 1e-9);
  }
}

TEST(TableFilling, BeginsAsKalkersLinearTheoryAndEndsInFullSliding) {
  const contact::Case input = case_of(
      "axis_ratio = [0.4]\nlongitudinal_values = [0.0, 0.002, 300.0]\nlateral_values = [0.0, "
      "0.002, 400.0]\n"
      "spin_values = [0.0, 0.004]\ncheck_points = 0\n");
  const CreepTable table = filled(input);
  const auto c = halfspace::kalker_coefficients(std::sqrt(0.4), 1.0 / std::sqrt(0.4), 0.25);
  const auto at = [&](std::size_t i, std::size_t j, std::size_t k) {
    return table.forces[table.place(0, i, j, k)];
  };
  // Scaled so that the linear forces are -3 xi', -3 eta' and, of spin, the coefficient's share.
  EXPECT_NEAR(at(1, 0, 1)[0] / -0.006, 1.0, 0.015);
  EXPECT_NEAR(at(0, 1, 1)[1] / -0.006, 1.0, 0.015);
  EXPECT_NEAR(at(0, 0, 2)[1] / (-0.004 * c.c23 / std::hypot(c.c23, c.c33)), 1.0, 0.02);
  EXPECT_NEAR(at(0, 0, 2)[2] / (-0.004 * c.c33 / std::hypot(c.c23, c.c33)), 1.0, 0.03);
  // Both: sliding against the direction of the creepages themselves.
  const double xi = 300.0 / table.scale[0][0], eta = 400.0 / table.scale[0][1];
  const Scaled sliding = at(2, 2, 1);
  EXPECT_NEAR(sliding[0], -xi / std::hypot(xi, eta), 1e-4);
  EXPECT_NEAR(sliding[1], -eta / std::hypot(xi, eta), 1e-4);
  EXPECT_NEAR(std::hypot(sliding[0], sliding[1]), 1.0, 1e-6);
}

TEST(TableFilling, InterpolationIsJudgedAtPointsThatWereSolvedFor) {
  const CreepTable& table = small_table();
  ASSERT_EQ(table.checked.size(), 20U);
  const CreepTableReader reader(table);
  double largest = 0.0;
  for (const auto& point : table.checked) {
    const Scaled scale = reader.scale_at(point.place);
    const auto alone = solved(
        {point.place.first, table.poisson_ratio},
        {point.creepage[0] / scale[0], point.creepage[1] / scale[1], point.creepage[2] / scale[2]});
    EXPECT_NEAR(point.solved[0], alone.limit.longitudinal, 1e-10);
    EXPECT_GE(point.place.first, 0.7);
    EXPECT_LE(point.place.first, 1.4);
    largest = std::max(largest, std::hypot(point.interpolated[0] - alone.limit.longitudinal,
                                           point.interpolated[1] - alone.limit.lateral));
  }
  EXPECT_NEAR(table.interpolation.force_max, largest, 1e-9);
  EXPECT_LE(table.interpolation.force_95, table.interpolation.force_max);
  EXPECT_GT(table.interpolation.force_rms, 0.0);
}

TEST(TableFilling, TakenUpItIsTheSameToTheLastBit) {
  const contact::Case input = case_of(
      "axis_ratio = [0.7, 1.4]\npoints = [4, 3, 7]\nlargest = [2.0, 1.5, 2.0]\ncheck_points = "
      "20\n");
  RecordsInMemory memory;
  const CreepTable whole = filled(input, &memory);
  EXPECT_EQ(whole.forces, small_table().forces);
  const std::size_t all = memory.records.size();
  EXPECT_GE(all, 4U);
  memory.forget_every_second();
  EXPECT_EQ(filled(input, &memory).forces, whole.forces);
  EXPECT_EQ(memory.records.size(), all);
}

TEST(TableFilling, AnExceptionOfProgressEndsIt) {
  struct Stop {};
  const contact::Case input = case_of("points = [3, 3, 3]\ncheck_points = 0\n");
  CreepTable table = tables::empty_table(input);
  EXPECT_THROW(tables::fill_table(
                   table, input, [](const contact::ProgressEvent&) { throw Stop(); }, nullptr),
               Stop);
}

TEST(TableGrid, IsTheEllipseOfTheCaseUnlessRatiosAreNamed) {
  const CreepTable own =
      tables::empty_table(case_of("points = [3, 4, 5]\nlargest = [2.0, 3.0, 4.0]\n"));
  ASSERT_EQ(own.axis_ratio.size(), 1U);
  // Rolling radius 450 across a rail of 300 mm: longer along rolling.
  EXPECT_GT(own.axis_ratio[0], 1.0);
  EXPECT_LT(own.axis_ratio[0], 450.0 / 300.0);
  EXPECT_EQ(own.creepage[0].size(), 3U);
  EXPECT_EQ(own.creepage[1].back(), 3.0);
  EXPECT_EQ(own.creepage[2].front(), -4.0);
  EXPECT_NEAR(own.creepage[2][2], 0.0, 1e-15);
  const CreepTable listed = tables::empty_table(case_of(
      "axis_ratio = [0.5, 2.0]\nlongitudinal_values = [0.0, 1.0]\nspin_values = [0.5, 1.0]\n"));
  EXPECT_EQ(listed.axis_ratio, (std::vector<double>{0.5, 2.0}));
  EXPECT_EQ(listed.creepage[2], (std::vector<double>{-1.0, -0.5, 0.5, 1.0}));
}

TEST(TableGrid, RefusesListsThatDoNotIncrease) {
  for (const char* text :
       {"axis_ratio = [1.0, 0.5]\n", "longitudinal_values = [0.0, 2.0, 1.0]\n",
        "longitudinal_values = [0.5, 1.0]\n", "lateral_values = [0.0]\n", "spin_values = [0.0]\n",
        "points = [200, 200, 200]\naxis_ratio = [0.5, 1.0, 2.0]\n"})
    EXPECT_THROW(tables::empty_table(case_of(text)), contact::InputError) << text;
}

TEST(TableGrid, OfALineThereIsNoEllipse) {
  contact::Case line = case_of("points = [3, 3, 3]\n");
  line.geometry.shape = contact::ContactShape::line;
  EXPECT_THROW(tables::empty_table(line), contact::InputError);
}

}  // namespace

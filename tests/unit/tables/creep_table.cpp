// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables of creep forces: between their points, under reversal and in the mirror, beyond their end,
// and damaged files.
#include "base/errors.hpp"
#include "tables/files/axis_weights.hpp"
#include "tables/files/table_files.hpp"
#include "tables/files/table_reader.hpp"

#include "support/temporary_folder.hpp"

namespace {

using tables::AxisWeights;
using tables::CreepTable;
using tables::CreepTableReader;
using tables::Scaled;

double along(const std::vector<double>& nodes, double place, bool mirrored, double (*f)(double)) {
  const AxisWeights weights = tables::axis_weights(nodes, place, mirrored);
  double sum = 0.0;
  for (int n = 0; n < 4; ++n) {
    if (weights.weight[n] == 0.0) continue;
    const int node = weights.first + n;
    sum += weights.weight[n] * (node < 0 ? f(-nodes[1]) : f(nodes[static_cast<std::size_t>(node)]));
  }
  return sum;
}

const std::vector<double> uneven{0.0, 0.3, 0.5, 1.1, 2.0, 2.2};

TEST(AxisWeights, AreExactForParabolasWhereverTheNodesAre) {
  const auto parabola = [](double x) { return 1.0 - 2.0 * x + 3.0 * x * x; };
  for (double x = 0.0; x <= 2.2; x += 0.05) {
    EXPECT_NEAR(along(uneven, x, false, parabola), parabola(x), 1e-13) << x;
    EXPECT_NEAR(along(uneven, x, true, parabola), parabola(x), 1e-13) << x;
  }
}

TEST(AxisWeights, AreSmoothAcrossNodes) {
  const auto f = [](double x) { return std::sin(3.0 * x); };
  for (const double node : {0.3, 0.5, 1.1, 2.0}) {
    const double h = 1e-6;
    const double before = (along(uneven, node, true, f) - along(uneven, node - h, true, f)) / h;
    const double after = (along(uneven, node + h, true, f) - along(uneven, node, true, f)) / h;
    EXPECT_NEAR(before, after, 1e-4) << node;
  }
  // An odd function stays odd at its mirror.
  EXPECT_NEAR(along(uneven, 0.0, true, f), 0.0, 1e-15);
}

TEST(AxisWeights, BentValuesAreFollowedOnBothSidesOfZero) {
  const std::vector<double> nodes{-1.2, -0.7, -0.3, 0.0, 0.3, 0.7, 1.2};
  const auto bent = [](double x) { return 3.0 * x - 3.0 * x * std::abs(x); };
  for (double x = -0.7; x <= 0.7; x += 0.05) {
    const AxisWeights weights = tables::axis_weights(nodes, x, false, tables::AtZero::bent);
    double sum = 0.0;
    for (std::size_t n = 0; n < 4; ++n)
      if (weights.weight[n] != 0.0)
        sum += weights.weight[n] * bent(nodes[static_cast<std::size_t>(weights.first) + n]);
    EXPECT_NEAR(sum, bent(x), 1e-13) << x;
  }
}

TEST(AxisWeights, TwoNodesAreALineAndOneAConstant) {
  const auto f = [](double x) { return 1.0 + x; };
  EXPECT_NEAR(along({1.0, 3.0}, 1.5, false, f), 2.5, 1e-14);
  EXPECT_NEAR(along({2.0}, 2.0, false, f), 3.0, 1e-14);
}

/// A force law with the symmetries of rolling: odd, and in the mirror F_y and M_z turn round. It
/// stays below the bound of friction.
Scaled law(double ratio, const Scaled& s) {
  const double size = 1.5 * std::sqrt(1.0 + s[0] * s[0] + s[1] * s[1] + 0.3 * s[2] * s[2] / ratio);
  return {-s[0] / size, -(s[1] + 0.4 * s[2]) / size, (0.4 * s[1] - 0.5 * s[2]) / size};
}

CreepTable table_of_law(int count) {
  CreepTable table;
  table.title = "a law";
  table.program = "test";
  table.case_text = "[load]\nnormal_force = 1.0\n";
  table.poisson_ratio = 0.28;
  table.axis_ratio = {0.5, 0.8, 1.3, 2.0};
  table.creepage = {tables::creepages_to(3.0, count), tables::creepages_to(2.0, count),
                    tables::spins_to(4.0, 2 * count - 1)};
  for (const double ratio : table.axis_ratio) {
    table.scale.push_back({1.0 + ratio, 1.2, 1.5 * ratio});
    for (const double x : table.creepage[0])
      for (const double y : table.creepage[1])
        for (const double z : table.creepage[2]) {
          table.forces.push_back(law(ratio, {x, y, z}));
          table.bars.push_back({0.001 * (1.0 + x), 0.002});
          table.elements_across.push_back(20);
        }
  }
  table.interpolation.force_95 = 0.01;
  table.interpolation.moment_95 = 0.02;
  return table;
}

void expect_law(const CreepTableReader& reader, double ratio, const Scaled& s, double tolerance) {
  const Scaled found = reader.at(ratio, s).forces, exact = law(ratio, s);
  for (std::size_t q = 0; q < 3; ++q)
    EXPECT_NEAR(found[q], exact[q], tolerance)
        << q << " at " << ratio << ": " << s[0] << ", " << s[1] << ", " << s[2];
}

TEST(CreepTable, IsItsPointsAtItsPointsAndTheirMirrorImages) {
  const CreepTableReader reader(table_of_law(6));
  const CreepTable& table = reader.table();
  for (const double x : table.creepage[0])
    for (const double y : table.creepage[1])
      for (const double z : table.creepage[2])
        for (const double a : {-1.0, 1.0})
          for (const double b : {-1.0, 1.0}) expect_law(reader, 0.8, {a * x, b * y, z}, 1e-13);
}

TEST(CreepTable, ErrorBetweenPointsFallsWithTheirNumber) {
  const auto largest = [](int count) {
    const CreepTableReader reader(table_of_law(count));
    double error = 0.0;
    for (double x = -2.9; x < 3.0; x += 0.37)
      for (double y = -1.9; y < 2.0; y += 0.31)
        for (double z = -3.9; z < 4.0; z += 0.43)
          for (std::size_t q = 0; q < 3; ++q)
            error = std::max(
                error, std::abs(reader.at(0.8, {x, y, z}).forces[q] - law(0.8, {x, y, z})[q]));
    return error;
  };
  const double coarse = largest(9), fine = largest(25);
  EXPECT_LT(fine, 2e-3);
  EXPECT_GT(coarse / fine, 9.0);  // second order at least
}

TEST(CreepTable, BeyondItsEndOnlyTheDirectionCounts) {
  const CreepTableReader reader(table_of_law(8));
  const Scaled at_end = reader.at(1.0, {3.0, 1.0, -2.0}).forces;
  const Scaled beyond = reader.at(1.0, {300.0, 100.0, -200.0}).forces;
  for (std::size_t q = 0; q < 3; ++q) EXPECT_NEAR(at_end[q], beyond[q], 1e-12);
}

TEST(CreepTable, PhysicalForcesAreThoseOfTheScaledCreepages) {
  const CreepTableReader reader(table_of_law(8));
  const double a = 6.0, b = 7.5, modulus = 80e3, bound = 15e3;  // a/b = 0.8, a point of the table
  const double c = std::sqrt(a * b), stiffness = modulus * a * b / bound;
  const Scaled creepage{0.002, -0.001, 3e-4};
  const auto scaled = reader.at(0.8, {1.8 * stiffness * creepage[0], 1.2 * stiffness * creepage[1],
                                      1.2 * stiffness * c * creepage[2]});
  const auto found = reader.physical(a, b, modulus, bound, creepage);
  EXPECT_NEAR(found.forces[0], bound * scaled.forces[0], 1e-8);
  EXPECT_NEAR(found.forces[1], bound * scaled.forces[1], 1e-8);
  EXPECT_NEAR(found.forces[2], bound * c * scaled.forces[2], 1e-8);
  EXPECT_NEAR(found.force_bar, bound * scaled.force_bar, 1e-9);
  // The same contact in m and Pa.
  const auto metres = reader.physical(6e-3, 7.5e-3, 80e9, bound, {0.002, -0.001, 0.3});
  EXPECT_NEAR(metres.forces[0], found.forces[0], 1e-8);
  EXPECT_NEAR(metres.forces[2], 1e-3 * found.forces[2], 1e-8);
}

TEST(CreepTable, BarsAreThoseOfTheGridAndOfInterpolation) {
  const CreepTableReader reader(table_of_law(8));
  const double above =
      *std::upper_bound(reader.table().creepage[0].begin(), reader.table().creepage[0].end(), 1.5);
  const auto found = reader.at(0.8, {1.5, 0.0, 0.0});
  EXPECT_NEAR(found.force_bar, 0.001 * (1.0 + above) + 0.01, 1e-15);
  EXPECT_NEAR(found.moment_bar, 0.002 + 0.02, 1e-15);
}

TEST(CreepTable, RefusesRatiosOutsideAndNaNs) {
  const CreepTableReader reader(table_of_law(4));
  EXPECT_THROW(reader.at(0.49, {}), contact::InputError);
  EXPECT_THROW(reader.at(2.01, {}), contact::InputError);
  EXPECT_NO_THROW(reader.at(2.001, {}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(reader.at(nan, {}), contact::InputError);
  EXPECT_THROW(reader.at(1.0, {nan, 0.0, 0.0}), contact::InputError);
  EXPECT_THROW(reader.physical(0.0, 1.0, 1.0, 1.0, {}), contact::InputError);
  CreepTable broken = table_of_law(4);
  broken.forces.pop_back();
  EXPECT_THROW(CreepTableReader{broken}, contact::InputError);
  broken = table_of_law(4);
  broken.creepage[2].front() = -5.0;
  EXPECT_THROW(CreepTableReader{broken}, contact::InputError);
}

TEST(CreepTable, DamagedAndForeignFilesAreRefused) {
  const TemporaryFolder folder;
  std::string bytes = tables::table_hdf5(table_of_law(4));
  bytes[bytes.size() / 2] ^= 1;
  EXPECT_THROW(tables::read_table(folder.file("table.h5", bytes)), contact::InputError);
  EXPECT_THROW(tables::read_table(folder.file("text.h5", "no table")), contact::InputError);
  EXPECT_THROW(tables::read_table((folder.path() / "nothing.h5").string()), contact::InputError);
}

}  // namespace

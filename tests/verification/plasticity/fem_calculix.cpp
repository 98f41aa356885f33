// SPDX-License-Identifier: LGPL-2.1-or-later
// Passes of a line contact over hardening steel against another finite-element program, which moves
// the load step by step: CalculiX 2.20, by benchmarks/calculix/rolled_line.py.
#include "support/fem_plane_strain.hpp"

namespace {

/// Means over the cell in this depth, half-widths: plastic strain xz in thousandths, residual
/// stress along and across over p0.
struct OfCell {
  double depth, plastic_xz, along, across;
};
using OfPass = std::vector<OfCell>;

/// --cells 4 --travel 16 --step 0.5 --extent 40
const OfPass without_friction{
    {0.125, 0.00000, 0.0069, 0.0021},   {0.375, 0.06850, -0.0762, -0.0956},
    {0.625, 0.60251, -0.1378, -0.1384}, {0.875, 0.76919, -0.1315, -0.1119},
    {1.125, 0.58368, -0.1064, -0.0783}, {1.375, 0.29145, -0.0678, -0.0447},
    {1.625, 0.05613, -0.0172, -0.0117}, {1.875, 0.00000, 0.0073, 0.0022}};

/// --cells 8 --friction 0.2
const OfPass with_friction{
    {0.0625, 1.04293, 0.1999, -0.0534},  {0.1875, 1.64454, 0.1462, -0.1056},
    {0.3125, 2.05146, 0.0638, -0.1482},  {0.4375, 2.34645, -0.0088, -0.1699},
    {0.5625, 2.41572, -0.0614, -0.1735}, {0.6875, 2.35071, -0.0949, -0.1660},
    {0.8125, 2.19433, -0.1139, -0.1519}, {0.9375, 1.96963, -0.1228, -0.1349},
    {1.0625, 1.70192, -0.1243, -0.1169}, {1.1875, 1.40806, -0.1199, -0.0989},
    {1.3125, 1.10553, -0.1107, -0.0815}, {1.4375, 0.81361, -0.0974, -0.0650},
    {1.5625, 0.55013, -0.0803, -0.0495}, {1.6875, 0.32894, -0.0593, -0.0345},
    {1.8125, 0.15492, -0.0351, -0.0199}, {1.9375, 0.03248, -0.0065, -0.0046}};

/// --cells 4 --friction 0.2 --travel 5 --passes 3
const std::vector<OfPass> three_passes{{{0.125, 1.34904, 0.1639, -0.0650},
                                        {0.375, 2.03862, 0.0265, -0.1415},
                                        {0.625, 2.21435, -0.0796, -0.1585},
                                        {0.875, 1.92865, -0.1210, -0.1365},
                                        {1.125, 1.41928, -0.1232, -0.1034},
                                        {1.375, 0.85139, -0.1027, -0.0701},
                                        {1.625, 0.37663, -0.0654, -0.0393},
                                        {1.875, 0.06875, -0.0135, -0.0091}},
                                       {{0.125, 1.99187, 0.1284, -0.0976},
                                        {0.375, 3.88190, -0.0004, -0.1786},
                                        {0.625, 4.04167, -0.0965, -0.1803},
                                        {0.875, 2.68337, -0.1378, -0.1522},
                                        {1.125, 1.49529, -0.1261, -0.1070},
                                        {1.375, 0.85139, -0.0984, -0.0690},
                                        {1.625, 0.37663, -0.0610, -0.0381},
                                        {1.875, 0.06875, -0.0091, -0.0079}},
                                       {{0.125, 2.18925, 0.1137, -0.1078},
                                        {0.375, 4.81523, -0.0058, -0.1798},
                                        {0.625, 4.80484, -0.1043, -0.1849},
                                        {0.875, 2.84482, -0.1420, -0.1558},
                                        {1.125, 1.49529, -0.1243, -0.1064},
                                        {1.375, 0.85139, -0.0967, -0.0685},
                                        {1.625, 0.37663, -0.0594, -0.0376},
                                        {1.875, 0.06875, -0.0076, -0.0074}}};

Passes rolled_passes(const RolledBody& slab, double friction) {
  Passes passes(slab, plain_steel(300.0, 210e3 / 20.0), 3.9 * 300.0, friction);
  passes.accuracy.steps = 1;  // from Gauss point to Gauss point, half a cell, as there
  return passes;
}

/// Of a pass and what is left when the load is away.
OfPass means_over_cells(const Passes& passes) {
  Passes unloaded = passes;
  unloaded.elastic.assign(passes.elastic.size(), {});
  EXPECT_EQ(unloaded.next(), 0.0);  // no more flow, and uniform along the slab
  const auto residual = residual_below(unloaded, -1.0, 1.0);
  const fem::Streamlines& lines = passes.of.lines;
  OfPass cells;
  for (std::size_t stream = 0; stream < lines.streams(); stream += lines.width()) {
    const auto& stress = residual.at(lines.section(stream)[1]);
    if (stream / lines.width() % 2 == 0) cells.push_back({});
    OfCell& cell = cells.back();
    cell.depth += 0.5 * lines.section(stream)[1];
    cell.plastic_xz += 0.5e3 * passes.state.leaving[stream].strain[5];
    cell.along += 0.5 * stress[0] / passes.load_factor;
    cell.across += 0.5 * stress[1] / passes.load_factor;
  }
  return cells;
}

/// Strain relative to its largest.
struct Tolerance {
  double at_surface, strain, stress;  ///< at_surface: strain in the first two cells
};

void expect_near(const OfPass& cells, const OfPass& expected, const Tolerance& tolerance) {
  ASSERT_EQ(cells.size(), expected.size());
  double largest = 0.0;
  for (const OfCell& cell : expected) largest = std::max(largest, std::abs(cell.plastic_xz));
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const OfCell& cell = cells[k];
    ASSERT_NEAR(cell.depth, expected[k].depth, 1e-4);
    EXPECT_NEAR(cell.plastic_xz, expected[k].plastic_xz,
                (k < 2 ? tolerance.at_surface : tolerance.strain) * largest)
        << cell.depth;
    EXPECT_NEAR(cell.along, expected[k].along, tolerance.stress) << cell.depth;
    EXPECT_NEAR(cell.across, expected[k].across, tolerance.stress) << cell.depth;
  }
}

std::unique_ptr<RolledBody> slab_as_in_calculix(int per_half_width, double extent) {
  SlabOptions options;
  options.per_half_width = per_half_width;
  options.extent = extent;
  return rolled_slab(options);
}

}  // namespace

// 3.9 k with Prager's hardening E/20; the same cells (there with 8 nodes), steps and clamped ends.
// What remains is the way that the load has come: these 16 half-widths to both sides leave 1.6 % of
// strain and 0.007 p0 of stress along. In a copy of CalculiX's scheme that gives its numbers to
// 1e-4, 6, 12 and 24 leave 5, 2.6 and 0.4 %, and 0.021, 0.011 and 0.003 p0.
TEST(PlasticLineContact, FlowIsThatOfALoadMovedStepByStepInCalculix) {
  const auto slab = slab_as_in_calculix(4, 40.0);
  Passes passes = rolled_passes(*slab, 0.0);
  passes.next();
  expect_near(means_over_cells(passes), without_friction, {0.018, 0.018, 0.008});
}

// Friction makes strain 2.6 times as large. In the first cell, where it begins at the surface, the
// elements differ.
TEST(PlasticLineContact, FlowWithFrictionIsThatOfALoadMovedStepByStepInCalculix) {
  const auto slab = slab_as_in_calculix(8, 20.0);
  Passes passes = rolled_passes(*slab, 0.2);
  passes.next();
  expect_near(means_over_cells(passes), with_friction, {0.065, 0.01, 0.006});
}

// On coarse cells, which leave more of that difference; pass by pass strain grows as there.
TEST(PlasticLineContact, FlowOfThreePassesIsThatOfALoadMovedStepByStepInCalculix) {
  const auto slab = slab_as_in_calculix(4, 20.0);
  Passes passes = rolled_passes(*slab, 0.2);
  for (const OfPass& expected : three_passes) {
    passes.next();
    expect_near(means_over_cells(passes), expected, {0.125, 0.047, 0.012});
  }
}

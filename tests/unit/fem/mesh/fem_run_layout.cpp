// SPDX-License-Identifier: LGPL-2.1-or-later
// Default extent of segments, and rows of cells at a surface that yields.
#include "case/reading/case_reader.hpp"
#include "fem/mesh/run_layout.hpp"

#include "support/model_keys.hpp"
#include "support/test.hpp"

namespace {

/// A roller of this radius on a crown of 500 mm, with a patch some 4 mm long each way.
double extent_of(double radius, const std::string& fem = {}) {
  const contact::Scene scene(contact::parse_case(
      "[load]\nnormal_force = 20e3\n[friction]\ncoefficient = 0.3\n[wheel]\nrolling_radius = " +
          std::to_string(radius) +
          "\ntransverse_radius = inf\n[rail]\ntransverse_radius = 500.0\n" + fem,
      "case"));
  return fem::run_layout(scene, 1.0).bodies.extent;
}

TEST(RunLayout, SegmentsReachEightHalfSizesOrAsFarAsASmallWheelAllows) {
  const contact::Scene scene(contact::parse_case(
      "[load]\nnormal_force = 20e3\n[friction]\ncoefficient = 0.3\n[wheel]\nrolling_radius = "
      "400.0\ntransverse_radius = inf\n[rail]\ntransverse_radius = 500.0\n",
      "case"));
  EXPECT_NEAR(extent_of(400.0) / (8.0 * fem::PatchSearch(scene).box().larger()), 1.0, 1e-12);
  EXPECT_NEAR(extent_of(40.0) / 40.0, 0.68, 0.02);
  EXPECT_DOUBLE_EQ(extent_of(40.0, "[fem]\nextent = 25.0\n"), 25.0) << "what the case says holds";
}

contact::Scene yielding_rail(double friction) {
  return contact::Scene(contact::parse_case(
      "[load]\nnormal_force = 60e3\n[friction]\ncoefficient = " + std::to_string(friction) +
          "\n[wheel]\nrolling_radius = 450.0\ntransverse_radius = inf\n[rail]\ntransverse_radius = "
          "450.0\n[rail_plasticity]\nyield_stress = 400.0\nhardening = 10e3\n",
      "case"));
}

fem::BodyOptions rail_of(const contact::Scene& scene) {
  return fem::options_of(scene, false, fem::run_layout(scene, 0.8).bodies);
}

// With Prager's hardening the strain in shear is proportional to mu p0 (1 - 2 z/a) - k: a tenth
// less at z = 0.05 a (1 - k/(mu p0)), where the first points of the first row may lie.
TEST(RunLayout, RowsAreThinWhereTractionExceedsTheYieldStressInShear) {
  const contact::Scene scene = yielding_rail(0.35);
  const fem::PatchSearch search(scene);
  const double shear = 400.0 / std::sqrt(3.0), traction = 0.35 * search.patch().max_pressure;
  ASSERT_GT(traction, 1.2 * shear);
  const fem::BodyOptions rail = rail_of(scene);
  const double first = rail.rows.depth(rail.cell_size);
  const double expected = 0.05 * search.box().smaller() * (1.0 - shear / traction) / 0.2;
  EXPECT_LE(first, expected * (1.0 + 1e-6));
  EXPECT_GE(first, 0.8 * expected);
  EXPECT_GE(rail.plastic_depth, rail.fine_depth);
}

TEST(RunLayout, RowsAreEqualWhereFrictionIsLow) {
  const fem::BodyOptions low = rail_of(yielding_rail(0.2)), none = rail_of(yielding_rail(0.0));
  EXPECT_TRUE(low.rows.equal_rows());
  EXPECT_EQ(low.plastic_depth, none.plastic_depth);
  EXPECT_EQ(low.fine_depth, none.fine_depth);
  const contact::Scene scene = yielding_rail(0.35);
  EXPECT_TRUE(fem::options_of(scene, true, fem::run_layout(scene, 0.8).bodies).rows.equal_rows())
      << "a wheel that stays elastic";
}

}  // namespace

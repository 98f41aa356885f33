// SPDX-License-Identifier: LGPL-2.1-or-later
// Default extent of segments.
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

}  // namespace

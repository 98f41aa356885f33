// SPDX-License-Identifier: LGPL-2.1-or-later
// Auxiliary coarser grids must not refuse a case that the requested grid can solve.
#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/halfspace_model.hpp"

#include "support/temporary_folder.hpp"

/// Elements of 0.4 by 0.2 mm end 0.8 and 0.4 mm beyond the patch: less than one of the next coarser
/// ones, of which only 11 by 11 fit whole into the extent.
TEST(CoarserLevels, AnExtentThatFitsTheGridAskedForIsTaken) {
  const contact::Case input = contact::parse_case(
      "[load]\nnormal_force = 82e3\n[friction]\ncoefficient = 0.3\n"
      "[wheel]\nyoung_modulus = 209920.0\npoisson_ratio = 0.28\n"
      "[rail]\nyoung_modulus = 209920.0\npoisson_ratio = 0.28\n"
      "[undeformed_distance]\nquadratic = [0.8464e-3, 2.406e-3]\n"
      "[contact_grid]\ncell_size = [0.4, 0.2]\nextent = [17.6, 8.8]\n",
      "extent.toml");
  const contact::ModelResult result = halfspace::run_halfspace(input, {});
  EXPECT_EQ(result.grid.nx, 44);
  EXPECT_EQ(result.grid.ny, 44);
  const contact::PointResult& point = result.points.front();
  const halfspace::HertzContact hertz = halfspace::hertz_of_scene(input);
  EXPECT_NEAR(point.max_pressure, hertz.max_pressure, 1e-3 * hertz.max_pressure);
  const double error = std::abs(point.max_pressure - hertz.max_pressure);
  EXPECT_GT(point.error_estimate.at("max_pressure"), error);
  EXPECT_LT(point.error_estimate.at("max_pressure"), 10.0 * error + 1e-3 * hertz.max_pressure);
}

/// On points of a file no coarser grid can be made larger: it is left out, and with it the
/// estimate.
TEST(CoarserLevels, PointsThatOnlyTheGridAskedForFitsAreTaken) {
  const TemporaryFolder folder;
  std::ostringstream distance;
  for (int j = -5; j <= 5; ++j)
    for (int i = -5; i <= 5; ++i)
      distance << i << ", " << j << ", " << 1e-3 * (i * i + j * j) << '\n';
  folder.file("h.csv", distance.str());
  const contact::Case input = contact::read_case(folder.file(
      "points.toml",
      "[load]\napproach = 0.0423\n[friction]\ncoefficient = 0.3\n"
      "[undeformed_distance]\nfile = \"h.csv\"\n[contact_grid]\ncell_size = [0.5, 0.5]\n"));
  const contact::ModelResult result = halfspace::run_halfspace(input, {});
  const contact::PointResult& point = result.points.front();
  // h is linear between the points: a sphere of 500 mm to 2 %.
  EXPECT_NEAR(point.semi_axis_x, 4.6, 0.1);
  EXPECT_TRUE(point.error_estimate.empty());
  EXPECT_NE(result.note_about("no_bars"), nullptr);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// A small second patch or a near miss beside the main one: finite elements and the hybrid cover it,
// and the hybrid's correction stays small wherever its contact grid goes.
#include "base/errors.hpp"
#include "fem/elasticity/run_level.hpp"
#include "fem/mesh/run_layout.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "hybrid/correction/smooth_parts.hpp"
#include "hybrid/hybrid_compliance.hpp"
#include "hybrid/hybrid_model.hpp"
#include "scene/scene.hpp"

#include "support/mpi_environment.hpp"
#include "support/temporary_folder.hpp"
#include "support/two_humps.hpp"

namespace {

constexpr double half_way_apart = 4.0;  // mm
constexpr double patch_cell = 0.6;      // mm, three in the smaller semi-axis

/// Rigid wheel over two humps, of which the lower one carries less.
contact::Scene second_patch() {
  PatchCase input = rollfem::testing::two_humps(0.01, 20e3, half_way_apart);
  input.wheel.material.young_modulus = contact::infinity;
  input.rolling.problem = contact::Problem::steady;
  input.rolling.creepages = {{0.0, 0.0005, 0.0}};
  input.contact_grid.cell_size = {patch_cell, patch_cell};
  return input;
}

contact::ModelResult by_finite_elements(const contact::Scene& scene) {
  return fem::run_level(scene, {patch_cell, "", false}, {});
}

void expect_like_half_spaces(const contact::ModelResult& result) {
  const contact::PointResult half = halfspace::run_halfspace(second_patch(), {}).points.front();
  const contact::PointResult& point = result.points.front();
  const double bound = 0.55 * half.normal_force;
  EXPECT_EQ(half.patch_count, 2);
  EXPECT_EQ(point.patch_count, 2);
  EXPECT_NEAR(point.contact_area, half.contact_area, 0.02 * half.contact_area);
  EXPECT_NEAR(point.lateral_force, half.lateral_force, 0.02 * bound);
}

}  // namespace

TEST(SecondPatch, FiniteElementsFindIt) {
  expect_like_half_spaces(by_finite_elements(second_patch()));
}

TEST(SecondPatch, TheHybridFindsIt) {
  expect_like_half_spaces(
      hybrid::run_hybrid(second_patch(), {}, nullptr, hybrid::find_smooth_parts));
}

TEST(SecondPatch, FiniteElementsKeepToAnExtentAndReportTheTruncation) {
  contact::Scene scene = second_patch();
  scene.contact_grid.extent = {{14.0, 6.0}};
  scene.contact_grid.middle = {{0.0, -half_way_apart}};
  const contact::ContactGrid grid = fem::run_layout(scene, patch_cell).grid;
  EXPECT_NEAR(grid.ny * grid.dy, 6.0, 2.0 * patch_cell);
  EXPECT_NEAR(grid.y(0) + grid.y(grid.ny - 1), -2.0 * half_way_apart, patch_cell);
  EXPECT_TRUE(says(refusal<contact::SolveError>([&] { by_finite_elements(scene); }),
                   "wheel and rail also touch between"));
}

TEST(SecondPatch, TheCorrectionStaysSmallOnALargeGrid) {
  // Curvature changes what half-spaces are displaced by a fraction of the order of the patch over
  // the radius, at the patch and wherever the grid ends: some 5 patches away.
  contact::Case input = thesis_case('b');
  input.wheel.rolling_radius = 460.0;
  input.rail.transverse_radius = 300.0;
  contact::Scene scene(input);
  scene.follows_surface = 1.0;
  const auto hertz = halfspace::hertz_of_scene(scene);
  const auto grid = contact::ContactGrid::centred(80, 80, 0.75, 0.75);
  const contact::Field pressure =
      hertz_pressure(grid, hertz.semi_axis_x, hertz.semi_axis_y, hertz.max_pressure);
  const contact::Field none = contact::Field::Zero(grid.size());
  const contact::ChartedGeometry geometry(scene.geometry, contact::Chart::arc);
  const hybrid::HybridCompliance whole(scene, geometry, grid, hybrid::find_smooth_parts(scene, {}));
  const halfspace::HalfspaceCompliance half(grid, scene.material);
  const contact::Field correction =
      whole.apply({0.0 * pressure, none, pressure}).n - half.apply({none, none, pressure}).n;
  const double curvature = hertz.semi_axis_x / 300.0;
  const double most = correction.cwiseAbs().maxCoeff() / hertz.approach;
  EXPECT_LT(most, curvature);
}

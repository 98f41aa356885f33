// SPDX-License-Identifier: LGPL-2.1-or-later
// Contacts where finite elements tend to fail, each with a known answer: mostly the half-space on
// the same contact elements, for patches so small beside the radii that the bodies are half-spaces.
#include "base/errors.hpp"
#include "fem/elasticity/fem_model.hpp"
#include "fem/elasticity/run_level.hpp"
#include "fem/fem_options.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "result/validity.hpp"

#include "support/mpi_environment.hpp"
#include "support/temporary_folder.hpp"

namespace {

/// A wheel on a rail with transverse radius, mm; force in N: 50 N make a patch of 0.5 mm between
/// radii of 400 mm, so that what the wheel's curvature adds to the slip is 1e-3 of mu F_z.
Case rollers(double wheel, double rail, double force) {
  Case input;
  input.title = "rollers";
  input.file = "test.toml";
  input.load.normal_force = force;
  input.friction_coefficient = 0.3;
  input.wheel.rolling_radius = wheel;
  input.rail.transverse_radius = rail;
  return input;
}

double smaller_semi_axis(const Case& input) {
  const auto patch = halfspace::hertz_of_scene(input);
  return std::min(patch.semi_axis_x, patch.semi_axis_y);
}

struct Both {
  std::vector<PointResult> fem, halfspace;
};

/// Finite elements with that many cells to the smaller semi-axis, the half-space on the same grid.
Both solve_both(Case input, double cells) {
  const double cell = smaller_semi_axis(input) / cells;
  const auto fem = fem::run_level(input, {cell, "", false}, {});
  input.contact_grid.cell_size = {cell, cell};
  input.contact_grid.extent = {fem.grid.nx * cell, fem.grid.ny * cell};
  const auto half = halfspace::run_halfspace(input, {});
  return {fem.points, half.points};
}

double of_bound(const PointResult& point, const Case& input, double force) {
  return force / (input.friction_coefficient * point.normal_force);
}

/// Pressure within `pressure` relative, forces within `force` of mu F_z.
void expect_same(const Both& both, const Case& input, double pressure, double force) {
  for (std::size_t k = 0; k < both.fem.size(); ++k) {
    const PointResult& f = both.fem[k];
    const PointResult& h = both.halfspace[k];
    EXPECT_LT(contact::contact_residual(f.fields).gap, 1e-4) << k;
    EXPECT_LT(contact::contact_residual(f.fields).excess, 1e-4) << k;
    EXPECT_NEAR(f.max_pressure / h.max_pressure, 1.0, pressure) << k;
    EXPECT_NEAR(of_bound(f, input, f.longitudinal_force), of_bound(h, input, h.longitudinal_force),
                force)
        << k;
    EXPECT_NEAR(of_bound(f, input, f.lateral_force), of_bound(h, input, h.lateral_force), force)
        << k;
  }
}

}  // namespace

TEST(HardFem, FrictionCoefficientOfFive) {
  Case input = rollers(400, 400, 50);
  input.friction_coefficient = 5;
  input.rolling.creepages = {{1e-4, 0, 0}, {2e-3, 0, 0}};
  const Both both = solve_both(input, 8);
  expect_same(both, input, 0.003, 0.006);
  EXPECT_GT(both.fem[0].adhesion_area, 0.95 * both.fem[0].contact_area);
}

TEST(HardFem, FullSlipHasTheForceOfCoulomb) {
  Case input = rollers(400, 400, 50);
  input.rolling.creepages = {{0.5, 0, 0}, {-0.5, 0, 0}, {0, 0.5, 0}};
  const Both both = solve_both(input, 4);
  for (const PointResult& point : both.fem)
    EXPECT_NEAR(std::hypot(point.longitudinal_force, point.lateral_force), 15.0, 1e-6);
  EXPECT_LT(both.fem[0].longitudinal_force, 0);
  EXPECT_GT(both.fem[1].longitudinal_force, 0);
  EXPECT_LT(both.fem[2].lateral_force, 0);
  for (const PointResult& point : both.fem) EXPECT_EQ(point.adhesion_area, 0.0);
}

TEST(HardFem, PureSpin) {
  Case input = rollers(400, 400, 50);
  input.rolling.creepages = {{0, 0, 5e-4}};
  const Both both = solve_both(input, 4);
  expect_same(both, input, 0.005, 0.006);
  EXPECT_NEAR(both.fem[0].spin_moment / both.halfspace[0].spin_moment, 1.0, 0.03);
}

TEST(HardFem, AluminiumOnSteelCouplesPressureAndTraction) {
  Case input = rollers(400, 400, 50);
  input.rail.material = {70e3, 0.33};
  input.rolling.creepages = {{0, 0, 0}, {1e-4, 0, 0}};
  // On 16 elements across the half-space itself is off by 0.008 of mu F_z, by how the coupling
  // meets the leading edge (0.2383 and -0.1890; 0.2466 and -0.1805 on 160): its finer grid is the
  // measure.
  const double cell = smaller_semi_axis(input) / 12.0;
  Both both{fem::run_level(input, {cell, "", false}, {}).points, {}};
  input.contact_grid.elements_across = 80;
  both.halfspace = halfspace::run_halfspace(input, {}).points;
  expect_same(both, input, 0.003, 0.006);
  // The coupling alone makes a force at zero creepage.
  EXPECT_GT(of_bound(both.fem[0], input, both.fem[0].longitudinal_force), 0.2);
}

TEST(HardFem, PatchTwentyTimesAsWideAsLong) {
  Case input = rollers(400, 50000, 50);
  const auto patch = halfspace::hertz_of_scene(input);
  ASSERT_GT(patch.semi_axis_y / patch.semi_axis_x, 20.0);
  input.rolling.creepages = {{1e-4, 0, 0}};
  input.body_extent = 3 * patch.semi_axis_y;
  expect_same(solve_both(input, 4), input, 0.005, 0.01);
}

TEST(HardFem, TinyAndHugeLoadsAreThatOfASimilarContact) {
  // Lengths times k and forces times k^2 leave stresses, strains and creepages as they are.
  // The outer iteration stops at 1e-4 of the slip, sooner or later as rounding has it.
  std::vector<PointResult> points;
  for (const double k : {1.0 / 8192, 1.0, 8192.0}) {
    Case input = rollers(400 * k, 300 * k, 50 * k * k);
    input.rolling.creepages = {{1e-4, 0, 0}};
    points.push_back(
        fem::run_level(input, {smaller_semi_axis(input) / 3, "", false}, {}).points[0]);
  }
  for (const PointResult& point : points) {
    EXPECT_NEAR(point.max_pressure / points[1].max_pressure, 1.0, 1e-6);
    EXPECT_NEAR(point.traction_coefficient / points[1].traction_coefficient, 1.0, 1e-4);
  }
}

TEST(HardFem, OneMilliNewtonOnAFullWheel) {
  Case input = rollers(400, 400, 1e-3);
  input.rolling.creepages = {{0, 0, 0}, {2e-6, 0, 0}};
  expect_same(solve_both(input, 8), input, 0.003, 0.006);
}

TEST(HardFem, GrazingLoadOnThreeCellsIsWithinItsErrorEstimate) {
  Case input = rollers(400, 400, 50);
  const auto exact = halfspace::hertz_of_scene(input);
  input.options.set<fem::FemOptions>().cell_size = exact.semi_axis_x / 1.5;
  input.rolling.creepages = {{0, 0, 0}};
  const PointResult point = fem::run_fem(input, {}).points[0];
  EXPECT_NEAR(point.normal_force, 50.0, 50.0 * 1e-10) << "what the sharing of the load is ended at";
  EXPECT_NEAR(point.max_pressure, exact.max_pressure, point.error_estimate.at("max_pressure"));
  EXPECT_NEAR(point.semi_axis_x, exact.semi_axis_x, point.error_estimate.at("semi_axis_x"));
}

TEST(HardFem, PatchAtTheEdgeOfTheMeshIsRefused) {
  Case input = rollers(400, 400, 50);
  input.rolling.creepages = {{0, 0, 0}};
  input.body_extent = 1.05 * smaller_semi_axis(input);
  EXPECT_TRUE(says(refusal<contact::InputError>([&] {
                     fem::run_level(input, {smaller_semi_axis(input) / 3, "", false}, {});
                   }),
                   "fem.extent", "enlarge"));
}

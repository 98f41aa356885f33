// SPDX-License-Identifier: LGPL-2.1-or-later
// Every problem of the half-space by finite elements, on bodies that curve gently: both models pose
// one problem, so that they differ by elasticity alone; the cells are coarse, a quarter of the
// patch, and finite elements then transmit some per cent more at the same creepage.
#include "fem/elasticity/fem_model.hpp"
#include "fem/elasticity/run_level.hpp"
#include "fem/mesh/run_layout.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/halfspace_model.hpp"

#include "support/mpi_environment.hpp"
#include "support/thesis_cases.hpp"

namespace {

constexpr double coarse = 1.5;  // mm, a quarter of the patch of case b
constexpr double fine = 1.2;

Case case_b(double cell = coarse) {
  Case input = thesis_case('b');
  input.options.set<fem::FemOptions>().cell_size = cell;
  input.contact_grid.cell_size = {{cell, cell}};
  input.body_extent = 30.0;
  input.options.set<fem::FemOptions>().linear_solver = fem::LinearMethod::factorisation;
  input.output.fields = false;
  return input;
}

ModelResult finite_elements(const Case& input) {
  const double cell = input.options.of<fem::FemOptions>().cell_size.value();
  return fem::run_level(input, {cell, "", false, nullptr}, {});
}

ModelResult half_space(const Case& input) {
  return halfspace::run_halfspace(input, {});
}

double sliding(const Case& input, const PointResult& point) {
  return input.friction_coefficient * point.normal_force;
}

TEST(FemProblems, PrescribedForceIsMetAndNeedsTheCreepageOfTheHalfSpace) {
  Case input = case_b();
  input.rolling.creepages = {{}, {0.0, 0.0, 5e-5}};
  input.rolling.forces = {{-10e3, {}}, {-8e3, 6e3}};
  const ModelResult fem = finite_elements(input);
  const ModelResult half = half_space(input);
  for (std::size_t k = 0; k < 2; ++k) {
    SCOPED_TRACE(k);
    const PointResult& point = fem.points[k];
    EXPECT_NEAR(point.normal_force, 50e3, 1e-6 * 50e3);
    EXPECT_NEAR(point.longitudinal_force, *input.rolling.forces[k].longitudinal, 2e-5 * 27.5e3);
    const contact::Creepage& found = half.points[k].creepage;
    EXPECT_NEAR(point.creepage.longitudinal, found.longitudinal, 0.1 * found.longitudinal);
  }
  EXPECT_NEAR(fem.points[1].lateral_force, 6e3, 2e-5 * 27.5e3);
}

TEST(FemProblems, ShiftLeavesAnAdhesionAreaLikeCattaneos) {
  // Cattaneo (1938): the adhesion area is the contact scaled by (1 - F/(mu N))^(1/3).
  Case input = case_b(fine);
  input.rolling.problem = Problem::shift;
  input.rolling.creepages.assign(2, {});
  input.history.assign(2, {});
  input.rolling.forces = {{-0.5 * 27.5e3, {}}, {-0.8 * 27.5e3, {}}};
  const ModelResult fem = finite_elements(input);
  const ModelResult half = half_space(input);
  for (std::size_t k = 0; k < 2; ++k) {
    SCOPED_TRACE(k);
    EXPECT_NEAR(fem.points[k].longitudinal_force, *input.rolling.forces[k].longitudinal, 1.0);
    const double part = -*input.rolling.forces[k].longitudinal / 27.5e3;
    EXPECT_NEAR(fem.points[k].adhesion_area / fem.points[k].contact_area,
                std::pow(1.0 - part, 2.0 / 3.0), 0.05);
    // A clamped segment is stiffer than a half-space by some of a/L.
    EXPECT_NEAR(fem.points[k].longitudinal_shift / half.points[k].longitudinal_shift, 1.0, 0.06);
  }
}

TEST(FemProblems, TransientRollingEndsInTheSteadyState) {
  Case steady = case_b();
  steady.rolling.creepages = {{1e-3, 5e-4, 0.0}};
  // Steps in time make the plain difference, without the fit to the leading edge.
  steady.rolling.leading_edge = contact::LeadingEdge::plain;
  const PointResult end = finite_elements(steady).points.front();
  Case input = steady;
  roll_on(input, 20, coarse, {1e-3, 5e-4, 0.0});
  const ModelResult rolled = finite_elements(input);
  EXPECT_LT(std::abs(rolled.points.front().longitudinal_force),
            0.4 * std::abs(end.longitudinal_force));
  const PointResult& last = rolled.points.back();
  EXPECT_NEAR(last.longitudinal_force, end.longitudinal_force, 0.02 * sliding(steady, end));
  EXPECT_NEAR(last.lateral_force, end.lateral_force, 0.02 * sliding(steady, end));
}

TEST(FemProblems, BarsOfALongStepHoldTheSteadyStateThatGoesOn) {
  Case input = case_b();
  roll_on(input, 2, 12.0, {0.0015, 0.0007, 2e-4});  // twice the patch
  input.starts_steady = true;
  const auto points = fem::run_fem(input, {}).points;
  const double error = std::abs(points[1].longitudinal_force - points[0].longitudinal_force);
  const double bar_of_start = points[0].error_estimate.at("longitudinal_force");
  const double bar = points[1].error_estimate.at("longitudinal_force");
  EXPECT_GT(error, 2.0 * bar_of_start);  // of the step, not of the cells
  EXPECT_LT(error, bar + bar_of_start);
  EXPECT_LT(bar, 3.0 * error);
}

TEST(FemProblems, ARigidBodyLeavesTheOtherToHertz) {
  // One body alone has twice the contact modulus of two.
  Case input = case_b();
  input.load.normal_force = 100e3;
  input.rail.material.young_modulus = contact::infinity;
  input.rolling.problem = Problem::frictionless;
  const halfspace::HertzContact hertz =
      halfspace::hertz_from_force(0.5 / 405.0, 0.5 / 500.0, 210e3 / 0.91, 100e3);
  const PointResult pressed = finite_elements(input).points.front();
  // Ten elements across lose about 1 % of p0, of half-spaces too (0.21 % at 20, order 2).
  EXPECT_NEAR(pressed.max_pressure / hertz.max_pressure, 1.0, 0.015);
  EXPECT_NEAR(pressed.approach / hertz.approach, 1.0, 0.02);
}

TEST(FemProblems, ARigidBodyRollsAsInTheHalfSpace) {
  // Pressure alone moves the surface of the elastic one, in the wheel against that of the rail.
  for (const bool rigid_wheel : {true, false}) {
    SCOPED_TRACE(rigid_wheel);
    Case input = case_b(fine);
    input.load.normal_force = 100e3;
    (rigid_wheel ? input.wheel.material : input.rail.material).young_modulus = contact::infinity;
    input.rolling.creepages = {{5e-4, rigid_wheel ? 5e-4 : 0.0, 0.0}};
    const PointResult fem = finite_elements(input).points.front();
    const PointResult half = half_space(input).points.front();
    const double unit = sliding(input, half);
    EXPECT_NEAR(fem.max_pressure / half.max_pressure, 1.0, 0.02);
    EXPECT_NEAR(fem.longitudinal_force, half.longitudinal_force, 0.03 * unit);
    EXPECT_NEAR(fem.lateral_force, half.lateral_force, 0.03 * unit);
  }
}

TEST(FemProblems, ALayerThatYieldsTransmitsAsMuchAsBetweenHalfSpaces) {
  Case input = case_b(1.8);
  input.body_extent = 18.0;
  input.layer = contact::Layer{0.02, 800.0, 150.0, 500.0};
  input.rolling.creepages = {{3e-3, 0.0, 0.0}};
  const PointResult fem = finite_elements(input).points.front();
  const PointResult half = half_space(input).points.front();
  EXPECT_NEAR(fem.longitudinal_force, half.longitudinal_force, 0.03 * sliding(input, half));
  const contact::ContactFields& fields = fem.fields;
  int yielding = 0;
  for (std::size_t e = 0; e < fields.state.size(); ++e) {
    if (fields.state[e] != contact::ElementState::plastic) continue;
    // The yield stress and what all creepage along the patch could harden, below friction.
    ++yielding;
    const auto k = static_cast<Eigen::Index>(e);
    const double size = std::hypot(fields.traction.x[k], fields.traction.y[k]);
    EXPECT_GE(size, 150.0 * (1.0 - 1e-6));
    EXPECT_LE(size, 150.0 + 500.0 * 3e-3 * 12.0);
    EXPECT_LE(size, 0.55 * fields.traction.n[k] * (1.0 + 1e-6));
  }
  EXPECT_GT(yielding, 5);
}

TEST(FemProblems, GivenPressureAndQuadraticDistance) {
  Case given = case_b();
  given.given_pressure = contact::GivenPressure{6.0, 6.0, 700.0};
  given.rolling.creepages = {{1e-3, 0.0, 1e-4}};
  const PointResult fem = finite_elements(given).points.front();
  const PointResult half = half_space(given).points.front();
  EXPECT_NEAR(fem.normal_force / half.normal_force, 1.0, 0.01);
  EXPECT_NEAR(fem.longitudinal_force, half.longitudinal_force, 0.03 * sliding(given, half));
  EXPECT_NEAR(fem.lateral_force, half.lateral_force, 0.03 * sliding(given, half));

  Case flat = case_b();
  flat.wheel.rolling_radius = flat.rail.transverse_radius = contact::infinity;
  flat.undeformed_distance.quadratic = {{0.5 / 405.0, 0.5 / 500.0}};
  flat.rolling.creepages = {{1e-3, 0.0, 0.0}};
  const PointResult blocks = finite_elements(flat).points.front();
  const PointResult plane = half_space(flat).points.front();
  EXPECT_NEAR(blocks.max_pressure / plane.max_pressure, 1.0, 0.01);
  EXPECT_NEAR(blocks.longitudinal_force, plane.longitudinal_force, 0.03 * sliding(flat, plane));
}

TEST(FemProblems, ExtraSlipIsThatOfTheSurfaceUnlessTheCaseSaysOtherwise) {
  Case input = case_b();
  input.rail.transverse_radius = 50.0;
  input.wheel.transverse_radius = -51.282;
  const auto coefficient = [&](contact::ExtraSlip slip) {
    input.rolling.extra_slip = slip;
    return finite_elements(input).points.front().traction_coefficient;
  };
  // At no creepage the wheel drives beside its middle, as on the curved half-space.
  Case curved = input;
  curved.surface = contact::SurfaceForm::curved;
  EXPECT_NEAR(coefficient(contact::ExtraSlip::automatic),
              half_space(curved).points.front().traction_coefficient, 0.015);
  EXPECT_NEAR(coefficient(contact::ExtraSlip::none), 0.005, 0.006);
}

}  // namespace

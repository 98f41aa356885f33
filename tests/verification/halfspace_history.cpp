// SPDX-License-Identifier: LGPL-2.1-or-later
// Shifts and transient rolling against Cattaneo and Mindlin, Spence's datum and the steady solution
// (reference/benchmarks.md, 3 and 4).
#include "contact/solve/contact_problem.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "result/patch_size.hpp"
#include "scene/geometry.hpp"

#include "support/thesis_cases.hpp"

namespace {

/// Benchmark 3: two bodies of G = 200 with A = B = 0.01, a = 1, mu = 0.4.
Case cattaneo(double poisson_ratio, int across) {
  Case input;
  input.file = "test.toml";
  input.wheel.rolling_radius = input.wheel.transverse_radius = 50.0;
  input.wheel.material = input.rail.material = {400.0 * (1.0 + poisson_ratio), poisson_ratio};
  const double modulus = 200.0 / (1.0 - poisson_ratio);
  input.load.normal_force = halfspace::hertz_from_approach(0.01, 0.01, modulus, 0.02).normal_force;
  input.friction_coefficient = 0.4;
  input.contact_grid.elements_across = across;
  input.rolling.problem = Problem::shift;
  return input;
}

/// F_x = -part mu F_z in every step.
ModelResult pushed(Case input, const std::vector<double>& parts) {
  for (const double part : parts)
    input.rolling.forces.push_back({-part * 0.4 * *input.load.normal_force, {}});
  input.rolling.creepages.assign(parts.size(), {});
  input.history.assign(parts.size(), {});
  return halfspace::run_halfspace(input, {});
}

/// sqrt of the adhesion area over the patch area, both found below the element size: the traction
/// falls short of its bound like a square root at the border of the adhesion area.
double stick_ratio(const ModelResult& result, const PointResult& point) {
  Field rest = Field::Zero(result.grid.size());
  for (int k = 0; k < result.grid.size(); ++k)
    if (point.fields.state[static_cast<std::size_t>(k)] == ElementState::adhesion)
      rest[k] = point.fields.traction_bound[k] -
                std::hypot(point.fields.traction.x[k], point.fields.traction.y[k]);
  return std::sqrt(contact::patch_size(result.grid, rest).area / point.contact_area);
}

TEST(Cattaneo, ShiftAndStickRadiusOfTheBenchmarkAt40Elements) {
  const Case input = cattaneo(0.42, 40);
  EXPECT_NEAR(*input.load.normal_force, 9.1954, 1e-4);
  const ModelResult result = pushed(input, {7.0 / 8.0});
  const PointResult& point = result.points[0];
  EXPECT_NEAR(point.longitudinal_shift / 0.008172, 1.0, 0.003);
  EXPECT_NEAR(stick_ratio(result, point) / 0.5, 1.0, 0.003);
  EXPECT_NEAR(point.max_pressure / 4.3905, 1.0, 0.001);
  EXPECT_NEAR(point.approach / 0.02, 1.0, 0.001);
  EXPECT_NEAR(point.longitudinal_force, -0.875 * 0.4 * 9.1954, 1e-4);
}

TEST(Cattaneo, GoesOnByAShiftWhereAForceHasLedTo) {
  Case input = cattaneo(0.0, 40);
  const double unit = 0.4 * *input.load.normal_force;
  // Mindlin (1949): a = 1, G = 200, nu = 0.
  const auto shift = [&](double part) {
    return 3.0 * unit / 800.0 * (1.0 - std::pow(1.0 - part, 2.0 / 3.0));
  };
  input.rolling.forces = {{-0.5 * unit, {}}, {}};
  input.rolling.creepages.resize(2);
  input.history.resize(2);
  input.history[1].longitudinal_shift = shift(0.8) - shift(0.5);
  const PointResult point = halfspace::run_halfspace(input, {}).points.at(1);
  EXPECT_NEAR(point.longitudinal_shift / shift(0.8), 1.0, 1e-3);
  EXPECT_NEAR(point.longitudinal_force / unit, -0.8, 1e-3);
}

/// An elastic sphere of Spence's pressed on a rigid one with the first and these further forces.
Case pressed_sphere(const std::vector<double>& forces) {
  Case input;
  input.file = "test.toml";
  input.wheel.rolling_radius = input.wheel.transverse_radius = 121.5;
  input.wheel.material = {1.0, 0.0};
  input.rail.material = {infinity, 0.0};
  input.friction_coefficient = 0.2986;
  input.rolling.problem = Problem::shift;
  for (const double force : forces) input.history.emplace_back().normal_force = force;
  input.rolling.creepages.assign(forces.size(), {});
  return input;
}

TEST(Spence, FirstStepOnFourElements) {
  // A load whose patch is four elements: friction has changed their displacement alike, and the
  // gap is closed where the approach has followed.
  Case input = pressed_sphere({0.00011, 0.4495});
  input.contact_grid.elements_across = 20;
  input.load.normal_force = 0.4495;
  const ModelResult result = halfspace::run_halfspace(input, {});
  const PointResult& first = result.points.front();
  const Field& pressure = first.fields.traction.n;
  ASSERT_EQ((pressure.array() > 0.0).count(), 4);
  const double left =
      (pressure.array() > 0.0).select(first.fields.gap.array().abs(), 0.0).maxCoeff();
  EXPECT_LT(left, 1e-6 * first.approach);
  EXPECT_TRUE(first.converged);
}

/// Case b rolled over `lengths` patch lengths from rest, in steps of `step` elements.
ModelResult transient(UpwindOrder order, double lengths, double step) {
  Case input = thesis_case('b', 24);
  input.rolling.upwind_order = order;
  roll_on(input, static_cast<std::size_t>(std::lround(24 * lengths / step)),
          step * 2.0 * halfspace::hertz_of_scene(input).semi_axis_x / 24, {0.002, 0.001, 0.0});
  return halfspace::run_halfspace(input, {});
}

/// F_x and F_y of steady rolling with the same difference everywhere, which is what equal steps of
/// one element make: without the fit to the leading edge that the model has.
Forces steady(UpwindOrder order) {
  Case input = thesis_case('b', 24);
  const contact::ContactGrid grid = halfspace::PatchSearch(input).grid();
  const halfspace::HalfspaceCompliance compliance(grid, rollfem::testing::steel());
  contact::ContactConditions scene;
  const contact::ChartedGeometry geometry(input, contact::Chart::plane);
  scene.undeformed_distance = geometry.undeformed_distance(grid);
  scene.friction = contact::coulomb(0.55);
  scene.upwind_order = order;
  scene.fit_leading_edge = false;
  contact::ContactProblem problem(compliance, compliance, scene);
  const contact::TangentialField slip = geometry.rigid_slip({0.002, 0.001, 0.0}, grid);
  return rollfem::testing::forces(grid, problem.solve({50e3, {}}, {slip}).tangential.traction);
}

TEST(TransientRolling, TendsToTheSteadySolutionOfTheSameOrder) {
  const double sliding = 0.55 * 50e3;
  for (const UpwindOrder order : {UpwindOrder::first, UpwindOrder::second}) {
    const Forces end = steady(order);
    const ModelResult result = transient(order, 6.0, 1.0);
    const auto distance = [&](const PointResult& point) {
      return std::hypot(point.longitudinal_force - end.x, point.lateral_force - end.y) / sliding;
    };
    // Steps of one element have the steady solution as their limit, element by element.
    EXPECT_LT(distance(result.points.back()), 5e-5);
    EXPECT_GT(distance(result.points[23]), 0.02);
    EXPECT_NEAR(result.points.back().distance, 6.0 * result.points[23].distance, 1e-9);
    double before = 0.0;
    for (int k = 0; k < 60; ++k) {
      const double now = -result.points[static_cast<std::size_t>(k)].longitudinal_force;
      EXPECT_GE(now, before - 1e-4 * sliding) << k;
      before = now;
    }
  }
}

TEST(TransientRolling, OtherStepsEndWithinTheDiscretisationError) {
  const Forces end = steady(UpwindOrder::second);
  for (const double step : {0.5, 1.7}) {
    const PointResult last = transient(UpwindOrder::second, 5.0, step).points.back();
    EXPECT_NEAR(last.longitudinal_force, end.x, 0.008 * 27500.0) << step;
    EXPECT_NEAR(last.lateral_force, end.y, 0.008 * 27500.0) << step;
  }
}

TEST(TransientRolling, NoTractionIsBeyondItsBoundAtAnyStep) {
  // cases/cattaneo_to_carter.toml, where 1.1e-6 of the largest bound was left once.
  Case input = thesis_case('b', 24);
  roll_on(input, 24, 1.2, {0.001, 0.0, 0.0});
  for (const PointResult& point : halfspace::run_halfspace(input, {}).points) {
    const contact::SurfaceField& traction = point.fields.traction;
    double beyond = 0.0;
    for (Eigen::Index k = 0; k < traction.n.size(); ++k)
      beyond = std::max(beyond, std::hypot(traction.x[k], traction.y[k]) -
                                    input.friction_coefficient * traction.n[k]);
    EXPECT_LT(beyond, 1e-12 * input.friction_coefficient * point.max_pressure);
  }
}

TEST(TransientRolling, FromCattaneoToCarterAtConstantForce) {
  // A prescribed force: the first step is nearly a shift, the creepage then falls to the steady
  // one.
  Case input = thesis_case('b', 20);
  const double force = -0.5 * 27500.0;
  Case rolling = input;
  rolling.rolling.forces = {{force, {}}};
  const double steady_creepage =
      halfspace::run_halfspace(rolling, {}).points[0].creepage.longitudinal;
  roll_on(input, 100, 2.0 * halfspace::hertz_of_scene(input).semi_axis_x / 20);
  input.rolling.forces.assign(100, {force, {}});
  const ModelResult result = halfspace::run_halfspace(input, {});
  for (const PointResult& point : result.points)
    EXPECT_NEAR(point.longitudinal_force, force, 1e-4 * 27500.0);
  EXPECT_GT(result.points[0].creepage.longitudinal, 3.0 * steady_creepage);
  // Then it rises until the first adhering particles leave. At a quarter of element and step the
  // second is 1.05e-3 in either order; a second-order difference across the jump of the first step
  // gave -12.6e-3.
  EXPECT_NEAR(result.points[1].creepage.longitudinal, 1.05e-3, 0.06 * 1.05e-3);
  for (std::size_t k = 2; k < 14; ++k)
    EXPECT_GT(result.points[k].creepage.longitudinal, result.points[k - 1].creepage.longitudinal)
        << k;
  // The steady model is fitted to the leading edge, the steps are not: the discretisation's error.
  EXPECT_NEAR(result.points.back().creepage.longitudinal / steady_creepage, 1.0, 0.02);
  EXPECT_NEAR(result.points.back().creepage.longitudinal / result.points[80].creepage.longitudinal,
              1.0, 1e-3);
}

/// Case b rolled on from steady rolling in steps of an element, with the same difference
/// everywhere; the longitudinal creepage of the last `changed` steps is half as large.
Case rolled_on(UpwindOrder order, std::size_t steps, std::size_t changed) {
  Case input = thesis_case('b', 12);
  input.rolling.upwind_order = order;
  input.rolling.leading_edge = contact::LeadingEdge::plain;
  roll_on(input, steps, 2.0 * halfspace::hertz_of_scene(input).semi_axis_x / 12,
          {0.002, 0.001, 0.0});
  input.starts_steady = true;
  for (std::size_t k = steps - changed; k < steps; ++k)
    input.rolling.creepages[k].longitudinal = 0.001;
  return input;
}

double apart(const PointResult& a, const PointResult& b) {
  return std::hypot(a.longitudinal_force - b.longitudinal_force, a.lateral_force - b.lateral_force);
}

TEST(SteadyStart, StaysSteadyWhereNothingChanges) {
  const double sliding = 0.55 * 50e3;
  for (const UpwindOrder order : {UpwindOrder::first, UpwindOrder::second}) {
    Case input = rolled_on(order, 8, 0);
    const ModelResult result = halfspace::run_halfspace(input, {});
    for (const PointResult& point : result.points)
      EXPECT_LT(apart(point, result.points[0]), 5e-5 * sliding) << point.step;
    EXPECT_EQ(result.points[0].distance, 0.0);
    EXPECT_NEAR(result.points[7].distance, 7.0 * input.history[0].step_length, 1e-9);
    input.rolling.problem = Problem::steady;
    input.starts_steady = false;
    input.history.clear();
    input.rolling.creepages.resize(1);
    EXPECT_LT(apart(halfspace::run_halfspace(input, {}).points[0], result.points[0]),
              5e-5 * sliding);
  }
}

TEST(SteadyStart, IsWhereALongWayFromRestEnds) {
  constexpr std::size_t changed = 8, way = 6 * 12;  // patch lengths
  const ModelResult steady =
      halfspace::run_halfspace(rolled_on(UpwindOrder::first, 1 + changed, changed), {});
  Case input = rolled_on(UpwindOrder::first, way + changed, changed);
  input.starts_steady = false;
  const ModelResult from_rest = halfspace::run_halfspace(input, {});
  const double fall = apart(steady.points.front(), steady.points.back());
  EXPECT_GT(fall, 0.05 * 0.55 * 50e3);
  for (std::size_t k = 1; k <= changed; ++k)
    EXPECT_LT(apart(steady.points[k], from_rest.points[way + k - 1]), 1e-3 * fall) << k;
}

TEST(SteadyStart, KeepsCreepageUnderAForceAndFrictionThatRemembers) {
  Case input = rolled_on(UpwindOrder::second, 4, 0);
  input.rolling.creepages.assign(4, {});
  input.rolling.forces.assign(4, {-12e3, {}});
  const ModelResult forced = halfspace::run_halfspace(input, {});
  for (const PointResult& point : forced.points)
    EXPECT_NEAR(point.creepage.longitudinal / forced.points[0].creepage.longitudinal, 1.0, 1e-3);
  // Friction that remembers is followed with second order along the row, over a step with first.
  input = rolled_on(UpwindOrder::first, 5, 0);
  input.rolling.speed = 20e3;
  input.friction_fall.shape = contact::FallShape::exponential;
  input.friction_fall.kinetic_coefficient = 0.25;
  input.friction_fall.half_velocity = 60.0;
  input.friction_fall.memory_distance = 1e-2;
  const ModelResult falling = halfspace::run_halfspace(input, {});
  EXPECT_LT(-falling.points[0].longitudinal_force, 0.8 * 0.55 * 50e3);
  for (const PointResult& point : falling.points)
    EXPECT_LT(apart(point, falling.points[0]), 0.01 * 0.55 * 50e3) << point.step;
}

}  // namespace

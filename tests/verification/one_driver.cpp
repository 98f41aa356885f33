// SPDX-License-Identifier: LGPL-2.1-or-later
// One driver for every elasticity: with the half-space's compliance in the iteration used by finite
// elements, every problem gives the half-space's numbers, so that differences between two models
// come from elasticity only.
#include "contact/solve/contact_run.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/patch_search.hpp"

#include "support/test.hpp"
#include "support/thesis_cases.hpp"

namespace {

/// The half-space as if it could not be solved with: an unknown compliance, preconditioned by the
/// half-space of other constants, as finite elements are.
class Disguised : public contact::Elasticity {
 public:
  Disguised(const Scene& scene, const contact::ContactGrid& grid, double scale)
      : whole_(grid, scene.material), halfspace_(grid, scaled(scene.material, scale)) {}
  const contact::Compliance& compliance() const override { return whole_; }
  const contact::SolvableCompliance& halfspace() const override { return halfspace_; }
  Eigen::Vector2d rolling_stiffness(const contact::PatchSize&) const override {
    return Eigen::Vector2d::Constant(2e8);
  }
  Eigen::Vector2d shift_stiffness(const contact::PatchSize&) const override {
    return Eigen::Vector2d::Constant(1e7);
  }

 private:
  static contact::CombinedMaterial scaled(contact::CombinedMaterial material, double factor) {
    material.shear_modulus *= factor;
    material.contact_modulus *= factor;
    return material.uncoupled();
  }

  halfspace::HalfspaceCompliance whole_;
  halfspace::HalfspaceCompliance halfspace_;
};

/// `scale`: constants of the half-space that preconditions over the true ones; 0: the half-space
/// is solved with directly.
contact::LevelResult run(const Scene& scene, const contact::ContactGrid& grid, double scale) {
  const contact::ChartedGeometry geometry = halfspace::halfspace_geometry(scene);
  contact::RunOptions options;
  options.accuracy = {1e-9, 1e-8, 100, 5};
  options.force_accuracy = options.accuracy;
  options.force_tolerance = 1e-9;
  const contact::Progress silent;
  contact::ContactRun run(scene, geometry, options, silent, nullptr);
  const bool inside = run.solve(grid, [&]() -> std::unique_ptr<contact::Elasticity> {
    if (scale > 0.0) return std::make_unique<Disguised>(scene, grid, scale);
    return halfspace::halfspace_elasticity(scene, geometry, grid);
  });
  EXPECT_TRUE(inside);
  return run.take_result();
}

/// With the half-space itself as its preconditioner to rounding; with another one to the tolerance
/// of the outer iteration: the fit to the leading edge is that of the whole displacement.
void expect_alike(const Case& input) {
  const Scene scene(input);
  for (const auto& [scale, tolerance] : {std::pair{1.0, 1e-7}, {1.1, 1e-6}}) {
    SCOPED_TRACE(scale);
    const contact::ContactGrid grid = halfspace::PatchSearch(scene).grid();
    const auto plain = run(scene, grid, 0.0).points;
    const auto other = run(scene, grid, scale).points;
    ASSERT_EQ(plain.size(), other.size());
    for (std::size_t k = 0; k < plain.size(); ++k) {
      SCOPED_TRACE(k);
      const double sliding = scene.friction_coefficient() * plain[k].normal_force;
      EXPECT_NEAR(other[k].normal_force / plain[k].normal_force, 1.0, tolerance);
      EXPECT_NEAR(other[k].max_pressure / plain[k].max_pressure, 1.0, tolerance);
      EXPECT_NEAR(other[k].longitudinal_force, plain[k].longitudinal_force, tolerance * sliding);
      EXPECT_NEAR(other[k].lateral_force, plain[k].lateral_force, tolerance * sliding);
      EXPECT_NEAR(other[k].creepage.longitudinal, plain[k].creepage.longitudinal, 1e-2 * tolerance);
    }
  }
}

Case small_case() {
  Case input = thesis_case('b', 16);
  return input;
}

TEST(OneDriver, SteadyRolling) {
  Case input = small_case();
  input.rolling.creepages = {{1e-3, 0.0, 0.0}, {1e-3, 5e-4, 1e-4}};
  expect_alike(input);
}

TEST(OneDriver, PrescribedForces) {
  Case input = small_case();
  input.rolling.creepages = {{}, {0.0, 0.0, 1e-4}};
  input.rolling.forces = {{-12e3, {}}, {-9e3, 6e3}};
  expect_alike(input);
}

TEST(OneDriver, APrescribedForceCostsAsManyAppliesAsItsCreepage) {
  Case input = small_case();
  input.rolling.creepages = {{}, {0.0, 0.0, 1e-4}, {}};
  input.rolling.forces = {{-12e3, {}}, {-9e3, 6e3}, {-26e3, {}}};
  const contact::ContactGrid grid = halfspace::PatchSearch(input).grid();
  const auto forced = run(input, grid, 1.1).points;
  Case again = input;
  again.rolling.forces.assign(3, {});
  for (std::size_t k = 0; k < 3; ++k) again.rolling.creepages[k] = forced[k].creepage;
  const auto given = run(again, grid, 1.1).points;
  for (std::size_t k = 0; k < 3; ++k) {
    SCOPED_TRACE(k);
    EXPECT_NEAR(given[k].longitudinal_force, forced[k].longitudinal_force, 1e-6 * 27.5e3);
    EXPECT_NEAR(given[k].lateral_force, forced[k].lateral_force, 1e-6 * 27.5e3);
    EXPECT_LE(forced[k].iterations, given[k].iterations + 2);
  }
}

TEST(OneDriver, ApproachInPlaceOfTheForce) {
  Case input = small_case();
  input.load.normal_force.reset();
  input.load.approach = 0.04;
  input.rolling.creepages = {{2e-3, 0.0, 0.0}};
  expect_alike(input);
}

TEST(OneDriver, ShiftAndTransientSteps) {
  Case input = small_case();
  input.rolling.problem = Problem::shift;
  input.rolling.creepages.assign(2, {});
  input.history.assign(2, {});
  input.history[0].longitudinal_shift = 2e-3;
  input.history[1].longitudinal_shift = -1e-3;
  expect_alike(input);
  roll_on(input, 3, 1.0, {1e-3, 5e-4, 0.0});
  expect_alike(input);
  input.starts_steady = true;
  input.rolling.creepages[2].longitudinal = 0.0;
  expect_alike(input);
}

TEST(OneDriver, AGivenPressure) {
  Case input = small_case();
  input.given_pressure = contact::GivenPressure{5.0, 4.0, 800.0};
  input.rolling.creepages = {{1e-3, 0.0, 1e-4}};
  expect_alike(input);
}

TEST(OneDriver, CurvedSurfaceCarriesTheLoadWithFriction) {
  Case input = thesis_case('b', 16);
  input.rail.transverse_radius = 50.0;
  input.wheel.transverse_radius = -51.282;
  input.halfspace.surface = contact::SurfaceForm::curved;
  input.rolling.creepages = {{1e-3, 2e-3, 0.0}, {}};
  input.rolling.forces = {{}, {-8e3, -8e3}};
  expect_alike(input);
  for (const PointResult& point : halfspace::run_halfspace(input, {}).points)
    EXPECT_NEAR(point.normal_force, 50e3, 1e-6 * 50e3);
}

}  // namespace

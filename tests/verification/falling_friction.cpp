// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction that falls with the slip velocity where the elasticity is not that of a half-space, and
// theories that cannot take it (traction curves, layers, memory: the book).
#include "base/errors.hpp"
#include "halfspace/curvature/curved_compliance.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "scene/scene.hpp"

#include "support/half_space_models.hpp"
#include "support/thesis_cases.hpp"

namespace {

/// 106.7 kN at 10 m/s.
Case locomotive(const std::vector<double>& creepages) {
  Case input;
  input.file = "test.toml";
  input.load.normal_force = 106.7e3;
  input.wheel.material = input.rail.material = {209920.0, 0.28};
  input.wheel.rolling_radius = 625.0;
  input.rail.transverse_radius = 1776.8;
  input.contact_grid.elements_across = 20;
  input.friction_coefficient = 0.33;
  input.rolling.speed = 10e3;
  input.rolling.creepages = along(creepages);
  return input;
}

void add_falling_friction(Case& input) {
  input.friction_fall.shape = contact::FallShape::exponential;
  input.friction_fall.kinetic_coefficient = 0.14;
  input.friction_fall.half_velocity = 1250.0;
  input.friction_fall.memory_distance = 3e-3;
  input.friction_fall.memory_velocity = 1.0;
}

void add_layer(Case& input) {
  input.layer = contact::Layer{1.25, 8200.0};
}

TEST(FallingFriction, OfCurvedBodiesHoldsTheLawAtEveryElement) {
  // Any elasticity beyond the half-space goes through the correction of its defect.
  Case input = locomotive({0.004, 0.03});
  add_falling_friction(input);
  input.friction_fall.memory_distance = 0.0;
  add_layer(input);
  const ModelResult half = halfspace::run_halfspace(input, {});
  halfspace::GridElasticity curved;
  curved.model = "curved";
  curved.make = [](const contact::Scene& scene, const contact::ChartedGeometry&,
                   const contact::ContactGrid& grid) -> std::unique_ptr<contact::Elasticity> {
    return std::make_unique<halfspace::PreconditionedElasticity>(
        scene, grid, std::make_unique<halfspace::CurvedCompliance>(scene, grid));
  };
  const ModelResult result = halfspace::run_halfspace(input, {}, nullptr, curved);
  for (std::size_t k = 0; k < 2; ++k) {
    const PointResult& point = result.points[k];
    // A shortened wheel shifts the creep curve by some 1e-5 of creepage.
    EXPECT_NEAR(point.longitudinal_force / half.points[k].longitudinal_force, 1.0, 0.01);
    int slipping = 0;
    for (int e = 0; e < result.grid.size(); ++e) {
      const contact::ContactFields& f = point.fields;
      if (f.state[static_cast<std::size_t>(e)] != contact::ElementState::slip) continue;
      ++slipping;
      const double s = 10e3 * std::hypot(f.slip.x[e], f.slip.y[e]);
      const double bound = (0.14 + 0.19 * std::exp2(-s / 1250.0)) * f.traction.n[e];
      EXPECT_NEAR(std::hypot(f.traction.x[e], f.traction.y[e]), bound, 1e-3 * bound);
    }
    EXPECT_GT(slipping, 20);
  }
}

TEST(FallingFriction, AndLayersAreRefusedByTheoriesWithoutThem) {
  Case falling = locomotive({0.002}), layered = falling;
  add_falling_friction(falling);
  add_layer(layered);
  for (const char* name : {"linear", "vermeulen-johnson", "carter", "fastrip", "strip"})
    for (const Case& input : {falling, layered})
      EXPECT_THROW(rollfem::testing::half_space_models().check(contact::Scene(input), name),
                   contact::InputError)
          << name;
}

}  // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// All abilities of the driver hold for the hybrid: without a correction it equals the curved
// half-space in every kind of problem, and corrections with a closed form are reproduced.
#include "halfspace/model/halfspace_model.hpp"
#include "hybrid/hybrid_model.hpp"
#include "result/quantities.hpp"
#include "track/motion/placed_scenes.hpp"

#include "support/committed_cases.hpp"

namespace {

contact::Case on_16_across(const std::string& name) {
  contact::Case input = committed_case(name);
  input.contact_grid.cell_size.reset();
  input.contact_grid.extent.reset();
  input.contact_grid.elements_across = 16;
  return input;
}

contact::ModelResult hybrid_of(const contact::Scene& scene, const hybrid::SmoothParts& parts) {
  return hybrid::run_hybrid(scene, {}, nullptr,
                            [&](const contact::Scene&, const contact::Progress&) { return parts; });
}

/// Without a correction, forces and pressures equal those of the half-space on the curved surface.
void expect_half_space(contact::Scene scene) {
  const auto hybrid = hybrid_of(scene, {});
  scene.follows_surface = 1.0;
  const auto half = halfspace::run_halfspace(scene, {});
  ASSERT_EQ(hybrid.points.size(), half.points.size());
  for (std::size_t k = 0; k < half.points.size(); ++k) {
    const auto& one = hybrid.points[k];
    const auto& other = half.points[k];
    const double force = other.normal_force;
    EXPECT_NEAR(one.max_pressure, other.max_pressure, 1e-5 * other.max_pressure) << k;
    EXPECT_NEAR(one.normal_force, force, 1e-5 * force) << k;
    EXPECT_NEAR(one.longitudinal_force, other.longitudinal_force, 1e-5 * force) << k;
    EXPECT_NEAR(one.lateral_force, other.lateral_force, 1e-5 * force) << k;
    EXPECT_NEAR(one.creepage.longitudinal, other.creepage.longitudinal, 1e-8) << k;
    // Values that are exact or given in one model are so in the other.
    EXPECT_EQ(one.error_estimate.size(), other.error_estimate.size()) << k;
  }
}

/// Case e pushed back and forth without rolling.
contact::Case shifted() {
  contact::Case input = on_16_across("thesis_e");
  input.rolling.problem = contact::Problem::shift;
  input.rolling.creepages.assign(3, {});
  for (const double way : {0.006, 0.004, -0.008}) {
    contact::HistoryStep step;
    step.longitudinal_shift = way;
    step.lateral_shift = 0.3 * way;
    input.history.push_back(step);
  }
  return input;
}

/// Constant displacement along the normal of `softness` mm per N of the normal force.
hybrid::SmoothParts springs(double softness) {
  hybrid::SmoothParts parts;
  hybrid::SmoothMap& map = parts.rail;
  map.fields = {50.0, 50.0, 0.0};
  map.coefficients = Eigen::MatrixXd::Zero(3, 3);
  map.coefficients(2, 2) = softness;
  return parts;
}

}  // namespace

TEST(HybridDriver, PrescribedForces) {
  contact::Case input = on_16_across("thesis_e");
  input.rolling.creepages = {{0.0, 0.0, 0.0}, {0.0, 0.0, 1e-4}};
  input.rolling.forces = {{-10e3, std::nullopt}, {-5e3, 2e3}};
  const auto result = hybrid_of(input, {});
  EXPECT_NEAR(result.points[0].longitudinal_force, -10e3, 1e-6 * 0.55 * 50e3);
  EXPECT_NEAR(result.points[1].lateral_force, 2e3, 1e-6 * 0.55 * 50e3);
  expect_half_space(input);
}

TEST(HybridDriver, Shift) {
  expect_half_space(shifted());
}

TEST(HybridDriver, LoadHistory) {
  contact::Case input = shifted();
  for (std::size_t k = 0; k < input.history.size(); ++k)
    input.history[k].normal_force = 20e3 + 10e3 * static_cast<double>(k);
  expect_half_space(input);
}

TEST(HybridDriver, TransientRolling) {
  contact::Case input = on_16_across("cattaneo_to_carter");
  input.rolling.creepages.resize(4);
  input.history.resize(4);
  expect_half_space(input);
}

TEST(HybridDriver, ALayerThatYields) {
  contact::Case input = on_16_across("thesis_e");
  input.rolling.creepages = {{0.002, 0.0, 0.0}, {0.004, 0.002, 1e-4}};
  input.layer = contact::Layer{0.02, 800.0, 100.0, 500.0};
  expect_half_space(input);
}

TEST(HybridDriver, PatchesOfProfilesInBalance) {
  for (const char* name : {"s1002_uic60_left", "s1002_uic60_right"}) {
    contact::Case input = on_16_across(name);
    input.rolling.creepages.resize(1);
    for (const track::PlacedScene& placed : track::make_scenes(input))
      expect_half_space(placed.scene);
  }
}

TEST(HybridDriver, AccuracyIsReached) {
  contact::Case input = on_16_across("thesis_f");
  input.rolling.creepages.resize(1);
  input.accuracy = 0.002;
  input.accuracy_of = {"max_pressure"};
  const auto point = hybrid_of(input, {}).points.front();
  EXPECT_LE(point.error_estimate.at("max_pressure"), 0.002 * point.max_pressure);
}

TEST(HybridDriver, ASpringBelowTheRailSinks) {
  contact::Case input = on_16_across("thesis_a");
  input.rolling.creepages.resize(1);
  const double softness = 1e-6;
  const auto with = hybrid_of(input, springs(softness)).points.front();
  const auto without = hybrid_of(input, {}).points.front();
  EXPECT_NEAR(with.approach - without.approach, softness * 50e3, 1e-4 * without.approach);
  EXPECT_NEAR(with.max_pressure, without.max_pressure, 1e-5 * without.max_pressure);
}

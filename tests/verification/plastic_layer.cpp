// SPDX-License-Identifier: LGPL-2.1-or-later
// Layers between wheel and rail that yield, and friction that falls with the slip velocity:
// CONTACT's example plastic_3bl (E. A. H. Vollebregt, user guide, section 5.12; open version
// r2707), elasticities that are not a half-space's, checkpoints and refusals (closed forms,
// traction curves, memory, limits and order: the book).
#include "base/errors.hpp"
#include "contact/iteration/tangential.hpp"
#include "contact/solve/point_motion.hpp"
#include "contact/solve/state_record.hpp"
#include "halfspace/curvature/curved_compliance.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "scene/scene.hpp"

#include "support/half_space_models.hpp"
#include "support/temporary_folder.hpp"
#include "support/thesis_cases.hpp"

namespace {

/// Steps of a shift of one element of 1 mm^2 under 900 N, and F_x after each as CONTACT prints it.
struct ShiftSeries {
  double shear_modulus, thickness;
  contact::Plasticity plasticity;
  std::vector<double> shifts, printed;
};

std::vector<double> with_steps(std::vector<double> first, std::size_t count, double step) {
  first.resize(count, step);
  return first;
}

const std::vector<ShiftSeries>& plastic_3bl() {
  static const std::vector<ShiftSeries> all{
      {176.63,
       0.02,
       {560.0, 0.0},
       with_steps({0.035, 0.035, 0.03}, 13, 0.05),
       with_steps({280.0}, 13, 560.0)},
      {106.25,
       0.02,
       {200.0, 435.0},
       with_steps({0.04, 0.04, 0.04, 0.04, 0.036, 0.0, -0.036, 0.0, 0.046, 0.044}, 17, 0.05),
       {200.0, 216.0, 232.0, 248.0, 262.4, 262.4, 82.43, 82.43, 266.4, 284.0, 304.0, 324.1, 344.1,
        364.1, 384.1, 404.1, 424.1}},
      {176.63,
       0.02,
       {400.0, -195.0},
       with_steps({0.025, 0.025}, 13, 0.05),
       {200.0, 400.0, 390.0, 380.0, 370.0, 360.0, 350.0, 340.0, 330.0, 320.1, 310.1, 300.1, 290.1}},
      {20.24,
       0.02,
       {20.0, 20.4},
       with_steps({0.02, 0.04, 0.04}, 13, 0.05),
       {20.0, 20.8, 21.6, 22.6, 23.6, 24.6, 25.6, 26.6, 27.6, 28.6, 29.6, 30.6, 31.6}}};
  return all;
}

TEST(PlasticLayer, SeriesOfContactOnOneElement) {
  const contact::Material steel{2.0 * 82000.0 * 1.28, 0.28};
  contact::ContactGrid grid;
  grid.nx = grid.ny = 3;  // the element and a border
  grid.dx = grid.dy = 1.0;
  grid.x_first = grid.y_first = -1.0;
  const Eigen::Index middle = 4;
  Field pressure = Field::Zero(9);
  pressure[middle] = 900.0;
  for (const ShiftSeries& series : plastic_3bl()) {
    contact::CombinedMaterial material = contact::combine(steel, steel);
    material.layer = series.thickness / series.shear_modulus;
    const halfspace::HalfspaceCompliance bodies(grid, material);
    auto law = std::make_shared<contact::CoulombFriction>(0.7);
    law->plasticity = series.plasticity;
    contact::History history(grid, contact::UpwindOrder::first);
    contact::FrictionPast past{Field::Constant(9, 0.7), 1.0, Field::Zero(9)};
    for (std::size_t k = 0; k < series.shifts.size(); ++k) {
      contact::TangentialMotion step =
          history.shift_step({Field::Constant(9, -series.shifts[k]), Field::Zero(9)});
      step.past = past;
      const contact::TangentialSolution s = solve_tangential(bodies.shift(), {pressure, step, law});
      EXPECT_NEAR(s.traction.x[middle], series.printed[k], 2.5e-4 * series.printed[k]) << k;
      if (s.plastic.size() != 0) past.plastic = s.plastic;
      history.advance(bodies.shift().apply(s.traction), 0.0);
    }
  }
}

/// 100 kN on a wheel of 460 mm on a flat rail head of 300 mm.
Case wheel_on_rail(const std::vector<double>& creepages, int across) {
  Case input;
  input.file = "test.toml";
  input.load.normal_force = 100e3;
  input.wheel.rolling_radius = 460.0;
  input.rail.transverse_radius = 300.0;
  input.friction_coefficient = 0.4;
  input.contact_grid.elements_across = across;
  input.rolling.creepages = along(creepages);
  return input;
}

/// Any elasticity beyond the half-space goes through the correction of its defect: curved bodies,
/// whose forces are the half-space's `within` this part.
ModelResult by_curved_bodies(const Case& input, double within) {
  halfspace::GridElasticity curved;
  curved.model = "curved";
  curved.make = [](const contact::Scene& scene, const contact::ChartedGeometry&,
                   const contact::ContactGrid& grid) -> std::unique_ptr<contact::Elasticity> {
    return std::make_unique<halfspace::PreconditionedElasticity>(
        scene, grid, std::make_unique<halfspace::CurvedCompliance>(scene, grid));
  };
  const ModelResult half = halfspace::run_halfspace(input, {});
  const ModelResult result = halfspace::run_halfspace(input, {}, nullptr, curved);
  for (std::size_t k = 0; k < half.points.size(); ++k)
    EXPECT_NEAR(result.points[k].longitudinal_force / half.points[k].longitudinal_force, 1.0,
                within);
  return result;
}

/// Calls check(element, size of the traction) for the elements in a state.
template <class Check>
void expect_of_state(const ModelResult& result, ElementState state, const Check& check) {
  for (const PointResult& point : result.points) {
    const contact::ContactFields& f = point.fields;
    int count = 0;
    for (int e = 0; e < result.grid.size(); ++e) {
      if (f.state[static_cast<std::size_t>(e)] != state) continue;
      ++count;
      check(f, e, std::hypot(f.traction.x[e], f.traction.y[e]));
    }
    EXPECT_GT(count, 20);
  }
}

TEST(PlasticLayer, OfCurvedBodiesHoldsTheYieldStressAtEveryElement) {
  Case input = wheel_on_rail({0.002, 0.01}, 20);
  input.layer = contact::Layer{0.02, 800.0, 200.0, 0.0};
  const ModelResult result = by_curved_bodies(input, 0.02);
  expect_of_state(result, ElementState::plastic,
                  [](const auto&, int, double size) { EXPECT_NEAR(size, 200.0, 1e-4); });
  for (const PointResult& point : result.points)
    for (int e = 0; e < result.grid.size(); ++e)
      EXPECT_LE(std::hypot(point.fields.traction.x[e], point.fields.traction.y[e]),
                std::min(200.0, 0.4 * point.fields.traction.n[e]) * (1.0 + 1e-6));
}

/// 106.7 kN at 10 m/s on friction that falls.
Case locomotive(const std::vector<double>& creepages) {
  Case input = wheel_on_rail(creepages, 20);
  input.load.normal_force = 106.7e3;
  input.wheel.material = input.rail.material = {209920.0, 0.28};
  input.wheel.rolling_radius = 625.0;
  input.rail.transverse_radius = 1776.8;
  input.friction_coefficient = 0.33;
  input.rolling.speed = 10e3;
  input.friction_fall.shape = contact::FallShape::exponential;
  input.friction_fall.kinetic_coefficient = 0.14;
  input.friction_fall.half_velocity = 1250.0;
  return input;
}

TEST(FallingFriction, OfCurvedBodiesHoldsTheLawAtEveryElement) {
  Case input = locomotive({0.004, 0.03});
  input.layer = contact::Layer{1.25, 8200.0};
  // A shortened wheel shifts the creep curve by some 1e-5 of creepage.
  expect_of_state(by_curved_bodies(input, 0.01), ElementState::slip,
                  [](const contact::ContactFields& f, int e, double size) {
                    const double s = 10e3 * std::hypot(f.slip.x[e], f.slip.y[e]);
                    const double bound = (0.14 + 0.19 * std::exp2(-s / 1250.0)) * f.traction.n[e];
                    EXPECT_NEAR(size, bound, 1e-3 * bound);
                  });
}

TEST(PlasticLayer, IsKeptInCheckpoints) {
  contact::ContactState state, read;
  state.tangential.coefficient = Field::LinSpaced(4, 0.1, 0.4);
  state.tangential.plastic = Field::LinSpaced(4, 1.0, 2.0);
  PointResult point;
  contact::Record(contact::record_of(point, state)).values(point, read);
  EXPECT_EQ(read.tangential.coefficient, state.tangential.coefficient);
  EXPECT_EQ(read.tangential.plastic, state.tangential.plastic);
}

TEST(PlasticLayer, TransmitsNoMoreThanItsYieldStress) {
  // 60 MPa on the ellipse, less where friction is lower, carry some 7 kN of the 40 kN of friction.
  Case input = wheel_on_rail({0.0}, 20);
  input.layer = contact::Layer{};
  input.layer->yield_stress = 60.0;
  input.rolling.forces = {{-5e3, {}}};
  const PointResult point = halfspace::run_halfspace(input, {}).points[0];
  EXPECT_NEAR(point.longitudinal_force, -5e3, 5.0);
  input.rolling.forces = {{-1.05 * 60.0 * point.contact_area, {}}};
  const std::string message =
      refusal<contact::SolveError>([&] { halfspace::run_halfspace(input, {}); });
  EXPECT_TRUE(says(message, "the most that a layer with a yield stress of 60 MPa"));
}

TEST(PlasticLayer, AndFallingFrictionAreRefusedByTheoriesWithoutThem) {
  const auto& models = rollfem::testing::half_space_models();
  Case yielding = wheel_on_rail({0.001}, 20), falling = locomotive({0.002}), layered = yielding;
  yielding.layer = contact::Layer{};
  yielding.layer->yield_stress = 200.0;
  falling.friction_fall.memory_distance = 3e-3;
  layered.layer = contact::Layer{1.25, 8200.0};
  for (const char* name : {"linear", "vermeulen-johnson", "carter", "strip", "fastrip"})
    for (const Case& input : {yielding, falling, layered})
      EXPECT_THROW(models.check(contact::Scene(input), name), contact::InputError) << name;
  EXPECT_THROW(models.check(contact::Scene(yielding), "fastsim"), contact::InputError);
  models.check(contact::Scene(yielding), "halfspace");
}

}  // namespace

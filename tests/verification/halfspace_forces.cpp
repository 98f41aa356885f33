// SPDX-License-Identifier: LGPL-2.1-or-later
// Steady rolling in three dimensions: prescribed forces against creep curves, given pressure, work.
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "result/bars.hpp"
#include "result/derived.hpp"

#include "support/half_space_models.hpp"
#include "support/thesis_cases.hpp"

namespace {

TEST(PrescribedForces, GiveBackTheCreepagesOfTheirForces) {
  Case input = thesis_case('b', 20, {{1e-3, 0.0, 0.0}, {2e-3, 1e-3, 2e-4}, {-1e-3, 4e-3, 0.0}});
  const ModelResult forward = halfspace::run_halfspace(input, {});
  Case backward = input;
  for (std::size_t k = 0; k < 3; ++k) {
    const PointResult& point = forward.points[k];
    backward.rolling.forces.push_back({point.longitudinal_force, point.lateral_force});
    backward.rolling.creepages[k] = {0.0, 0.0, input.rolling.creepages[k].spin};
  }
  backward.rolling.forces[0].lateral.reset();
  const ModelResult found = halfspace::run_halfspace(backward, {});
  for (std::size_t k = 0; k < 3; ++k) {
    const Creepage& wanted = input.rolling.creepages[k];
    const double size = std::hypot(wanted.longitudinal, wanted.lateral);
    EXPECT_NEAR(found.points[k].creepage.longitudinal, wanted.longitudinal, 2e-5 * size) << k;
    EXPECT_NEAR(found.points[k].creepage.lateral, wanted.lateral, 2e-5 * size) << k;
    EXPECT_GT(found.points[k].error_estimate.at("longitudinal_creepage"), 0.0);
  }
}

TEST(PrescribedForces, WithAnApproachInsteadOfANormalForce) {
  Case input = thesis_case('a', 20);
  input.load.normal_force.reset();
  input.load.approach = 0.04731083;
  input.rolling.creepages = {{0.0, 0.0, 0.0}};
  input.rolling.forces = {{-0.37221 * 50e3, {}}};
  const PointResult point = halfspace::run_halfspace(input, {}).points[0];
  EXPECT_NEAR(point.normal_force / 50e3, 1.0, 0.003);
  EXPECT_NEAR(point.creepage.longitudinal / 0.002, 1.0,
              0.02);  // contact_tangential.csv, Richardson
}

TEST(GivenPressure, CarriesTheForceOnAnyGrid) {
  constexpr double force = 82000.0, friction = 0.3, largest = 1.5 * force / (M_PI * 24.0);
  Case input;
  input.file = "test.toml";
  input.wheel.rolling_radius = 500.0;
  input.wheel.material = input.rail.material = {2.0 * 82000.0 * 1.28, 0.28};
  input.friction_coefficient = friction;
  input.given_pressure = contact::GivenPressure{6.0, 4.0, largest};
  input.load.normal_force = force;
  input.rolling.creepages = {{0.0, 0.5, 0.0}};
  for (const int across : {8, 15, 32, 63}) {
    input.contact_grid.elements_across = across;
    const PointResult point = half_space_models().run("halfspace", input, {}).points.at(0);
    EXPECT_NEAR(point.normal_force / force, 1.0, 1e-12) << across;
    // Everything slips; the elastic part of the slip turns it by less than 1e-2.
    EXPECT_NEAR(point.lateral_force / (friction * force), -1.0, 5e-5) << across;
    EXPECT_NEAR(point.max_pressure / largest, 1.0, std::pow(across, -1.5)) << across;
    const auto hertz = halfspace::hertz_of_scene(contact::Scene(input));
    EXPECT_NEAR(point.approach / hertz.approach, 1.0, 0.5 * std::pow(across, -1.5)) << across;
    EXPECT_EQ(point.no_bar.at("normal_force"), contact::NoBar::given) << across;
    if (across > 8) {
      EXPECT_NEAR(point.max_pressure, largest, point.error_estimate.at("max_pressure")) << across;
    }
  }
}

TEST(Derived, FrictionalWorkIsWhatTheCreepForcesPutIn) {
  Case input = thesis_case('b', 40, {{0.002, 0.001, 1e-4}});
  PointResult point;
  std::vector<double> difference;
  for (const int across : {20, 40}) {
    input.contact_grid.elements_across = across;
    point = halfspace::run_halfspace(input, {}).points[0];
    EXPECT_NEAR(point.frictional_work.value(), point.creepage_work.value(),
                1e-9 * point.creepage_work.value());
    // The elements by themselves lack what they do not resolve.
    const ModelResult model = half_space_models().run("halfspace", input, {});
    const double own =
        model.grid.dy *
        contact::pass_work(model.grid, point.fields.traction, point.fields.slip).sum();
    difference.push_back(std::abs(point.creepage_work.value() / own - 1.0));
  }
  EXPECT_LT(difference[1], 0.02);
  EXPECT_LT(difference[1], difference[0]);
  // Hertz's pressure alone stores 2/5 F delta, the integral of the force over the approach. What
  // tractions add is at most mu^2 of it times the ratio of the compliances, which is below 2.
  const double pressure_alone = 0.4 * point.normal_force * point.approach;
  EXPECT_GT(point.elastic_energy.value(), 0.999 * pressure_alone);
  EXPECT_LT(point.elastic_energy.value(), (1.0 + 0.55 * 0.55 * 2.0) * pressure_alone);
}

TEST(Derived, RichardsonValueIsNearerThanTheFineOne) {
  Case input = thesis_case('a', 40, {{0.0, 0.0, 0.0}});
  const PointResult point = halfspace::run_halfspace(input, {}).points[0];
  EXPECT_LT(std::abs(point.richardson.at("max_pressure") - 578.967),
            0.2 * std::abs(point.max_pressure - 578.967));
}

}  // namespace

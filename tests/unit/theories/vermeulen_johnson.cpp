// SPDX-License-Identifier: LGPL-2.1-or-later
// Vermeulen and Johnson's theory against benchmark 8 and its own tractions.
#include "base/errors.hpp"
#include "halfspace/closed_forms/kalker.hpp"
#include "theories/closed_forms.hpp"

#include "support/contact_laws.hpp"
#include "support/thesis_cases.hpp"

namespace rollfem::theories {

using namespace halfspace;
TEST(VermeulenJohnson, GivesTheBenchmark) {
  // a = b = 6, G = 82000, nu = 0.25, N = 82000, mu = 0.3: tau = 120 C11 xi by hand, C11 = 4.11282.
  const double xi[] = {1e-4, 5e-4, 1e-3, 2e-3, 3e-3};
  const double saturation[] = {0.04855, 0.22703, 0.41680, 0.69792, 0.87009};
  for (int k = 0; k < 5; ++k)
    EXPECT_NEAR(vermeulen_johnson(6, 6, 82000, 0.25, 24600, {xi[k], 0, 0}).saturation,
                saturation[k], 6e-6);
}

TEST(VermeulenJohnson, TendsToTheLinearTheoryAndToFullSlip) {
  const CreepForces linear = linear_creep_forces(6, 4, 82000, 0.3, {2e-9, -1e-9, 0});
  const VermeulenJohnson small = vermeulen_johnson(6, 4, 82000, 0.3, 24600, {2e-9, -1e-9, 0});
  EXPECT_NEAR(24600 * small.saturation * small.direction_x / linear.longitudinal, 1.0, 1e-6);
  EXPECT_NEAR(24600 * small.saturation * small.direction_y / linear.lateral, 1.0, 1e-6);
  const VermeulenJohnson large = vermeulen_johnson(6, 4, 82000, 0.3, 24600, {0.5, 0, 0});
  EXPECT_EQ(large.saturation, 1.0);
  EXPECT_EQ(large.stick_ratio, 0.0);
}

TEST(VermeulenJohnson, ModelForcesAndMomentAreThoseOfItsTractions) {
  contact::Case input =
      thesis_case('b', 120, {{0, 0, 0}, {1e-3, 5e-4, 0}, {0, -2e-3, 0}, {0.05, 0, 0}});
  const contact::ModelResult result = run_vermeulen_johnson(input, {});
  const contact::ContactGrid& grid = result.grid;
  expect_forces_of_fields(result, 2e-3 * 27500);
  for (const contact::PointResult& point : result.points) {
    const contact::SurfaceField& p = point.fields.traction;
    EXPECT_NEAR(forces(grid, {p.x, p.y}).moment, point.spin_moment,
                2e-3 * 27500 * point.semi_axis_x);
  }
  EXPECT_EQ(result.points[0].traction_coefficient, 0.0);
  EXPECT_NEAR(result.points[3].traction_coefficient, 0.55, 1e-12);
}

/// Shen, Hedrick and Elkins: the cubic of the linear force, with its part by spin.
TEST(VermeulenJohnson, SpinIsPartOfTheLinearForce) {
  for (const contact::Creepage& creepage : {contact::Creepage{1e-3, 5e-4, 1e-4}, {0, 0, 3e-4}}) {
    contact::Case input = thesis_case('b', 40, {creepage});
    const contact::PointResult point = run_vermeulen_johnson(input, {}).points[0];
    const contact::PointResult linear = run_linear(input, {}).points[0];
    const double size = std::hypot(linear.longitudinal_force, linear.lateral_force);
    const double tau = size / 27500.0;
    ASSERT_LT(tau, 3.0);
    const double force = 27500.0 * (tau - tau * tau / 3.0 + tau * tau * tau / 27.0);
    EXPECT_NEAR(point.longitudinal_force, force * linear.longitudinal_force / size, 1e-6 * force);
    EXPECT_NEAR(point.lateral_force, force * linear.lateral_force / size, 1e-6 * force);
  }
}
}  // namespace rollfem::theories

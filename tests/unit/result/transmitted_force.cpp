// SPDX-License-Identifier: LGPL-2.1-or-later
// Force of tractions on a tilted surface against vectors turned by hand.
#include "result/result.hpp"

#include "support/test.hpp"

namespace {

/// One row of elements that climbs by 0.3 along y, and one level; tractions along the tangents and
/// the normal into the wheel.
const ContactGrid grid = ContactGrid::centred(3, 2, 0.5, 0.25);
constexpr double climb_of_row[] = {0.3, 0.0};

SurfaceField tractions() {
  return {grid.sample([](double x, double y) { return 20.0 + 3.0 * x - y; }),
          grid.sample([](double x, double y) { return -35.0 + x + 2.0 * y; }),
          grid.sample([](double x, double y) { return 400.0 - 10.0 * x + 5.0 * y; })};
}

PatchShape shape() {
  PatchShape made;
  made.climb.resize(grid.size());
  for (int k = 0; k < grid.size(); ++k) made.climb[k] = climb_of_row[k / grid.nx];
  made.stretch = (1.0 + made.climb.array().square()).sqrt();
  return made;
}

TEST(TransmittedForce, OfATiltedRowIsItsTrueAreaTimesTheTurnedTraction) {
  const SurfaceField p = tractions();
  double x = 0.0, y = 0.0, z = 0.0;
  for (int k = 0; k < grid.size(); ++k) {
    const double angle = std::atan(climb_of_row[k / grid.nx]);
    const double area = grid.dx * grid.dy / std::cos(angle);
    x += area * p.x[k];
    y += area * (p.y[k] * std::cos(angle) - p.n[k] * std::sin(angle));
    z += area * (p.y[k] * std::sin(angle) + p.n[k] * std::cos(angle));
  }
  const auto force = transmitted_force(grid, p, shape());
  EXPECT_NEAR(force[0], x, 1e-10);
  EXPECT_NEAR(force[1], y, 1e-10);
  EXPECT_NEAR(force[2], z, 1e-10);
}

TEST(TransmittedForce, HasTheMomentOfItsPlacesAboutTheNormal) {
  PointResult point;
  point.fields.traction = tractions();
  point.fields.state.assign(static_cast<std::size_t>(grid.size()), ElementState::slip);
  integrate_tractions(grid, point);
  double moment = 0.0;
  for (int k = 0; k < grid.size(); ++k)
    moment += grid.dx * grid.dy *
              (grid.x(k % grid.nx) * point.fields.traction.y[k] -
               grid.y(k / grid.nx) * point.fields.traction.x[k]);
  EXPECT_NEAR(point.spin_moment, moment, 1e-10);
  EXPECT_NEAR(point.traction_coefficient, -point.longitudinal_force / point.normal_force, 1e-14);
}

}  // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// A large flat body under a small loaded rectangle is a half-space: displacement differences
// against the closed forms of Love and Cerruti behind halfspace::HalfspaceCompliance.
#include "fem/fem_options.hpp"
#include "fem/linear/factorisation.hpp"
#include "fem/trace/fem_compliance.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "scene/geometry.hpp"

#include "support/fem_test_support.hpp"

namespace {

constexpr contact::Material steel{210e3, 0.3};
constexpr contact::Material soft{70e3, 0.25};

class FlatBodies : public ::testing::Test {
 protected:
  FlatBodies() {
    halfspace =
        std::make_unique<halfspace::HalfspaceCompliance>(grid, contact::combine(steel, soft));
  }

  void make_bodies(double extent) {
    fem::BodyOptions options;
    options.cell_size = 1.0;
    options.fine_half_length = options.fine_half_width = 5.0;
    options.extent = extent;
    wheel = std::make_unique<fem::Body>(wheel_shape(contact::infinity, contact::infinity), steel,
                                        options, MPI_COMM_SELF);
    rail = std::make_unique<fem::Body>(rail_shape(contact::infinity), soft, options, MPI_COMM_SELF);
    wheel_solver = fem::make_factorisation(wheel->problem());
    rail_solver = fem::make_factorisation(rail->problem());
  }

  fem::FemCompliance compliance(fem::FarBoundary far) const {
    return {{wheel.get(), wheel_solver.get()}, {rail.get(), rail_solver.get()}, {}, grid, far};
  }

  contact::SurfaceField load_along(int axis) const {
    contact::SurfaceField load{zero(), zero(), zero()};
    (axis == 0 ? load.x : axis == 1 ? load.y : load.n) = bump();
    return load;
  }

  /// Mean displacement along the load, less that of the half-space, relative to its largest.
  double shift(const fem::FemCompliance& fe, int axis) const {
    const auto load = load_along(axis);
    const auto along = [axis](const contact::SurfaceField& u) {
      return axis == 0 ? u.x : axis == 1 ? u.y : u.n;
    };
    const contact::Field exact = along(halfspace->apply(load));
    return (along(fe.apply(load)) - exact).mean() / exact.maxCoeff();
  }

  /// A parabolic traction (1 - x^2/a^2 - y^2/b^2 where positive).
  contact::Field bump() const {
    return grid.sample(
        [](double x, double y) { return std::max(0.0, 1 - x * x / 16 - y * y / 16); });
  }
  contact::Field zero() const { return contact::Field::Zero(grid.size()); }

  contact::ContactGrid grid = contact::ContactGrid::centred(10, 10, 1.0, 1.0);
  std::unique_ptr<fem::Body> wheel, rail;
  std::unique_ptr<fem::LinearSolver> wheel_solver, rail_solver;
  std::unique_ptr<halfspace::HalfspaceCompliance> halfspace;
};

/// `fe` against `exact` for one component: relative to `scale`, a constant aside.
void expect_close(const contact::Field& fe, const contact::Field& exact, double scale,
                  double tolerance) {
  const contact::Field difference = fe - exact;
  const double spread = (difference.array() - difference.mean()).abs().maxCoeff();
  EXPECT_LT(spread, tolerance * scale);
}

/// Tractions that change from element to element: what the elements themselves cannot follow.
TEST_F(FlatBodies, TheShortestWavesAreThoseOfTheHalfSpace) {
  make_bodies(20.0);
  const auto moving = compliance(fem::FarBoundary::point_load);
  for (int k = 0; k < 3; ++k) {
    contact::SurfaceField load{zero(), zero(), zero()};
    for (int j = 2; j < 8; ++j)
      for (int i = 2; i < 8; ++i)
        (k == 0   ? load.x
         : k == 1 ? load.y
                  : load.n)[grid.index(i, j)] = (i + j) % 2 == 0 ? 1.0 : -1.0;
    const auto fe = moving.apply(load);
    const auto exact = halfspace->apply(load);
    const auto along = [k](const contact::SurfaceField& u) {
      return k == 0 ? u.x : k == 1 ? u.y : u.n;
    };
    // The elements' own means are 40 % smaller.
    expect_close(along(fe), along(exact), along(exact).cwiseAbs().maxCoeff(), 0.01);
  }
}

TEST_F(FlatBodies, DisplacementMatchesTheHalfSpaceUpToTheFarBoundary) {
  make_bodies(60.0);
  const auto clamped = compliance(fem::FarBoundary::clamped);
  const auto moving = compliance(fem::FarBoundary::point_load);
  for (int k = 0; k < 3; ++k) {
    const auto load = load_along(k);
    const auto fe = clamped.apply(load);
    const auto exact = halfspace->apply(load);
    const double scale = (k == 0 ? exact.x : k == 1 ? exact.y : exact.n).maxCoeff();
    // All nine blocks: also the coupling of x and y, and of unlike materials, with their signs.
    expect_close(fe.x, exact.x, scale, 0.002);
    expect_close(fe.y, exact.y, scale, 0.002);
    expect_close(fe.n, exact.n, scale, 0.002);
    // Clamped 60 mm away: stiffer by some a/L = 4/60, never softer.
    EXPECT_LT(shift(clamped, k), 0.0);
    EXPECT_GT(shift(clamped, k), -0.08);
    // With the point load's displacement there: within (a/L)^2/5 of that, and the elements.
    EXPECT_LT(std::abs(shift(moving, k)), 0.001);
  }
}

TEST_F(FlatBodies, PointLoadBoundaryLosesFarLessToSmallSegments) {
  constexpr double a = 4.0;  // of the bump
  double clamped_error[2][3], error[2][3];
  for (int e = 0; e < 2; ++e) {
    const double extent = e == 0 ? 10.0 : 20.0;
    make_bodies(extent);
    const auto clamped = compliance(fem::FarBoundary::clamped);
    const auto moving = compliance(fem::FarBoundary::point_load);
    for (int k = 0; k < 3; ++k) {
      clamped_error[e][k] = std::abs(shift(clamped, k));
      error[e][k] = std::abs(shift(moving, k));
      // The second moment of the load, and what the elements miss of the mean.
      EXPECT_LT(error[e][k], 0.2 * std::pow(a / extent, 2) * clamped_error[e][k] + 2e-4)
          << extent << k;
    }
  }
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(clamped_error[0][k] / clamped_error[1][k], 2.0, 0.2);  // order 1 in a/L
    EXPECT_GT(error[0][k] / error[1][k], 5.0);                         // order 3, less the elements
  }
}

}  // namespace

// Derived quantities of solved rolling contacts: frictional against creepage power, and Kalker's
// coefficients at small creepage.
#include "contact/result/derived.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/solve/tangential.hpp"
#include "halfspace/elasticity/compliance.hpp"

#include <gtest/gtest.h>

#include "support/thesis_cases.hpp"
#include <cmath>

using namespace rollfem;

namespace {

/// Benchmark 9: circular patch a = 6, N = 82000, G = 82000, nu = 0.28.
struct RollingEllipse {
  contact::ContactGrid grid;
  halfspace::HalfspaceCompliance compliance;
  contact::Field pressure;

  static contact::CombinedMaterial material(double nu) {
    const contact::Material steel{2.0 * 82000.0 * (1.0 + nu), nu};
    return contact::combine(steel, steel);
  }

  RollingEllipse(int n, double nu)
      : grid(contact::ContactGrid::centred(n + 4, n + 4, 12.0 / n, 12.0 / n)),
        compliance(grid, material(nu)),
        pressure(grid.sample([](double x, double y) {
          const double p0 = 1.5 * 82000.0 / (std::acos(-1.0) * 36.0);
          return p0 * std::sqrt(std::max(0.0, 1.0 - (x * x + y * y) / 36.0));
        })) {}

  contact::PointResult solve(const contact::Creepage& creepage, double friction,
                             contact::UpwindOrder order) const {
    contact::PointResult point;
    point.creepage = creepage;
    const contact::TangentialField slip{
        grid.sample([&](double, double y) { return creepage.longitudinal - creepage.spin * y; }),
        grid.sample([&](double x, double) { return creepage.lateral + creepage.spin * x; })};
    const contact::TangentialSolution solution = contact::solve_tangential(
        compliance.rolling(order), {pressure, slip, contact::coulomb(friction)});
    point.fields.traction = {solution.traction.x, solution.traction.y, pressure};
    point.fields.slip = solution.slip;
    return point;
  }

  rollfem::testing::Forces forces(const contact::Creepage& creepage, double friction) const {
    const contact::SurfaceField p =
        solve(creepage, friction, contact::UpwindOrder::second).fields.traction;
    return rollfem::testing::forces(grid, {p.x, p.y});
  }
};

}  // namespace

TEST(DerivedRolling, FrictionalPowerIsTheCreepagePower) {
  const contact::Creepage creepage{-1e-3, 5e-4, 1e-4};
  std::array<double, 2> difference{};
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const RollingEllipse rolling(k == 0 ? 20 : 40, 0.28);
    const auto point = rolling.solve(creepage, 0.3, contact::UpwindOrder::second);
    const auto balance = contact::power_balance(rolling.grid, point, 20e3);
    EXPECT_GT(balance.friction, 0.0);
    difference[k] = balance.difference;
    // Coulomb's law element by element: slip against the traction.
    const contact::ContactFields& fields = point.fields;
    const double scale =
        fields.slip.x.cwiseAbs().maxCoeff() * fields.traction.x.cwiseAbs().maxCoeff();
    for (int i = 0; i < rolling.grid.size(); ++i) {
      if (rolling.pressure[i] == 0.0) continue;
      const double work =
          fields.traction.x[i] * fields.slip.x[i] + fields.traction.y[i] * fields.slip.y[i];
      EXPECT_LE(work, 1e-5 * scale);
    }
    RecordProperty(k == 0 ? "difference_20" : "difference_40", std::to_string(balance.difference));
  }
  EXPECT_LT(difference[1], 0.02);
  EXPECT_LT(difference[1], difference[0]);
}

TEST(DerivedRolling, ForcesAtSmallCreepageAreKalkersCoefficients) {
  // Table for a/b = 1, nu = 0.25: 4.12, 3.67, 1.47 (C32 = -C23); so much friction that nearly all
  // adheres. The table itself is good to about 1 %.
  const RollingEllipse rolling(40, 0.25);
  // Odd in the creepage, and linear where all adheres.
  const double step = 2e-5;
  const double unit = 82000.0 * 36.0 * step;
  const auto xi = rolling.forces({step, 0.0, 0.0}, 10.0);
  const auto eta = rolling.forces({0.0, step, 0.0}, 10.0);
  const auto phi = rolling.forces({0.0, 0.0, 0.1 * step}, 10.0);
  const double c11 = -xi.x / unit;
  const double c22 = -eta.y / unit;
  const double c23 = -phi.y / (0.1 * unit * 6.0);
  const double c32 = -eta.moment / (unit * 6.0);
  EXPECT_NEAR(c11, 4.12, 0.02 * 4.12);
  EXPECT_NEAR(c22, 3.67, 0.02 * 3.67);
  EXPECT_NEAR(c23, 1.47, 0.02 * 1.47);
  EXPECT_NEAR(c32, -c23, 0.02 * c23);
  // Longitudinal and lateral creepage do not mix without spin.
  EXPECT_NEAR(eta.x / unit, 0.0, 1e-6);
  EXPECT_NEAR(xi.y / unit, 0.0, 1e-6);
  RecordProperty("c11", std::to_string(c11));
  RecordProperty("c22", std::to_string(c22));
  RecordProperty("c23", std::to_string(c23));
  RecordProperty("c32", std::to_string(c32));
}

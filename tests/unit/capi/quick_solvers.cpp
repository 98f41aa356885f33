// The solvers of the C interface, which sum over elements in memory that they keep, against those
// of contact/solve with the half-space's transforms, on the same grids.
#include "capi/pressure_solver.hpp"
#include "capi/traction_solver.hpp"
#include "contact/solve/leading_edge.hpp"
#include "contact/solve/normal.hpp"
#include "contact/solve/tangential.hpp"
#include "halfspace/elasticity/compliance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using namespace rollfem;
using capi::InfluenceTable;
using capi::InfluenceTables;
using contact::ContactGrid;
using contact::Field;

constexpr int n = 20;

const InfluenceTables& tables() {
  static const InfluenceTables made(n, contact::combine({}, {}));
  return made;
}

/// A patch of about 12 by 12 elements.
struct Case {
  const InfluenceTable& table;
  ContactGrid grid;
  Field distance;
  double force = 50e3;

  Case(double ratio, double along, double across)
      : table(*tables().nearest(ratio)),
        grid(ContactGrid::centred(n, n, along / 12.0, table.ratio * along / 12.0, 0.1, -0.2)) {
    distance = grid.sample([&](double x, double y) {
      return 0.03 * (4.0 * x * x / (along * along) + 4.0 * y * y / (across * across) +
                     0.2 * x * y / (along * across));
    });
  }
};

Field pressure_of(const Case& of) {
  capi::PressureSolver quick(n);
  const std::vector<double> carried(n, 1.0);
  EXPECT_TRUE(quick.solve({of.table, of.grid, of.distance, carried, of.force, 1e-10}, true));
  return quick.pressure();
}

double largest_difference(const Field& a, const Field& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

TEST(QuickSolvers, PressureIsThatOfTheHalfSpace) {
  for (const Case& of : {Case(1.0, 10.0, 10.0), Case(0.1, 30.0, 3.0), Case(2.1, 6.0, 13.0)}) {
    const halfspace::HalfspaceCompliance compliance(of.grid, contact::combine({}, {}));
    contact::NormalOptions options;
    options.tolerance = 1e-10;
    const Field exact =
        contact::solve_normal(compliance.normal(), {of.distance, of.force, {}}, options).pressure;
    EXPECT_LT(largest_difference(pressure_of(of), exact), 1e-6 * exact.maxCoeff());
    EXPECT_NEAR(exact.sum() * of.grid.element_area(), of.force, 1e-6 * of.force);
  }
}

TEST(QuickSolvers, TractionsAreThoseOfTheHalfSpace) {
  const double friction = 0.3;
  capi::TractionSolver quick(n, 15 * 15);
  for (const Case& of : {Case(1.0, 10.0, 10.0), Case(0.1, 30.0, 3.0), Case(2.1, 6.0, 13.0)}) {
    const Field pressure = pressure_of(of), weights = contact::upwind_weights(of.grid, pressure);
    const halfspace::HalfspaceCompliance compliance(of.grid, contact::combine({}, {}));
    const contact::EdgeFittedRolling rolling(compliance.rolling(contact::UpwindOrder::first),
                                             compliance.rolling(contact::UpwindOrder::second),
                                             weights);
    contact::TangentialOptions options;
    options.tolerance = 1e-9;
    // Mostly adhesion, sliding all over, spin alone, all together; the last from the one before.
    for (const contact::Creepage& creepage :
         {contact::Creepage{2e-4, 0.0, 0.0}, contact::Creepage{0.01, -0.01, 0.0},
          contact::Creepage{0.0, 0.0, 1e-3}, contact::Creepage{-1e-3, 5e-4, 2e-4},
          contact::Creepage{-1e-3, 6e-4, 2e-4}}) {
      const contact::TangentialField slip = contact::uniform_slip(creepage, of.grid);
      const auto exact = contact::solve_tangential(
          rolling, {pressure, slip, contact::coulomb(friction), 1.0}, options, {});
      const bool anew = creepage.lateral != 6e-4;
      ASSERT_TRUE(quick.solve({of.table, of.grid, pressure, weights, slip, friction, 1e-9}, anew));
      const double bound = 1e-6 * friction * pressure.maxCoeff();
      EXPECT_LT(largest_difference(quick.traction().x, exact.traction.x), bound);
      EXPECT_LT(largest_difference(quick.traction().y, exact.traction.y), bound);
      EXPECT_EQ(quick.adhering(), std::count(exact.state.begin(), exact.state.end(),
                                             contact::ElementState::adhesion));
    }
  }
}

TEST(QuickSolvers, SayWhenTheyCannot) {
  const Case of(1.0, 10.0, 10.0);
  const Field pressure = pressure_of(of), weights = contact::upwind_weights(of.grid, pressure);
  const contact::TangentialField slip = contact::uniform_slip({1e-3, 0.0, 0.0}, of.grid);
  capi::TractionSolver small(n, 20);
  EXPECT_FALSE(small.solve({of.table, of.grid, pressure, weights, slip, 0.3, 1e-6}, true));
  EXPECT_EQ(tables().nearest(1e3), nullptr);
  EXPECT_EQ(tables().nearest(1e-3), nullptr);
}

}  // namespace

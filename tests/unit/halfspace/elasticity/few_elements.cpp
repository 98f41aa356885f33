// SPDX-License-Identifier: LGPL-2.1-or-later
// The contact solvers with sums over few elements, as the C interface uses them, against the same
// with the half-space's transforms, on the same grids.
#include "halfspace/elasticity/few_elements.hpp"

#include "contact/iteration/bound_constrained_cg.hpp"
#include "contact/iteration/friction_newton.hpp"
#include "contact/iteration/leading_edge.hpp"
#include "contact/iteration/normal.hpp"
#include "contact/iteration/tangential.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/elasticity/influence.hpp"
#include "halfspace/elasticity/neighbours.hpp"

#include "support/test.hpp"

namespace {

using halfspace::InfluenceTable;
using halfspace::InfluenceTables;

constexpr int n = 20;

const InfluenceTables& tables() {
  static const InfluenceTables made(n, n, contact::combine({}, {}));
  return made;
}

InfluenceTable table_of(double ratio) {
  InfluenceTable table;
  EXPECT_TRUE(tables().interpolate(ratio, table));
  return table;
}

/// A patch of about 12 by 12 elements.
struct Case {
  InfluenceTable table;
  ContactGrid grid;
  Field distance;
  double force = 50e3;

  Case(double ratio, double along, double across)
      : table(table_of(ratio)),
        grid(ContactGrid::centred(n, n, along / 12.0, table.ratio * along / 12.0, 0.1, -0.2)) {
    distance = grid.sample([&](double x, double y) {
      return 0.03 * (4.0 * x * x / (along * along) + 4.0 * y * y / (across * across) +
                     0.2 * x * y / (along * across));
    });
  }
};

Field pressure_of(const Case& of) {
  contact::BoundConstrainedCg quick;
  contact::NormalOptions options;
  options.tolerance = 1e-10;
  const std::vector<double> carried(n, 1.0);
  halfspace::FewElementsNormal normal(contact::combine({}, {}));
  normal.set({{&of.table, of.grid, carried.data()}});
  quick.solve_sum(normal, of.distance, of.force, options, {});
  return quick.pressure() / of.grid.element_area();
}

double largest_difference(const Field& a, const Field& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

TEST(FewElements, PressureIsThatOfTheHalfSpace) {
  for (const Case& of : {Case(1.0, 10.0, 10.0), Case(0.125, 30.0, 3.0), Case(2.0, 6.0, 13.0)}) {
    const halfspace::HalfspaceCompliance compliance(of.grid, contact::combine({}, {}));
    contact::NormalOptions options;
    options.tolerance = 1e-10;
    const Field exact =
        contact::solve_normal(compliance.normal(), {of.distance, of.force, {}}, options).pressure;
    EXPECT_LT(largest_difference(pressure_of(of), exact), 1e-6 * exact.maxCoeff());
    EXPECT_NEAR(exact.sum() * of.grid.element_area(), of.force, 1e-6 * of.force);
  }
}

/// `layer`: compliance between the bodies, mm/MPa.
void expect_tractions_of_the_halfspace(double layer) {
  const double friction = 0.3;
  contact::CombinedMaterial material = contact::combine({}, {});
  material.layer = layer;
  halfspace::FewElementsRolling elements(n, n, 15 * 15);
  contact::FrictionNewton quick;
  const contact::Friction law = contact::coulomb(friction);
  for (const Case& of : {Case(1.0, 10.0, 10.0), Case(0.125, 30.0, 3.0), Case(2.0, 6.0, 13.0)}) {
    const Field pressure = pressure_of(of), weights = contact::upwind_weights(of.grid, pressure);
    const halfspace::HalfspaceCompliance compliance(of.grid, material);
    const contact::EdgeFittedRolling rolling(compliance.rolling(contact::UpwindOrder::first),
                                             compliance.rolling(contact::UpwindOrder::second),
                                             weights);
    ASSERT_TRUE(elements.set(of.table, pressure, weights, layer / of.grid.dx));
    const auto count = static_cast<Eigen::Index>(elements.grid_indices().size());
    contact::TangentialField traction;
    contact::TangentialOptions options;
    options.tolerance = 1e-9;
    // Mostly adhesion, sliding all over, spin alone, all together; the last from the one before.
    for (const contact::Creepage& creepage :
         {contact::Creepage{2e-4, 0.0, 0.0}, contact::Creepage{0.01, -0.01, 0.0},
          contact::Creepage{0.0, 0.0, 1e-3}, contact::Creepage{-1e-3, 5e-4, 2e-4},
          contact::Creepage{-1e-3, 6e-4, 2e-4}}) {
      const contact::TangentialProblem problem{
          pressure, {contact::uniform_slip(creepage, of.grid)}, law};
      const auto exact = contact::solve_tangential(rolling, problem, options, {});
      const bool anew = creepage.lateral != 6e-4;
      quick.solve(elements, of.grid, problem, elements.grid_indices(), options,
                  anew ? contact::TangentialField() : traction);
      traction = {Field::Zero(n * n), Field::Zero(n * n)};
      for (Eigen::Index e = 0; e < count; ++e) {
        const Eigen::Index k = elements.grid_indices()[static_cast<std::size_t>(e)];
        traction.x[k] = quick.traction()[e];
        traction.y[k] = quick.traction()[count + e];
      }
      const double bound = 1e-6 * friction * pressure.maxCoeff();
      EXPECT_LT(largest_difference(traction.x, exact.traction.x), bound);
      EXPECT_LT(largest_difference(traction.y, exact.traction.y), bound);
      EXPECT_EQ(
          std::count(quick.adheres().begin(), quick.adheres().end(), 1),
          std::count(exact.state.begin(), exact.state.end(), contact::ElementState::adhesion));
    }
  }
}

TEST(FewElements, TractionsAreThoseOfTheHalfSpace) {
  expect_tractions_of_the_halfspace(0.0);
}

TEST(FewElements, TractionsWithALayerAreThoseOfTheHalfSpace) {
  for (const double layer : {1e-6, 1.5e-4, 3e-3}) expect_tractions_of_the_halfspace(layer);
}

/// Of elements of `patch` under the point loads of elements that `force` puts on `loaded`, between
/// surfaces whose pressures carry `carried` of themselves along the load.
Field displacement_by(const Case& patch, const Case& loaded, const Field& force, double carried,
                      const contact::ContactPlace& here, const contact::ContactPlace& there) {
  std::vector<contact::NeighbourLoad> loads;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      contact::NeighbourLoad load;
      load.x = loaded.grid.x(i);
      load.y = loaded.grid.y(j);
      load.normal = force[loaded.grid.index(i, j)] / carried;
      halfspace::place_beside(here, there, load);
      loads.push_back(load);
    }
  return halfspace::neighbour_displacement(loads, contact::combine({}, {}), patch.grid) / carried;
}

TEST(FewElements, PatchesDisplaceEachOtherAsPointLoadsDo) {
  const Case tread(1.0, 12.0, 12.0), flange(0.1, 30.0, 3.0);
  const double carried = 0.8;
  contact::ContactPlace on_tread, on_flange;
  on_flange.way_across = -22.0;
  on_flange.contact_angle = 1.1;
  const std::vector<double> parts(n, carried);
  halfspace::FewElementsNormal normal(contact::combine({}, {}));
  normal.set({{&tread.table, tread.grid, parts.data(), &on_tread},
              {&flange.table, flange.grid, parts.data(), &on_flange}});
  const Field pressed = pressure_of(tread);
  Field forces = Field::Zero(2 * n * n), gap;
  forces.tail(n * n) = pressure_of(flange) * flange.grid.element_area();
  normal.apply(forces, gap);
  const Field exact =
      displacement_by(tread, flange, forces.tail(n * n), carried, on_tread, on_flange);
  EXPECT_LT(largest_difference(gap.head(n * n), exact), 0.01 * exact.maxCoeff());
  // What one does to the other under a load, the other does to the one.
  Field others = Field::Zero(2 * n * n), back;
  others.head(n * n) = pressed * tread.grid.element_area();
  normal.apply(others, back);
  EXPECT_NEAR(others.dot(gap) / forces.dot(back), 1.0, 1e-12);
}

TEST(FewElements, CoefficientsBetweenTheRatiosOfTheLadderAreInterpolated) {
  const contact::CombinedMaterial material = contact::combine({}, {});
  for (const double ratio : {0.0171, 0.11, 0.92, 1.09, 2.18, 58.0}) {
    const InfluenceTable table = table_of(ratio);
    const auto exact = [&](int i, int j) {
      return halfspace::rectangle_influence(i, j * ratio, 1.0, ratio, material);
    };
    const double own = exact(0, 0).nn, own_x = exact(0, 0).xx - exact(1, 0).xx;
    for (int j = 0; j < n; ++j)
      for (int i = -n; i <= n; ++i) {
        EXPECT_NEAR(table.row(table.nn, j)[i], exact(i, j).nn, 1e-4 * own);
        EXPECT_NEAR(table.row(table.xx, j)[i], exact(i, j).xx - exact(i + 1, j).xx, 1e-4 * own_x);
      }
  }
}

TEST(FewElements, SayWhenTheyCannot) {
  const Case of(1.0, 10.0, 10.0);
  const Field pressure = pressure_of(of), weights = contact::upwind_weights(of.grid, pressure);
  halfspace::FewElementsRolling small(n, n, 20);
  EXPECT_FALSE(small.set(of.table, pressure, weights));
  InfluenceTable table;
  EXPECT_FALSE(tables().interpolate(1e3, table));
  EXPECT_FALSE(tables().interpolate(1e-3, table));
}

}  // namespace

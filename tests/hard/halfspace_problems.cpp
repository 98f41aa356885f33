// SPDX-License-Identifier: LGPL-2.1-or-later
// Prescribed forces, unlike materials, histories and shapes where half-space codes tend to fail,
// each with a known answer.
#include "base/errors.hpp"
#include "contact/solve/contact_problem.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "scene/geometry.hpp"

#include "support/temporary_folder.hpp"
#include "support/thesis_cases.hpp"

namespace {

constexpr double sliding = 0.55 * 50e3;

PointResult with_force(const PrescribedForce& force, double spin, int across = 20) {
  Case input = thesis_case('b', across, {{0.0, 0.0, spin}});
  input.rolling.forces = {force};
  return halfspace::run_halfspace(input, {}).points[0];
}

TEST(HardForces, ConvergeUpToSaturation) {
  double before = 0.0;
  for (const double part : {1e-6, 0.5, 0.99, 0.999, 0.9999}) {
    const PointResult braked = with_force({-part * sliding, {}}, 0.0);
    EXPECT_NEAR(braked.longitudinal_force, -part * sliding, 1e-5 * sliding) << part;
    EXPECT_GT(braked.creepage.longitudinal, before) << part;
    before = braked.creepage.longitudinal;
    EXPECT_NEAR(with_force({part * sliding, {}}, 0.0).creepage.longitudinal,
                -braked.creepage.longitudinal, 1e-3 * braked.creepage.longitudinal + 1e-9);
    const double each = part * sliding * std::sqrt(0.5);
    const PointResult both = with_force({-each, -each}, 0.0);
    EXPECT_NEAR(both.longitudinal_force, -each, 1e-5 * sliding) << part;
    EXPECT_NEAR(both.lateral_force, -each, 1e-5 * sliding) << part;
  }
}

TEST(HardForces, BeyondFrictionIsAnErrorThatSaysSo) {
  for (const PrescribedForce& force : {PrescribedForce{1.001 * sliding, {}},
                                       {{}, -1.001 * sliding},
                                       {0.8 * sliding, 0.8 * sliding},
                                       {sliding, {}}})
    EXPECT_TRUE(says(refusal<SolveError>([&] { with_force(force, 0.0); }), "mu F_z = 27500 N"));
}

TEST(HardForces, UnderSpinUpToFullSlip) {
  for (const double spin : {1e-6, 1e-3, 1e-2, 0.1, 1.0, 10.0}) {
    const PointResult point = with_force({-0.5 * sliding, 0.3 * sliding}, spin);
    EXPECT_NEAR(point.longitudinal_force, -0.5 * sliding, 1e-5 * sliding) << spin;
    EXPECT_NEAR(point.lateral_force, 0.3 * sliding, 1e-5 * sliding) << spin;
    const PointResult free = with_force({{}, 0.0}, spin);
    EXPECT_NEAR(free.lateral_force, 0.0, 1e-5 * sliding) << spin;
  }
  // In full slip only the place of the pole counts, (-eta, xi)/phi: the same at ten times the spin.
  const PointResult one = with_force({-0.5 * sliding, 0.3 * sliding}, 1.0);
  const PointResult ten = with_force({-0.5 * sliding, 0.3 * sliding}, 10.0);
  EXPECT_EQ(ten.adhesion_area, 0.0);
  EXPECT_NEAR(ten.creepage.longitudinal / one.creepage.longitudinal, 10.0, 0.02);
}

TEST(HardForces, WithoutFrictionTheyAreAnError) {
  Case input = thesis_case('b', 10);
  input.friction_coefficient = 0.0;
  input.rolling.forces = {{-10.0, {}}};
  EXPECT_THROW(halfspace::run_halfspace(input, {}), SolveError);
}

ModelResult rolled(const contact::Material& wheel, const contact::Material& rail, double friction,
                   const contact::Creepage& creepage, int across = 20) {
  Case input = thesis_case('b');
  input.wheel.material = wheel;
  input.rail.material = rail;
  input.friction_coefficient = friction;
  input.contact_grid.elements_across = across;
  input.rolling.creepages = {creepage};
  return halfspace::run_halfspace(input, {});
}

TEST(HardMaterials, ARigidWheelOnAnIncompressibleRailIsLikeTwoOfTwiceItsModulus) {
  // (1 - 2 nu)/G vanishes for both bodies: no coupling, G = 2 G_rail, nu = 1/2.
  const PointResult rigid =
      rolled({infinity, 0.3}, {210e3, 0.5}, 0.55, {1e-3, 5e-4, 1e-4}).points[0];
  const PointResult like = rolled({420e3, 0.5}, {420e3, 0.5}, 0.55, {1e-3, 5e-4, 1e-4}).points[0];
  EXPECT_NEAR(rigid.longitudinal_force / like.longitudinal_force, 1.0, 1e-6);
  EXPECT_NEAR(rigid.lateral_force / like.lateral_force, 1.0, 1e-6);
  EXPECT_NEAR(rigid.max_pressure / like.max_pressure, 1.0, 1e-9);
  // The same but for hardly any compressibility.
  const PointResult nearly =
      rolled({420e3, 0.4999}, {420e3, 0.4999}, 0.55, {1e-3, 5e-4, 1e-4}).points[0];
  EXPECT_NEAR(nearly.longitudinal_force / like.longitudinal_force, 1.0, 5e-4);
}

TEST(HardMaterials, ARigidWheelIsTheLimitOfAHardOne) {
  const PointResult rigid = rolled({infinity, 0.3}, {210e3, 0.3}, 0.3, {1e-3, 0, 0}).points[0];
  const PointResult hard = rolled({210e9, 0.3}, {210e3, 0.3}, 0.3, {1e-3, 0, 0}).points[0];
  EXPECT_NEAR(rigid.longitudinal_force, hard.longitudinal_force, 1e-5 * 0.3 * 50e3);
  // Without friction the pressure is Hertz's, with friction higher by a little.
  const PointResult smooth = rolled({infinity, 0.3}, {210e3, 0.3}, 0.0, {0, 0, 0}).points[0];
  EXPECT_GT(rigid.max_pressure, smooth.max_pressure);
  EXPECT_LT(rigid.max_pressure, 1.05 * smooth.max_pressure);
}

TEST(HardMaterials, ExchangingTheBodiesMirrorsTheTractions) {
  // Wheel and rail exchanged: K changes sign, which turning the creepage undoes.
  const PointResult one = rolled({70e3, 0.33}, {210e3, 0.28}, 0.3, {1e-3, 5e-4, 0}).points[0];
  const PointResult two = rolled({210e3, 0.28}, {70e3, 0.33}, 0.3, {-1e-3, -5e-4, 0}).points[0];
  EXPECT_NEAR(one.longitudinal_force / -two.longitudinal_force, 1.0, 1e-5);
  EXPECT_NEAR(one.lateral_force / -two.lateral_force, 1.0, 1e-5);
  EXPECT_NEAR(one.max_pressure / two.max_pressure, 1.0, 1e-6);
}

TEST(HardMaterials, FreeRollingOfUnlikeMaterialsAtAnyFriction) {
  // What is returned must hold the contact conditions with the whole, coupled compliance.
  for (const double friction : {1e-3, 0.3, 10.0}) {
    Case input = thesis_case('b');
    input.wheel.material = {2.0 * 23000.0 * 1.31, 0.31};
    input.rail.material = {2.0 * 82000.0 * 1.28, 0.28};
    input.friction_coefficient = friction;
    input.contact_grid.elements_across = 24;
    input.rolling.forces = {{0.0, {}}};
    const ModelResult result = halfspace::run_halfspace(input, {});
    const PointResult& point = result.points[0];
    EXPECT_NEAR(point.longitudinal_force, 0.0, 1e-5 * friction * 50e3) << friction;
    EXPECT_LT(point.creepage.longitudinal, -1e-4) << friction;  // aluminium on steel: minus
    const contact::CombinedMaterial material =
        contact::combine(input.wheel.material, input.rail.material);
    const halfspace::HalfspaceCompliance compliance(result.grid, material);
    const contact::SurfaceField u = compliance.apply(point.fields.traction);
    const TangentialField slope =
        contact::upwind_difference(result.grid, {u.x, u.y}, UpwindOrder::second);
    const contact::Curvatures h = contact::relative_curvatures(input);
    const double size = std::abs(point.creepage.longitudinal);
    for (int j = 0; j < result.grid.ny; ++j)
      for (int i = 0; i < result.grid.nx; ++i) {
        const int k = result.grid.index(i, j);
        const double gap = contact::undeformed_distance(h, result.grid.x(i), result.grid.y(j)) +
                           u.n[k] - point.approach;
        if (point.fields.traction.n[k] > 0.0)
          EXPECT_NEAR(gap, 0.0, 1e-4 * point.approach) << friction;
        else
          EXPECT_GT(gap, -1e-4 * point.approach) << friction;
        // Leading elements have a difference of their own.
        const bool leading = i + 1 == result.grid.nx || point.fields.traction.n[k + 1] == 0.0;
        if (!leading && point.fields.state[static_cast<std::size_t>(k)] == ElementState::adhesion) {
          EXPECT_NEAR(point.creepage.longitudinal + slope.x[k], 0.0, 2e-3 * size) << friction;
          EXPECT_NEAR(slope.y[k], 0.0, 2e-3 * size) << friction;
        }
      }
  }
}

TEST(HardShapes, TwoPatchesWithFrictionShareTheForces) {
  // Two equal balls side by side, ten patch radii apart: each as if alone under half the force.
  const double radius = 300.0;
  const halfspace::HertzContact single =
      halfspace::hertz_from_force(0.5 / radius, 0.5 / radius, steel().contact_modulus, 10e3);
  const double a = single.semi_axis_x;
  const double cell = a / 10.0;
  const auto run = [&](bool both, double force) {
    const ContactGrid grid = both ? ContactGrid::centred(28, 128, cell, cell)
                                  : ContactGrid::centred(28, 28, cell, cell, 0.0, 5.0 * a);
    const halfspace::HalfspaceCompliance compliance(grid, steel());
    contact::ContactConditions scene;
    scene.friction = contact::coulomb(0.3);
    scene.undeformed_distance = grid.sample([&](double x, double y) {
      const double v = std::abs(y) - 5.0 * a;
      return (x * x + v * v) / (2.0 * radius);
    });
    contact::ContactProblem problem(compliance, compliance, scene);
    // The spin turns about the middle between them: opposite creepages in the two.
    const auto forces = [&](double xi, double phi) {
      const TangentialField slip{grid.sample([&](double, double y) { return xi - phi * y; }),
                                 grid.sample([&](double x, double) { return phi * x; })};
      return rollfem::testing::forces(grid, problem.solve({force, {}}, {slip}).tangential.traction);
    };
    return std::pair{forces(5e-4, 0.0), forces(0.0, 1e-4 / a)};
  };
  const auto [alone, alone_turning] = run(false, 10e3);
  const auto [pair, pair_turning] = run(true, 20e3);
  // The neighbour's influence goes as a/distance: some per cent.
  EXPECT_NEAR(pair.x / (2.0 * alone.x), 1.0, 0.05);
  EXPECT_NEAR(pair.moment, 0.0, 1e-4 * std::abs(pair.x) * a);
  EXPECT_NEAR(pair_turning.x, 0.0, 1e-4 * std::abs(alone_turning.x));
  EXPECT_NEAR(pair_turning.moment / (2.0 * alone_turning.moment), 1.0, 0.05);
}

TEST(HardShapes, DistanceGivenPointByPointIsTheSameContact) {
  Case input = thesis_case('b', 40, {{1e-3, 0.0, 0.0}});
  const PointResult quadratic = halfspace::run_halfspace(input, {}).points[0];
  contact::Lattice lattice;
  lattice.file = "h.csv";
  lattice.nx = lattice.ny = 41;
  lattice.dx = lattice.dy = 0.5;
  lattice.x_first = lattice.y_first = -10.0;
  lattice.values.resize(1);
  const contact::Curvatures h = contact::relative_curvatures(input);
  for (int j = 0; j < 41; ++j)
    for (int i = 0; i < 41; ++i)
      lattice.values[0].push_back(
          contact::undeformed_distance(h, -10.0 + 0.5 * i, -10.0 + 0.5 * j));
  input.undeformed_distance.values = lattice;
  const halfspace::HertzContact hertz = halfspace::hertz_of_scene(thesis_case('b'));
  input.contact_grid.cell_size = {{2.0 * hertz.semi_axis_x / 40, 2.0 * hertz.semi_axis_y / 40}};
  const PointResult given = halfspace::run_halfspace(input, {}).points[0];
  EXPECT_NEAR(given.max_pressure / quadratic.max_pressure, 1.0, 1e-3);
  EXPECT_NEAR(given.traction_coefficient, quadratic.traction_coefficient, 0.003 * 0.55);
}

TEST(HardHistory, AnEmptyStepChangesNothingAndFullSlidingSaturates) {
  Case input = thesis_case('b', 16);
  input.rolling.problem = Problem::shift;
  for (const double shift : {0.002, 0.0, 1.0, -1e-9}) {
    contact::HistoryStep step;
    step.longitudinal_shift = shift;
    input.history.push_back(step);
  }
  input.rolling.creepages.assign(4, {});
  const ModelResult result = halfspace::run_halfspace(input, {});
  EXPECT_LT(result.points[0].longitudinal_force, -100.0);
  EXPECT_NEAR(result.points[1].longitudinal_force / result.points[0].longitudinal_force, 1.0, 1e-5);
  EXPECT_NEAR(result.points[2].longitudinal_force, -sliding, 1e-4 * sliding);
  EXPECT_NEAR(result.points[3].longitudinal_force, -sliding, 1e-3 * sliding);
  EXPECT_NEAR(result.points[3].longitudinal_shift, 1.002, 1e-6);
}

}  // namespace

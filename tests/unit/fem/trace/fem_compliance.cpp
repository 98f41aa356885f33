// SPDX-License-Identifier: LGPL-2.1-or-later
// Coupling and compliance: resultants, transpose consistency, symmetry, the mirrored half body.
#include "base/errors.hpp"
#include "fem/fem_options.hpp"
#include "fem/trace/middle_displacement.hpp"
#include "scene/geometry.hpp"

#include <deal.II/dofs/dof_tools.h>

#include "support/fem_body_pair.hpp"

namespace {

auto* const bodies = new PairEnvironment(100);
[[maybe_unused]] auto* const registered = ::testing::AddGlobalTestEnvironment(bodies);

const Pair& full() {
  return bodies->full();
}

const Pair& half() {
  return bodies->half();
}

/// Elements that neither match nor divide the 1 mm faces.
contact::ContactGrid odd_grid() {
  return contact::ContactGrid::centred(3, 4, 1.3, 1.1, 0.2, -0.15);
}

/// Tractions times the true area of their elements.
contact::SurfaceField weighted(const contact::ContactSurface& surface,
                               const contact::ContactGrid& grid, const contact::SurfaceField& p) {
  const contact::Field area = grid.element_area() * contact::patch_shape(surface, grid).stretch;
  return {p.x.cwiseProduct(area), p.y.cwiseProduct(area), p.n.cwiseProduct(area)};
}

contact::ContactSurface own_surface(const fem::Body& body) {
  const double radius = body.shape().transverse_radius;
  return body.shape().is_wheel ? common_surface(body.shape(), rail_shape(-radius))
                               : common_surface(wheel_shape(405, -radius), body.shape());
}

dealii::Tensor<1, 3> resultant(const fem::Body& body, const fem::Vector& b) {
  dealii::Tensor<1, 3> sum;
  std::vector<bool> seen(body.unknowns(), false);
  std::vector<dealii::types::global_dof_index> indices(body.dofs().get_fe().dofs_per_cell);
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    cell->get_dof_indices(indices);
    for (unsigned int i = 0; i < indices.size(); ++i) {
      if (seen[indices[i]]) continue;
      seen[indices[i]] = true;
      sum[body.dofs().get_fe().system_to_component_index(i).first] += b(indices[i]);
    }
  }
  return sum;
}

TEST(SurfaceCoupling, ResultantIsTractionTimesArea) {
  // Flat bodies: every component; curved ones: pressure has the resultant of its projection.
  auto options = small_options();
  const fem::Body flat(rail_shape(contact::infinity), steel, options, MPI_COMM_SELF);
  const auto grid = odd_grid();
  const auto p = random_field(grid, 1);
  auto b = fem::make_vector(flat.dofs());
  own_coupling(flat, grid).load(p, b);
  const auto sum = resultant(flat, b);
  EXPECT_NEAR(sum[0], p.x.sum() * grid.element_area(), 1e-12);
  EXPECT_NEAR(sum[1], p.y.sum() * grid.element_area(), 1e-12);
  EXPECT_NEAR(sum[2], p.n.sum() * grid.element_area(), 1e-12);

  auto pressure = p;
  pressure.x.setZero();
  pressure.y.setZero();
  auto curved = fem::make_vector(full().rail.dofs());
  own_coupling(full().rail, grid).load(pressure, curved);
  EXPECT_NEAR(resultant(full().rail, curved)[2], pressure.n.sum() * grid.element_area(), 1e-8);
}

TEST(SurfaceCoupling, LoadsOfWheelAndRailAreEqualAndOpposite) {
  // Bodies of different slopes: only on a common surface do the same tractions give the same force,
  // which is the closed sum over the elements.
  const auto grid = contact::ContactGrid::centred(2, 4, 1.0, 1.1, 0.0, -0.15);
  const auto surface = full().surface();
  const auto shape = contact::patch_shape(surface, grid);
  auto p = random_field(grid, 4);
  // Along rolling each body keeps its own frame: what turns with the wheel is made symmetric.
  for (int j = 0; j < grid.ny; ++j) {
    p.n[grid.index(1, j)] = p.n[grid.index(0, j)];
    p.y[grid.index(1, j)] = p.y[grid.index(0, j)];
    p.x[grid.index(1, j)] = p.x[grid.index(0, j)];
  }
  const double area = grid.element_area();
  const double expected[3] = {area * p.x.dot(shape.stretch),
                              area * (p.y - p.n.cwiseProduct(shape.climb)).sum(),
                              area * (p.n + p.y.cwiseProduct(shape.climb)).sum()};
  for (const fem::Body* body : {&full().wheel, &full().rail}) {
    auto b = fem::make_vector(body->dofs());
    fem::SurfaceCoupling(*body, grid, surface).load(p, b);
    const auto sum = resultant(*body, b);
    // The wheel's frame turns by up to 0.01 over an element.
    const double tolerance = body == &full().wheel ? 1e-4 : 1e-9;
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(sum[k], expected[k], tolerance) << k;
  }
}

TEST(SurfaceCoupling, SampleIsTheTransposeOfLoad) {
  for (const fem::Body* body : {&full().wheel, &full().rail}) {
    const auto grid = odd_grid();
    const fem::SurfaceCoupling coupling = own_coupling(*body, grid);
    const auto p = random_field(grid, 2);
    auto u = fem::make_vector(body->dofs());
    auto b = fem::make_vector(body->dofs());
    std::mt19937 generator(3);
    for (unsigned int i = 0; i < u.locally_owned_size(); ++i)
      u.local_element(i) = generator() * 1e-9;
    coupling.load(p, b);
    const double work = b * u;
    EXPECT_NEAR(dot(weighted(own_surface(*body), grid, p), coupling.sample(u)) / work, 1.0, 1e-12);
  }
}

namespace {

/// The same displacement at every node of a body.
fem::Vector rigid_displacement(const fem::Body& body, const std::array<double, 3>& displacement) {
  auto u = fem::make_vector(body.dofs());
  std::vector<dealii::types::global_dof_index> indices(body.dofs().get_fe().dofs_per_cell);
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    cell->get_dof_indices(indices);
    for (unsigned int i = 0; i < indices.size(); ++i)
      u(indices[i]) = displacement[body.dofs().get_fe().system_to_component_index(i).first];
  }
  return u;
}

}  // namespace

TEST(SurfaceCoupling, SamplesARigidDisplacementExactly) {
  const auto grid = odd_grid();
  const fem::Body flat(rail_shape(contact::infinity), steel, small_options(), MPI_COMM_SELF);
  const auto sampled = own_coupling(flat, grid).sample(rigid_displacement(flat, {1.0, 2.0, 3.0}));
  for (int e = 0; e < grid.size(); ++e) {
    EXPECT_NEAR(sampled.x[e], 1.0, 1e-12);
    EXPECT_NEAR(sampled.y[e], 2.0, 1e-12);
    EXPECT_NEAR(sampled.n[e], 3.0, 1e-12);
  }
}

TEST(CurvatureSlip, ARigidDisplacementOfTheWheelSlipsNowhere) {
  const auto grid = contact::ContactGrid::centred(6, 4, 1, 1);
  for (const double radius : {contact::infinity, -20.0, 60.0}) {
    const auto shape = wheel_shape(405, radius);
    const fem::Body wheel(shape, steel, small_options(), MPI_COMM_SELF);
    const auto surface = common_surface(shape, rail_shape(25));
    const auto u = fem::SurfaceCoupling(wheel, grid, surface)
                       .sample(rigid_displacement(wheel, {0.3, 0.1, 0.7}));
    const auto difference =
        contact::upwind_difference(grid, {u.x, u.y}, contact::UpwindOrder::second);
    const auto turning = contact::CurvatureSlip(surface, grid)(u);
    // u_n / R alone is 1.7e-3, the lateral part up to 0.3 / 405 times the sine of the tilt; the
    // second-order difference is exact to (dx/R)^2 of them, the mean over the tilt of an element to
    // (dy/R_y)^2.
    EXPECT_GT(turning.x.minCoeff(), 1e-3);
    EXPECT_GT(turning.y.cwiseAbs().maxCoeff(), 1e-5);
    EXPECT_LT((difference.x + turning.x).cwiseAbs().maxCoeff(), 4e-6);
    EXPECT_LT((difference.y + turning.y).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(SurfaceCoupling, RefusesGridsThatDoNotFit) {
  using contact::ContactGrid;
  const auto& rail = full().rail;
  EXPECT_THROW(own_coupling(rail, ContactGrid::centred(4, 4, 10, 10)), contact::InputError);
  EXPECT_THROW(own_coupling(rail, ContactGrid::centred(4, 4, 0.5, 1)), contact::InputError);
  EXPECT_THROW(own_coupling(rail, ContactGrid::centred(4, 4, 1, 0.5)), contact::InputError);
  EXPECT_NO_THROW(own_coupling(rail, ContactGrid::centred(4, 4, 1, 1)));
  EXPECT_THROW(own_coupling(half().rail, ContactGrid::centred(4, 4, 1, 1, 0, 0.5)),
               contact::InputError);
}

TEST(FemCompliance, IsSymmetricAndPositive) {
  for (const Pair* pair : {&full(), &half()}) {
    const auto grid = pair == &full() ? odd_grid() : contact::ContactGrid::centred(4, 5, 1.1, 1.0);
    const auto compliance = pair->compliance(grid);
    const auto surface = pair->surface();
    for (unsigned int seed = 0; seed < 3; ++seed) {
      const auto p = random_field(grid, 10 + seed);
      const auto q = random_field(grid, 20 + seed);
      const auto Ap = compliance.apply(p);
      const auto Aq = compliance.apply(q);
      const auto wp = weighted(surface, grid, p);
      const auto wq = weighted(surface, grid, q);
      EXPECT_GT(dot(wp, Ap), 0.0);
      EXPECT_NEAR(dot(wp, Aq), dot(wq, Ap), 1e-10 * std::sqrt(dot(wp, Ap) * dot(wq, Aq)));
    }
    EXPECT_EQ(compliance.solves(), 6);
  }
}

TEST(FemCompliance, ARigidBodyContributesNothing) {
  const auto grid = contact::ContactGrid::centred(4, 4, 1.0, 1.0);
  const auto p = random_field(grid, 8);
  const auto& pair = full();
  for (const auto far : {fem::FarBoundary::clamped, fem::FarBoundary::point_load}) {
    const auto both = pair.compliance(grid, far).respond(p);
    const fem::FemCompliance::Part rigid{nullptr, nullptr};
    const auto wheel =
        fem::FemCompliance({&pair.wheel, pair.wheel_solver.get()}, rigid, pair.surface(), grid, far)
            .respond(p);
    const auto rail =
        fem::FemCompliance(rigid, {&pair.rail, pair.rail_solver.get()}, pair.surface(), grid, far)
            .respond(p);
    const double size = both.displacement.n.norm();
    EXPECT_LT((wheel.displacement.x + rail.displacement.x - both.displacement.x).norm(),
              1e-12 * size);
    EXPECT_LT((wheel.displacement.y + rail.displacement.y - both.displacement.y).norm(),
              1e-12 * size);
    EXPECT_LT((wheel.displacement.n + rail.displacement.n - both.displacement.n).norm(),
              1e-12 * size);
    // The streamlines of the wheel alone curve.
    EXPECT_EQ((wheel.curvature_slip.x - both.curvature_slip.x).norm(), 0.0);
    EXPECT_EQ(rail.curvature_slip.x.norm(), 0.0);
  }
}

TEST(FemCompliance, PressureOpensTheGapAndTractionDragsTheWheelAlong) {
  const auto grid = contact::ContactGrid::centred(4, 4, 1, 1);
  const auto zero = contact::Field(contact::Field::Zero(grid.size()));
  const auto one = contact::Field(contact::Field::Ones(grid.size()));
  const auto compliance = full().compliance(grid);
  EXPECT_GT(compliance.apply({zero, zero, one}).n.minCoeff(), 0.0);
  EXPECT_GT(compliance.apply({one, zero, zero}).x.minCoeff(), 0.0);
  EXPECT_GT(compliance.apply({zero, one, zero}).y.minCoeff(), 0.0);
  // The wheel moves up, the rail down.
  const auto u = full().compliance(grid).body_displacements({zero, zero, one});
  const auto wheel = own_coupling(full().wheel, grid), rail = own_coupling(full().rail, grid);
  EXPECT_GT(wheel.sample(u[0]).n.minCoeff(), 0.0);
  EXPECT_LT(rail.sample(u[1]).n.maxCoeff(), 0.0);
}

TEST(FemCompliance, HalfBodyEqualsFullBodyForSymmetricTractions) {
  for (const int ny : {4, 5}) {  // with and without elements astride the symmetry plane
    const auto grid = contact::ContactGrid::centred(4, ny, 1.1, 1.0);
    const auto p = symmetric_part(grid, random_field(grid, 7));
    const auto whole = full().compliance(grid).apply(p);
    const auto mirrored = half().compliance(grid).apply(p);
    const double scale = whole.n.cwiseAbs().maxCoeff();
    EXPECT_LT((whole.x - mirrored.x).cwiseAbs().maxCoeff(), 1e-8 * scale);
    EXPECT_LT((whole.y - mirrored.y).cwiseAbs().maxCoeff(), 1e-8 * scale);
    EXPECT_LT((whole.n - mirrored.n).cwiseAbs().maxCoeff(), 1e-8 * scale);
  }
}

TEST(FemCompliance, WorkOfTheTractionsOnMeansIsTwiceTheStrainEnergy) {
  // u.b = u.Ku over both bodies, with b from the coupling and u from the solver.
  const auto grid = odd_grid();
  const auto compliance = full().compliance(grid);
  const auto p = random_field(grid, 5);
  const auto u = compliance.body_displacements(p);
  auto b = fem::make_vector(full().wheel.dofs());
  auto r = fem::make_vector(full().rail.dofs());
  const auto surface = full().surface();
  const fem::SurfaceCoupling wheel(full().wheel, grid, surface);
  const fem::SurfaceCoupling rail(full().rail, grid, surface);
  wheel.load(p, b);
  rail.load(p, r);
  const double energy = b * u[0] - r * u[1];
  const auto on_wheel = wheel.sample(u[0]);
  const auto on_rail = rail.sample(u[1]);
  contact::SurfaceField difference{on_wheel.x - on_rail.x, on_wheel.y - on_rail.y,
                                   on_wheel.n - on_rail.n};
  EXPECT_NEAR(dot(weighted(surface, grid, p), difference) / energy, 1.0, 1e-10);

  // What the contact is solved with is this, from means to middles.
  const auto stretch = contact::patch_shape(surface, grid).stretch;
  for (const auto& [coupling, body] : {std::pair{&wheel, &full().wheel}, {&rail, &full().rail}})
    fem::MiddleDisplacement(grid, body->material(), stretch, coupling->lattice())
        .add(p, difference);
  const auto whole = compliance.apply(p);
  EXPECT_LT((whole.x - difference.x).norm(), 1e-10 * whole.x.norm());
  EXPECT_LT((whole.y - difference.y).norm(), 1e-10 * whole.y.norm());
  EXPECT_LT((whole.n - difference.n).norm(), 1e-10 * whole.n.norm());
}

TEST(Factorisation, RefusesAFloatingBody) {
  auto problem = full().rail.problem();
  dealii::AffineConstraints<double> hanging;
  dealii::DoFTools::make_hanging_node_constraints(problem.dofs, hanging);
  hanging.close();
  EXPECT_THROW(fem::make_factorisation({problem.dofs, problem.mapping, hanging, {}, steel}),
               contact::SolveError);
}

}  // namespace

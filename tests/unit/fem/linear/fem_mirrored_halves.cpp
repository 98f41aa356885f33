// SPDX-License-Identifier: LGPL-2.1-or-later
// Even and odd displacements of bodies that are their own mirror images: together the solution of
// the whole body, whose stiffness is applied here by the matrix-free operator.
#include "fem/discretisation/body.hpp"
#include "fem/discretisation/elasticity_operator.hpp"
#include "fem/linear/factorisation.hpp"
#include "fem/linear/mirrored_halves.hpp"

#include "support/fem_elastic_block.hpp"
#include "support/mpi_environment.hpp"

namespace {

fem::BodyOptions coarse(bool half) {
  fem::BodyOptions options;
  options.cell_size = 1.0;
  options.fine_half_length = 3.0;
  options.fine_half_width = 4.0;
  options.extent = 30.0;
  options.half = half;
  return options;
}

/// Residual of a solution under random forces, relative to them.
double residual(const fem::Body& body) {
  auto u = fem::make_vector(body.dofs()), b = u;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (double& value : b) value = uniform(random);
  fem::make_factorisation(body.problem())->solve(u, b);
  const fem::ElasticityOperator<double> stiffness(fem::make_local_cells(body.problem()));
  auto x = stiffness.make_vector(), right = x, product = x;
  std::copy_n(u.begin(), x.locally_owned_size(), x.begin());
  std::copy_n(b.begin(), x.locally_owned_size(), right.begin());
  stiffness.condense(right);
  // Constrained rows are the operator's identity, not equations.
  for (dealii::types::global_dof_index i = 0; i < body.unknowns(); ++i)
    if (body.constraints().is_constrained(i)) x(i) = 0.0;
  stiffness.vmult(product, x);
  product -= right;
  return product.l2_norm() / right.l2_norm();
}

TEST(MirroredHalves, AreTheWholeBodyOfWheelAndRail) {
  for (const bool wheel : {true, false})
    for (const bool half : {true, false}) {
      const fem::SurfaceShape shape = wheel ? fem::SurfaceShape{true, 405.0, -105.0}
                                            : fem::SurfaceShape{false, contact::infinity, 100.0};
      fem::BodyOptions options = coarse(half);
      if (wheel) options.speed = 50e3;
      contact::Material material;
      material.density = 7.85e-9;
      const fem::Body body(shape, material, options, MPI_COMM_WORLD);
      const auto halves = fem::find_mirrored_halves(body.problem());
      ASSERT_TRUE(halves.has_value()) << wheel << half;
      EXPECT_EQ(halves->even.count + halves->odd.count,
                fem::number_free_unknowns(body.dofs(), body.constraints()).count);
      EXPECT_EQ(2 * std::count(halves->even.cells.begin(), halves->even.cells.end(), true),
                static_cast<long>(body.triangulation().n_active_cells()));
      EXPECT_LT(residual(body), 1e-10) << wheel << half;
    }
}

TEST(MirroredHalves, SolveForManyLoadsAsForEach) {
  for (const bool wheel : {true, false}) {
    const fem::SurfaceShape shape = wheel ? fem::SurfaceShape{true, 405.0, -105.0}
                                          : fem::SurfaceShape{false, contact::infinity, 100.0};
    const fem::Body body(shape, {}, coarse(true), MPI_COMM_WORLD);
    const auto solver = fem::make_factorisation(body.problem());
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<fem::Vector> loads(19, fem::make_vector(body.dofs()));
    for (fem::Vector& load : loads)
      for (double& value : load) value = uniform(random);
    std::vector<fem::Vector> solutions(loads.size(), fem::make_vector(body.dofs()));
    solver->solve_all(solutions, loads);
    auto alone = fem::make_vector(body.dofs());
    for (std::size_t k = 0; k < loads.size(); ++k) {
      solver->solve(alone, loads[k]);
      alone -= solutions[k];
      EXPECT_LT(alone.linfty_norm(), 1e-11 * solutions[k].linfty_norm()) << wheel << k;
    }
  }
}

TEST(MirroredHalves, AreNotUsedWithoutMirrorSymmetry) {
  BlockOptions options;  // on one side of x = 0
  options.communicator = MPI_COMM_SELF;
  const Block block(options, {});
  EXPECT_FALSE(fem::find_mirrored_halves(block.problem()).has_value());

  const fem::Body body({false, contact::infinity, 100.0}, {}, coarse(true), MPI_COMM_WORLD);
  auto problem = body.problem();
  problem.material.density = 7.85e-9;
  problem.motion.velocity[0] = 1e4;
  problem.motion.rotation[0] = 100.0;  // along and about the axis of rolling: a screw
  EXPECT_FALSE(fem::find_mirrored_halves(problem).has_value());

  dealii::AffineConstraints<double> held;
  held.copy_from(body.constraints());
  for (dealii::types::global_dof_index i = 0; i < body.unknowns(); ++i)
    if (!held.is_constrained(i)) {
      held.add_line(i);
      break;
    }
  held.close();
  EXPECT_FALSE(fem::find_mirrored_halves({body.dofs(), body.mapping(), held, {}, {}}).has_value());
}

// With loads near the surface on both sides of the mirror plane: rounding in single precision
// alone.
TEST(PartialFactor, SolvesForSomeUnknownsAsTheWholeFactorDoes) {
  fem::BodyOptions options = coarse(true);
  options.rows = fem::GradedDepth(0.1, options.cell_size, 4);
  options.fine_depth = options.rows.reach() / options.cell_size;
  const fem::Body body({false, contact::infinity, 100.0}, {}, options, MPI_COMM_WORLD);
  std::vector<bool> taken(body.unknowns(), false);
  std::vector<dealii::types::global_dof_index> dofs(body.dofs().get_fe().dofs_per_cell), unknowns;
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    if (cell->center().norm() > 3.0) continue;
    cell->get_dof_indices(dofs);
    for (const auto dof : dofs) taken[dof] = true;
  }
  auto b = fem::make_vector(body.dofs()), u = b, part = b;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (!taken[i]) continue;
    unknowns.push_back(i);
    b(i) = uniform(random);
  }
  const auto solver = fem::make_factorisation(body.problem());
  solver->solve(u, b);
  solver->in_part(unknowns)->solve(part, b);
  double largest = 0.0, difference = 0.0;
  for (const auto i : unknowns) {
    largest = std::max(largest, std::abs(u(i)));
    difference = std::max(difference, std::abs(part(i) - u(i)));
  }
  EXPECT_LT(difference, 1e-5 * largest);
  EXPECT_LT(unknowns.size(), body.unknowns() / 2);
}

}  // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Algebraic multigrid against a direct solver, also on a coarse mesh that geometric multigrid would
// have to factorise whole. The same program runs on one process and under mpirun.
#include "base/errors.hpp"
#include "fem/linear/algebraic_multigrid.hpp"

#include "support/fem_against_factorisation.hpp"
#include "support/mpi_environment.hpp"

namespace {

double difference_from_factorisation(const BlockOptions& options, int& iterations) {
  return rollfem::testing::difference_from_factorisation(
      options,
      [](const fem::ElasticProblem& problem) {
        return fem::make_algebraic_multigrid(problem, {1e-11, 200});
      },
      &iterations);
}

TEST(AlgebraicMultigrid, EqualsTheFactorisationWithHangingNodesAndSymmetryPlane) {
  for (const unsigned int degree : {1U, 2U}) {
    BlockOptions options;
    options.degree = degree;
    options.bend = 0.15;
    int iterations = 0;
    EXPECT_LT(difference_from_factorisation(options, iterations), 1e-8) << "degree " << degree;
    RecordProperty("iterations_" + std::to_string(degree), iterations);
  }
}

TEST(AlgebraicMultigrid, CoarsensAnUnrefinedMesh) {
  BlockOptions options;
  options.cells = {9, 6, 6};
  options.bend = 0.1;
  options.global_refinements = options.local_refinements = 0;
  int iterations = 0;
  EXPECT_LT(difference_from_factorisation(options, iterations), 1e-8);
  EXPECT_LE(iterations, 60);
  RecordProperty("iterations", iterations);
}

TEST(AlgebraicMultigrid, SaysSoWhenItDoesNotConverge) {
  const Block block({}, clamped_below());
  auto u = fem::make_vector(block.dofs());
  const auto solver = fem::make_algebraic_multigrid(block.problem(), {1e-12, 2});
  EXPECT_THROW(solver->solve(u, block.body_load(uneven_load)), contact::SolveError);
}

}  // namespace

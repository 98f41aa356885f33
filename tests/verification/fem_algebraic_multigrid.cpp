// Algebraic multigrid against a direct solver, also on a coarse mesh that geometric multigrid would
// have to factorise whole. The same program runs on one process and under mpirun.
#include "contact/errors.hpp"
#include "fem/algebraic_multigrid.hpp"
#include "fem/factorisation.hpp"

#include <gtest/gtest.h>

#include "fem_elastic_block.hpp"
#include "mpi_environment.hpp"
#include <cmath>

namespace rollfem {
namespace {

using dealii::Point;
using dealii::Tensor;
using test::Block;
using test::BlockOptions;

Tensor<1, 3> uneven_load(const Point<3>& p) {
  return Tensor<1, 3>({10 * std::sin(2 * p[1]) + p[2], 5 * p[0] - 3, -20 * std::cos(p[0] + p[1])});
}

/// Largest difference from the factorisation of the same body on this process alone, relative to
/// the largest displacement.
double difference_from_factorisation(const BlockOptions& options, int& iterations) {
  const Block block(options, test::clamped_below());
  auto u = fem::make_vector(block.dofs());
  const auto solver = fem::make_algebraic_multigrid(block.problem(), {1e-11, 200});
  solver->solve(u, block.body_load(uneven_load));
  iterations = solver->last_iterations();

  auto alone = options;
  alone.communicator = MPI_COMM_SELF;
  const Block reference(alone, test::clamped_below());
  auto v = fem::make_vector(reference.dofs());
  fem::make_factorisation(reference.problem())->solve(v, reference.body_load(uneven_load));
  const auto exact = reference.by_place(v);
  double difference = 0;
  for (const auto& [place, value] : block.by_place(u))
    difference = std::max(difference, std::abs(value - exact.at(place)));
  return dealii::Utilities::MPI::max(difference / v.linfty_norm(), MPI_COMM_WORLD);
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

TEST(AlgebraicMultigrid, CoarsensAMeshThatNobodyRefined) {
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
  const Block block({}, test::clamped_below());
  auto u = fem::make_vector(block.dofs());
  const auto solver = fem::make_algebraic_multigrid(block.problem(), {1e-12, 2});
  EXPECT_THROW(solver->solve(u, block.body_load(uneven_load)), contact::SolveError);
}

}  // namespace
}  // namespace rollfem

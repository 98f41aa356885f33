// SPDX-License-Identifier: LGPL-2.1-or-later
// Geometric and algebraic multigrid against a direct solver and a closed form; their convergence.
// The same program runs on one process and under mpirun.
#include "base/errors.hpp"
#include "fem/linear/algebraic_multigrid.hpp"
#include "fem/linear/factorisation.hpp"
#include "fem/linear/multigrid.hpp"

#include "support/fem_elastic_block.hpp"
#include "support/mpi_environment.hpp"

namespace {

using dealii::Point;
using dealii::Tensor;

double all_processes_max(double value) {
  return dealii::Utilities::MPI::max(value, MPI_COMM_WORLD);
}

Tensor<1, 3> uneven_load(const Point<3>& p) {
  Tensor<1, 3> f;
  f[0] = 10 * std::sin(2 * p[1]) + p[2];
  f[1] = 5 * p[0] - 3;
  f[2] = -20 * std::cos(p[0] + p[1]);
  return f;
}

/// Largest difference from the factorisation of the same body on this process alone, relative to
/// the largest displacement, of all processes.
using MakeSolver = std::function<std::unique_ptr<fem::LinearSolver>(const fem::ElasticProblem&)>;
double difference_from_factorisation(const BlockOptions& options, const MakeSolver& make,
                                     int* iterations = nullptr) {
  const Block block(options, clamped_below());
  auto u = fem::make_vector(block.dofs());
  const auto solver = make(block.problem());
  solver->solve(u, block.body_load(uneven_load));
  if (iterations != nullptr) *iterations = solver->last_iterations();

  auto alone = options;
  alone.communicator = MPI_COMM_SELF;
  const Block reference(alone, clamped_below());
  auto v = fem::make_vector(reference.dofs());
  fem::make_factorisation(reference.problem())->solve(v, reference.body_load(uneven_load));
  const auto exact = reference.by_place(v);
  double difference = 0;
  for (const auto& [place, value] : block.by_place(u))
    difference = std::max(difference, std::abs(value - exact.at(place)));
  return dealii::Utilities::MPI::max(difference / v.linfty_norm(), MPI_COMM_WORLD);
}

std::unique_ptr<fem::LinearSolver> geometric(const fem::ElasticProblem& problem) {
  return fem::make_multigrid(problem, {1e-11, 100});
}

std::unique_ptr<fem::LinearSolver> algebraic(const fem::ElasticProblem& problem) {
  return fem::make_algebraic_multigrid(problem, {1e-11, 200});
}

void expect_the_factorisation_with_hanging_nodes_and_symmetry_plane(const MakeSolver& make) {
  for (const unsigned int degree : {1U, 2U}) {
    BlockOptions options;
    options.degree = degree;
    options.bend = 0.15;
    EXPECT_LT(difference_from_factorisation(options, make), 1e-8) << "degree " << degree;
  }
}

TEST(Multigrid, EqualsTheFactorisationWithHangingNodesAndSymmetryPlane) {
  expect_the_factorisation_with_hanging_nodes_and_symmetry_plane(geometric);
}

TEST(AlgebraicMultigrid, EqualsTheFactorisationWithHangingNodesAndSymmetryPlane) {
  expect_the_factorisation_with_hanging_nodes_and_symmetry_plane(algebraic);
}

// Geometric multigrid would have to factorise this mesh whole.
TEST(AlgebraicMultigrid, CoarsensAnUnrefinedMesh) {
  BlockOptions options;
  options.cells = {9, 6, 6};
  options.bend = 0.1;
  options.global_refinements = options.local_refinements = 0;
  int iterations = 0;
  EXPECT_LT(difference_from_factorisation(options, algebraic, &iterations), 1e-8);
  EXPECT_LE(iterations, 60);
}

/// A body that turns about an axle along y above the block, as fast as 0.6 of the Rayleigh speed.
fem::MaterialMotion turning() {
  fem::MaterialMotion motion;
  motion.centre = Point<3>(1.5, 0, 12);
  motion.rotation[1] = 1.8e6 / 12;
  return motion;
}

// Assembly, and the kernel on every level, with every term that a cell can have.
TEST(Multigrid, EqualsTheFactorisationWithInertiaAndProjectedDilatation) {
  for (const unsigned int degree : {1U, 2U})
    for (const double poisson_ratio : {0.3, 0.48}) {
      BlockOptions options;
      options.degree = degree;
      options.bend = 0.15;
      options.local_refinements = 1;
      options.material.poisson_ratio = poisson_ratio;
      options.motion = turning();
      EXPECT_LT(difference_from_factorisation(options, geometric), 1e-8)
          << "degree " << degree << ", nu = " << poisson_ratio;
    }
}

TEST(Multigrid, RefusesNearlyIncompressibleBodies) {
  BlockOptions options;
  options.local_refinements = 0;
  options.material.poisson_ratio = 0.4999;
  const Block block(options, clamped_below());
  EXPECT_THROW(fem::make_multigrid(block.problem()), contact::InputError);
}

TEST(Multigrid, EqualsTheFactorisationOnStretchedCells) {
  BlockOptions options;
  options.cells = {4, 3, 3};
  options.size = {32, 3, 3};  // aspect 8
  options.local_refinements = 1;
  int iterations = 0;
  EXPECT_LT(difference_from_factorisation(options, geometric, &iterations), 1e-8);
  EXPECT_LE(iterations, 36) << "to 1e-11; 32 were measured";
}

TEST(Multigrid, SolvesAnUnrefinedMeshDirectly) {
  BlockOptions options;
  options.global_refinements = options.local_refinements = 0;
  int iterations = 0;
  EXPECT_LT(difference_from_factorisation(options, geometric, &iterations), 1e-8);
  EXPECT_LE(iterations, 3);
}

// A bar on rollers under uniform tension: u = (x, -nu y, -nu z) sigma / E, in the space of any
// degree whatever the shape of the cells.
TEST(Multigrid, PassesThePatchTestOnSkewCells) {
  for (const unsigned int degree : {1U, 2U}) {
    BlockOptions options;
    options.degree = degree;
    options.bend = 0.2;
    const Block block(options, {{}, {{0, 0}, {2, 1}, {4, 2}}});
    const double sigma = 100, nu = 0.3, e = 210e3;
    Tensor<1, 3> tension;
    tension[0] = sigma;
    auto u = fem::make_vector(block.dofs());
    fem::make_multigrid(block.problem(), {1e-12, 100})
        ->solve(u, block.face_load(1, [&](const Point<3>&) { return tension; }));
    double error = 0;
    block.for_each_dof([&](const Point<3>& p, unsigned int component, auto dof) {
      const double exact = sigma / e * p[component] * (component == 0 ? 1 : -nu);
      error = std::max(error, std::abs(u(dof) - exact));
    });
    EXPECT_LT(all_processes_max(error) / (sigma / e * 3), 1e-10) << "degree " << degree;
  }
}

TEST(Multigrid, NeedsNoMoreIterationsOnFinerMeshes) {
  std::vector<int> iterations;
  for (const int refinements : {1, 2, 3}) {
    BlockOptions options;
    options.global_refinements = refinements;
    const Block block(options, clamped_below());
    const auto solver = fem::make_multigrid(block.problem());
    auto u = fem::make_vector(block.dofs());
    solver->solve(u, block.body_load(uneven_load));
    iterations.push_back(solver->last_iterations());
  }
  EXPECT_LE(iterations.back(), 8) << "to 1e-8; 7, 7, 7 were measured";
  EXPECT_LE(iterations.back(), iterations.front() + 1);
}

// Betti: the work of one load on the displacement of another.
TEST(Multigrid, IsSymmetricToTheTolerance) {
  const Block block({}, clamped_below());
  const auto solver = fem::make_multigrid(block.problem(), {1e-12, 100});
  const auto a = block.body_load(uneven_load);
  Tensor<1, 3> pressure;
  pressure[2] = -7;
  const auto b = block.face_load(5, [&](const Point<3>& p) { return p[0] * pressure; });
  auto u = fem::make_vector(block.dofs()), v = u;
  solver->solve(u, a);
  solver->solve(v, b);
  EXPECT_NEAR(b * u, a * v, 1e-11 * std::abs(a * v));
}

TEST(Multigrid, IsDeterministicAndGivesZeroForNoLoad) {
  const Block block({}, clamped_below());
  const auto solver = fem::make_multigrid(block.problem());
  auto u = fem::make_vector(block.dofs()), v = u, zero = u;
  const auto load = block.body_load(uneven_load);
  solver->solve(u, load);
  const auto exactly = u;
  solver->solve(v, zero);
  EXPECT_EQ(v.linfty_norm(), 0);
  EXPECT_EQ(solver->last_iterations(), 0);
  solver->solve(u, load);  // what u held does not matter
  u -= exactly;
  EXPECT_EQ(u.linfty_norm(), 0);
}

TEST(Multigrid, SaysWhenItDoesNotConverge) {
  const Block block({}, clamped_below());
  auto u = fem::make_vector(block.dofs());
  const auto load = block.body_load(uneven_load);
  EXPECT_THROW(fem::make_multigrid(block.problem(), {1e-8, 2})->solve(u, load),
               contact::SolveError);
  EXPECT_THROW(fem::make_algebraic_multigrid(block.problem(), {1e-12, 2})->solve(u, load),
               contact::SolveError);
  auto broken = load;
  broken = std::nan("");
  EXPECT_THROW(fem::make_multigrid(block.problem())->solve(u, broken), contact::SolveError);
}

TEST(Multigrid, RejectsABodyThatNothingHoldsAndOtherElements) {
  BlockOptions options;
  options.local_refinements = 0;
  const Block loose(options, {});
  EXPECT_THROW(fem::make_multigrid(loose.problem()), contact::SolveError);
  options.degree = 3;
  const Block cubic(options, clamped_below());
  EXPECT_THROW(fem::make_multigrid(cubic.problem()), contact::InputError);
}

}  // namespace

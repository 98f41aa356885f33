// SPDX-License-Identifier: LGPL-2.1-or-later
// An iterative solver on any number of processes beside the factorisation of the same block on one.
#pragma once

#include "fem/linear/factorisation.hpp"

#include "support/fem_elastic_block.hpp"
#include "support/test.hpp"

namespace rollfem::testing {

inline dealii::Tensor<1, 3> uneven_load(const dealii::Point<3>& p) {
  dealii::Tensor<1, 3> f;
  f[0] = 10 * std::sin(2 * p[1]) + p[2];
  f[1] = 5 * p[0] - 3;
  f[2] = -20 * std::cos(p[0] + p[1]);
  return f;
}

/// Largest difference from the factorisation of the same body on this process alone, relative to
/// the largest displacement, of all processes. `make` gives a LinearSolver for an ElasticProblem.
template <class MakeSolver>
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

}  // namespace rollfem::testing

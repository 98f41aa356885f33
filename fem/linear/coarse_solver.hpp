// SPDX-License-Identifier: LGPL-2.1-or-later
// Direct solution on the coarsest level: its matrix is gathered and factorised on the first
// process, because iterations fail on the stretched cells of a graded coarse mesh.
#pragma once

#include "fem/discretisation/elasticity_operator.hpp"
#include "fem/linear/cholmod.hpp"

#include <cstddef>
#include <memory>
#include <mpi.h>
#include <vector>

namespace rollfem::fem {

class CoarseSolver {
 public:
  /// `entries`: contributions of this process to the lower triangle; `owned`: number of unknowns it
  /// owns, numbered consecutively over the processes. Collective. Throws contact::SolveError when
  /// the matrix is not positive definite (the body is not clamped) or memory runs out.
  CoarseSolver(const std::vector<MatrixEntry>& entries, std::size_t owned, MPI_Comm communicator);

  using VectorType = dealii::LinearAlgebra::distributed::Vector<float>;
  /// x = K^-1 b in owned entries, collective.
  void solve(VectorType& x, const VectorType& b) const;

 private:
  MPI_Comm communicator_;
  // On the first process only.
  std::unique_ptr<CholeskyFactor> factor_;
  std::vector<int> counts_, offsets_;  ///< ranges owned by the processes
  mutable std::vector<float> gathered_;
  mutable std::vector<double> right_;
};

}  // namespace rollfem::fem

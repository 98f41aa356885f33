// Direct solution on the coarsest level: its matrix is gathered and factorised on every process,
// because iterations fail on the stretched cells of a graded coarse mesh.
#pragma once

#include "fem/discretisation/elasticity_operator.hpp"
#include "fem/linear/cholmod.hpp"

#include <cstddef>
#include <mpi.h>
#include <vector>

namespace rollfem::fem {

class CoarseSolver {
 public:
  /// `entries`: what this process contributes to the lower triangle; `size`: global number of
  /// unknowns; `first`: the first one this process owns. Collective. Throws contact::SolveError
  /// when the matrix is not positive definite (nothing holds the body) or memory runs out.
  CoarseSolver(const std::vector<MatrixEntry>& entries, std::size_t size, std::size_t first,
               MPI_Comm communicator);

  using VectorType = dealii::LinearAlgebra::distributed::Vector<float>;
  /// x = K^-1 b in owned entries, collective.
  void solve(VectorType& x, const VectorType& b) const;
  double memory_bytes() const;

 private:
  CholeskyFactor factor_;
  mutable std::vector<double> right_;
  std::size_t first_;
  MPI_Comm communicator_;
};

}  // namespace rollfem::fem

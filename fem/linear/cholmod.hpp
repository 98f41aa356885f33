// SPDX-License-Identifier: LGPL-2.1-or-later
// Sparse Cholesky factors by CHOLMOD: supernodal, ordered by nested dissection of the nodes.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace rollfem::fem {

struct MatrixEntry;
struct SymmetricMatrix;

/// How failures are told: "WHAT failed: REASON; do: REMEDY".
struct FactorMessages {
  std::string what;
  std::string remedy;  ///< when the factor does not fit
};

class CholeskyFactor {
 public:
  /// Of a matrix whose unknowns are numbered in the order of elimination (order_for_elimination).
  /// Throws contact::SolveError when the matrix is not positive definite or memory runs out.
  CholeskyFactor(const SymmetricMatrix& matrix, FactorMessages messages);
  /// Of the entries of a lower triangle in any order; those of one place are added. The order of
  /// elimination is found here.
  CholeskyFactor(const std::vector<MatrixEntry>& entries, std::size_t size,
                 FactorMessages messages);
  ~CholeskyFactor();
  CholeskyFactor(const CholeskyFactor&) = delete;
  CholeskyFactor& operator=(const CholeskyFactor&) = delete;

  /// K^-1 b in a buffer of the factor, valid until the next call; of several right-hand sides, one
  /// after the other, at once. One call at a time.
  const double* solve(const std::vector<double>& b, std::size_t right_sides = 1) const;
  double memory_bytes() const;
  double operations() const;  ///< of floating point that the factor took

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
};

}  // namespace rollfem::fem

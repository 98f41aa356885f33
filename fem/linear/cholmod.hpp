// SPDX-License-Identifier: LGPL-2.1-or-later
// Sparse Cholesky factors by CHOLMOD: supernodal, ordered by nested dissection of the nodes.
#pragma once

#include "fem/linear/partial_factor.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace rollfem::fem {

struct MatrixEntry;
struct SymmetricMatrix;

/// Wording of failures: "WHAT failed: REASON; do: REMEDY".
struct FactorMessages {
  std::string what;
  std::string remedy;  ///< when the factor does not fit
};

class CholeskyFactor {
 public:
  /// Factorises a matrix whose unknowns are numbered in elimination order (order_for_elimination).
  /// Throws contact::SolveError when the matrix is not positive definite or memory runs out.
  CholeskyFactor(const SymmetricMatrix& matrix, FactorMessages messages);
  /// Factorises a lower triangle given by entries in any order; duplicates are added. Computes the
  /// elimination order.
  CholeskyFactor(const std::vector<MatrixEntry>& entries, std::size_t size,
                 FactorMessages messages);
  ~CholeskyFactor();
  CholeskyFactor(const CholeskyFactor&) = delete;
  CholeskyFactor& operator=(const CholeskyFactor&) = delete;

  /// b <- K^-1 b; solves several consecutive right-hand sides at once. Calls may run beside each
  /// other.
  void solve(std::vector<double>& b, std::size_t right_sides = 1) const;
  /// Of a factor by the first constructor.
  PartialFactor part(const std::vector<bool>& of_unknowns) const;
  double memory_bytes() const;
  double operations() const;  ///< floating-point operations of the factorisation

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
};

}  // namespace rollfem::fem

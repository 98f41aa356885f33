// SPDX-License-Identifier: LGPL-2.1-or-later
// Part of a sparse Cholesky factor in single precision, for many right-hand sides that are not zero
// at a few unknowns only, with solutions needed nowhere else. A solve with one right-hand side
// takes as long as reading the factor.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

struct cholmod_factor_struct;

namespace rollfem::fem {

class PartialFactor {
 public:
  /// The supernodes of a factor without permutation that these unknowns reach up the elimination
  /// tree.
  PartialFactor(const cholmod_factor_struct& factor, const std::vector<bool>& of_unknowns);
  /// b <- K^-1 b at the unknowns, where alone b may differ from 0 before; undefined at others.
  void solve(Eigen::VectorXf& b) const;
  double memory_bytes() const;

 private:
  struct Supernode {
    int first, columns, height;  ///< first column, and number of columns and rows
    std::size_t rows, values;  ///< where those of the rows below the triangle and the values begin
  };
  std::vector<Supernode> supernodes_;  ///< in order of elimination
  std::vector<int> rows_;
  std::vector<float> values_;  ///< of each supernode by columns, with zeros above the diagonal
};

}  // namespace rollfem::fem

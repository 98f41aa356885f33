// SPDX-License-Identifier: LGPL-2.1-or-later
// One level of geometric multigrid above the coarsest: its smoother and the transfer to the next
// coarser one. Single precision, it only preconditions.
#pragma once

#include "fem/discretisation/elasticity_operator.hpp"
#include "fem/linear/level_transfer.hpp"

#include <memory>

namespace rollfem::fem {

class MultigridLevel {
 public:
  /// Vectors of one solve.
  struct Work {
    FloatVector solution, right, product, before;
  };
  MultigridLevel(const LocalCells& cells, std::unique_ptr<LevelTransfer> to_coarser,
                 int smoother_degree);
  Work make_work() const;
  /// The Chebyshev iteration (Saad, Iterative Methods for Sparse Linear Systems, algorithm 12.1)
  /// towards K^-1 right for the eigenvalues of D^-1 K in the range of the smoother, `degree`
  /// products; from a solution of zero one of them is saved, and `solution` need not be set.
  void smooth(Work& at, bool from_zero) const;
  /// Sets the right-hand side of the next coarser level to the restricted residual.
  void restrict_residual(Work& at, FloatVector& coarser) const;
  void prolongate(Work& at, const FloatVector& correction) const {
    to_coarser_->prolongate_and_add(at.solution, correction);
  }

 private:
  void advance(Work& at, double along, double step) const;

  ElasticityOperator<float> stiffness_;
  std::unique_ptr<LevelTransfer> to_coarser_;
  FloatVector inverse_diagonal_;
  int degree_;
  double middle_ = 0.0, half_width_ = 0.0;  ///< of the range of eigenvalues
};

}  // namespace rollfem::fem

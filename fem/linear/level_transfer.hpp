// SPDX-License-Identifier: LGPL-2.1-or-later
// Transfer between two multigrid levels: displacements from coarse cells to the fine cells in them,
// forces in the reverse direction.
#pragma once

#include "fem/linear/linear_solver.hpp"

#include <memory>

namespace rollfem::fem {

using FloatVector = dealii::LinearAlgebra::distributed::Vector<float>;

class LevelTransfer {
 public:
  virtual ~LevelTransfer() = default;
  /// fine += P coarse: values at constrained unknowns of `coarse` are ignored, those of `fine`
  /// unchanged. Collective.
  virtual void prolongate_and_add(FloatVector& fine, const FloatVector& coarse) const = 0;
  /// coarse += P^T fine. Collective.
  virtual void restrict_and_add(FloatVector& coarse, const FloatVector& fine) const = 0;
};

/// The cells of `fine` are those of `coarse`, refined once or not at all, with any distribution
/// over the processes. Takes about ten bytes per unknown. Collective.
std::unique_ptr<LevelTransfer> make_level_transfer(const ElasticProblem& fine,
                                                   const ElasticProblem& coarse);

}  // namespace rollfem::fem

// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear elasticity K u = b on one body, solved many times with the same K. The interface of the
// solvers; factorisation.hpp and multigrid.hpp implement it.
#pragma once

#include "fem/discretisation/elastic_problem.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace rollfem::fem {

/// When an iterative solver ends.
struct IterationLimits {
  double tolerance = 1e-8;  ///< residual relative to the right-hand side
  int max_iterations = 500;
};

class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  /// u = K^-1 b, constraints distributed and ghosts updated on return. `b` need not respect the
  /// constraints (it is condensed here). Throws contact::SolveError when the residual stays above
  /// the solver's tolerance.
  virtual void solve(Vector& u, const Vector& b) const = 0;
  /// The same for several right-hand sides; a factorisation reads its factor only once.
  virtual void solve_all(std::vector<Vector>& u, const std::vector<Vector>& b) const {
    for (std::size_t k = 0; k < b.size(); ++k) solve(u[k], b[k]);
  }
  /// A faster solver in single precision, for right-hand sides that are 0 at all but these unknowns
  /// (in increasing order), with solutions that are undefined at all others; null: there is none.
  /// It must not outlive this one.
  virtual std::unique_ptr<LinearSolver> in_part(
      const std::vector<dealii::types::global_dof_index>& /*unknowns*/) const {
    return nullptr;
  }
  virtual int last_iterations() const = 0;  ///< 0 for a factorisation
  virtual std::string description() const = 0;
  /// Whether a solve may run in parallel with a solve of another solver.
  virtual bool runs_beside_others() const { return false; }
};

}  // namespace rollfem::fem

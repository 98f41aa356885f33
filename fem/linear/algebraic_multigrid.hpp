// SPDX-License-Identifier: LGPL-2.1-or-later
// Conjugate gradients with algebraic multigrid (Trilinos ML, smoothed aggregation) on the assembled
// stiffness: for imported meshes whose coarsest level is too large for the direct solution used by
// geometric multigrid.
#pragma once

#include "fem/linear/linear_solver.hpp"

namespace rollfem::fem {

/// Any number of MPI processes; collective. Throws contact::SolveError when memory runs out.
std::unique_ptr<LinearSolver> make_algebraic_multigrid(const ElasticProblem& problem,
                                                       const IterationLimits& limits = {});

}  // namespace rollfem::fem

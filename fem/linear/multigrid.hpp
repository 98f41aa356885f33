// SPDX-License-Identifier: LGPL-2.1-or-later
// Conjugate gradients with matrix-free geometric multigrid (global coarsening, Chebyshev smoothing,
// direct coarse solve): for bodies too large for a factorisation and for several processes.
#pragma once

#include "fem/linear/linear_solver.hpp"

namespace rollfem::fem {

/// Larger Poisson's ratios are rejected: point smoothing fails on the nearly singular volumetric
/// part, and iterations grow without bound.
inline constexpr double largest_multigrid_poisson_ratio = 0.49;

/// Any number of MPI processes; collective. Throws contact::InputError above that Poisson's ratio.
std::unique_ptr<LinearSolver> make_multigrid(const ElasticProblem& problem,
                                             const IterationLimits& limits = {});

}  // namespace rollfem::fem

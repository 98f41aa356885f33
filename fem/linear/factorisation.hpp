// SPDX-License-Identifier: LGPL-2.1-or-later
// Sparse Cholesky factorisation (CHOLMOD, supernodal, nested dissection) of
// the assembled stiffness: the fastest solver up to some 400 000 unknowns
// when one geometry serves many right-hand sides.
#pragma once

#include "fem/linear/linear_solver.hpp"

namespace rollfem::fem {

/// A mirror-symmetric body is factorised in the halves of mirrored_halves.hpp. One process only.
/// Throws contact::SolveError when the matrix is not positive definite or memory runs out.
std::unique_ptr<LinearSolver> make_factorisation(const ElasticProblem& problem);

/// Rough prediction of the factor's memory for this many unknowns in 3D Q2, bytes.
double predicted_factor_bytes(double unknowns);

}  // namespace rollfem::fem

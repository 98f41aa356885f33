// SPDX-License-Identifier: LGPL-2.1-or-later
// A displacement prescribed on the far boundary, for a solver whose own conditions are homogeneous.
#pragma once

#include "fem/linear/linear_solver.hpp"

#include <deal.II/base/point.h>

#include <functional>
#include <vector>

namespace rollfem::fem {

/// A displacement given by the place (mm), at every node. Ghost values are set. Collective.
Vector nodal_values(
    const ElasticProblem& problem,
    const std::function<dealii::Tensor<1, 3>(const dealii::Point<3>&)>& displacement);

/// K u, N, cell by cell, so that every term of K is in it and prescribed nodes count; constraints
/// ignored. `u` with ghost values. Collective.
Vector internal_forces(const ElasticProblem& problem, const Vector& u);

/// Of several displacements, solved together: the solution under `load` (null: none) that keeps the
/// values of `prescribed` where the solver's conditions would have zeros, g + K^-1 (b - K g).
/// Hanging nodes of `prescribed` are first put in line with their neighbours. `solver` is that of
/// `problem`. Ghost values are set. Collective. Throws what the solver throws.
std::vector<Vector> solve_with_prescribed(const ElasticProblem& problem, const LinearSolver& solver,
                                          const std::vector<Vector>& prescribed,
                                          const Vector* load = nullptr);

}  // namespace rollfem::fem

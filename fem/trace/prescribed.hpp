// SPDX-License-Identifier: LGPL-2.1-or-later
// A displacement prescribed on the far boundary, for a solver whose own conditions are homogeneous.
#pragma once

#include "fem/linear/linear_solver.hpp"

#include <deal.II/base/point.h>

#include <functional>
#include <vector>

namespace rollfem::fem {

/// A displacement given as a function of position (mm), at every node. Ghost values are set.
/// Collective.
Vector nodal_values(
    const ElasticProblem& problem,
    const std::function<dealii::Tensor<1, 3>(const dealii::Point<3>&)>& displacement);

/// K u, N, cell by cell, including every term of K and prescribed nodes; constraints are ignored.
/// `u` with ghost values. Collective.
Vector internal_forces(const ElasticProblem& problem, const Vector& u);

/// For several displacements, solved together: the solution under `load` (null: none) with the
/// values of `prescribed` where the solver's conditions would be zero, g + K^-1 (b - K g). Hanging
/// nodes of `prescribed` are first made consistent with their neighbours. `solver`: solver of
/// `problem`. Ghost values are set. Collective. Throws like the solver.
std::vector<Vector> solve_with_prescribed(const ElasticProblem& problem, const LinearSolver& solver,
                                          const std::vector<Vector>& prescribed,
                                          const Vector* load = nullptr);

}  // namespace rollfem::fem

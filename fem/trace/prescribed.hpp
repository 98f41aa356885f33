// SPDX-License-Identifier: LGPL-2.1-or-later
// A displacement prescribed on the far boundary, for a solver whose own conditions are homogeneous.
#pragma once

#include "fem/linear/linear_solver.hpp"

#include <deal.II/base/function.h>
#include <deal.II/base/point.h>

#include <functional>
#include <utility>
#include <vector>

namespace rollfem::fem {

/// A vector given as a function of position (mm), as deal.II takes it.
class VectorField : public dealii::Function<3> {
 public:
  using Values = std::function<dealii::Tensor<1, 3>(const dealii::Point<3>&)>;
  explicit VectorField(Values values) : Function(3), values_(std::move(values)) {}
  double value(const dealii::Point<3>& place, unsigned int component) const override {
    return values_(place)[component];
  }

 private:
  Values values_;
};

/// A displacement given as a function of position (mm), at every node. Ghost values are set.
/// Collective.
Vector nodal_values(const ElasticProblem& problem, const VectorField::Values& displacement);

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

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/trace/prescribed.hpp"

#include "fem/discretisation/elasticity_assembly.hpp"

#include <algorithm>
#include <vector>

namespace rollfem::fem {

Vector nodal_values(
    const ElasticProblem& problem,
    const std::function<dealii::Tensor<1, 3>(const dealii::Point<3>&)>& displacement) {
  Vector nodal = make_vector(problem.dofs);
  const auto& element = problem.dofs.get_fe();
  const auto& owned = problem.dofs.locally_owned_dofs();
  std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);
  for (const auto& cell : problem.dofs.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    cell->get_dof_indices(indices);
    for (unsigned int i = 0; i < indices.size(); ++i) {
      if (!owned.is_element(indices[i])) continue;
      const auto place =
          problem.mapping.transform_unit_to_real_cell(cell, element.unit_support_point(i));
      nodal(indices[i]) = displacement(place)[element.system_to_component_index(i).first];
    }
  }
  nodal.update_ghost_values();
  return nodal;
}

Vector internal_forces(const ElasticProblem& problem, const Vector& u) {
  Vector forces = make_vector(problem.dofs);
  CellStiffness stiffness(problem);
  std::vector<dealii::types::global_dof_index> indices(problem.dofs.get_fe().dofs_per_cell);
  std::vector<double> values(indices.size());
  for (const auto& cell : problem.dofs.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    cell->get_dof_indices(indices);
    for (std::size_t i = 0; i < indices.size(); ++i) values[i] = u(indices[i]);
    if (std::all_of(values.begin(), values.end(), [](double value) { return value == 0.0; }))
      continue;
    const auto& matrix = stiffness.compute(cell);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < indices.size(); ++j)
        sum += matrix[i * indices.size() + j] * values[j];
      forces(indices[i]) += sum;
    }
  }
  forces.compress(dealii::VectorOperation::add);
  return forces;
}

std::vector<Vector> solve_with_prescribed(const ElasticProblem& problem, const LinearSolver& solver,
                                          const std::vector<Vector>& prescribed,
                                          const Vector* load) {
  const auto hanging = make_constraints(problem.dofs, problem.mapping, {});
  std::vector<Vector> results, lacks;
  for (const Vector& given : prescribed) {
    Vector& in_line = results.emplace_back(make_vector(problem.dofs));
    in_line.copy_locally_owned_data_from(given);
    hanging.distribute(in_line);
    in_line.update_ghost_values();
    lacks.push_back(internal_forces(problem, in_line));
    lacks.back() *= -1.0;
    if (load != nullptr) lacks.back() += *load;
  }
  std::vector<Vector> corrections(prescribed.size(), make_vector(problem.dofs));
  solver.solve_all(corrections, lacks);
  for (std::size_t k = 0; k < results.size(); ++k) {
    results[k] += corrections[k];
    results[k].update_ghost_values();
  }
  return results;
}

}  // namespace rollfem::fem

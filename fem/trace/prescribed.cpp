// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/trace/prescribed.hpp"

#include "fem/discretisation/elasticity_assembly.hpp"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

namespace rollfem::fem {

Vector nodal_values(const ElasticProblem& problem, const VectorField::Values& displacement) {
  Vector nodal = make_vector(problem.dofs);
  dealii::VectorTools::interpolate(problem.mapping, problem.dofs, VectorField(displacement), nodal);
  nodal.update_ghost_values();
  return nodal;
}

Vector internal_forces(const ElasticProblem& problem, const Vector& u) {
  Vector forces = make_vector(problem.dofs);
  CellStiffness stiffness(problem);
  const unsigned int n = problem.dofs.get_fe().dofs_per_cell;
  dealii::FullMatrix<double> matrix(n, n);
  dealii::Vector<double> values(n), product(n);
  for (const auto& cell : problem.dofs.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    cell->get_dof_values(u, values);
    if (values.all_zero()) continue;
    matrix.fill(stiffness.compute(cell).data());
    matrix.vmult(product, values);
    cell->distribute_local_to_global(product, forces);
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

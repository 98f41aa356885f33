// SPDX-License-Identifier: LGPL-2.1-or-later
// Loads of given stresses and errors of displacements, by quadrature over the cells of this
// process.
#pragma once

#include "fem/discretisation/elastic_problem.hpp"
#include "fem/linear/linear_solver.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include "support/test.hpp"

namespace rollfem::testing {

/// Hooke's law.
inline dealii::Tensor<2, 3> stress_of(const dealii::Tensor<2, 3>& gradient,
                                      const contact::Material& material) {
  const double nu = material.poisson_ratio;
  const double mu = material.young_modulus / (2 * (1 + nu));
  dealii::Tensor<2, 3> stress = mu * (gradient + transpose(gradient));
  for (unsigned int d = 0; d < 3; ++d) stress[d][d] += 2 * mu * nu / (1 - 2 * nu) * trace(gradient);
  return stress;
}

using fem::components_of;

/// Calls f(cell, values) with values, gradients, places and weights at Gauss points.
template <class F>
void for_each_cell(const fem::ElasticProblem& problem, unsigned int points, const F& f) {
  dealii::FEValues<3> values(problem.mapping, problem.dofs.get_fe(), dealii::QGauss<3>(points),
                             dealii::update_values | dealii::update_gradients |
                                 dealii::update_quadrature_points | dealii::update_JxW_values);
  for (const auto& cell : problem.dofs.active_cell_iterators())
    if (cell->is_locally_owned()) {
      values.reinit(cell);
      f(cell, values);
    }
}

/// int sigma : grad N of the stress at every place, so that surface tractions need not be written
/// down.
template <class Stress>
fem::Vector load_of_stress(const fem::ElasticProblem& problem, const Stress& stress) {
  const auto& element = problem.dofs.get_fe();
  auto b = fem::make_vector(problem.dofs);
  b.zero_out_ghost_values();
  std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);
  for_each_cell(problem, element.degree + 3, [&](const auto& cell, const auto& values) {
    cell->get_dof_indices(indices);
    for (const unsigned int q : values.quadrature_point_indices()) {
      const dealii::Tensor<2, 3> weighted = values.JxW(q) * stress(values.quadrature_point(q));
      for (unsigned int i = 0; i < indices.size(); ++i)
        b(indices[i]) +=
            weighted[element.system_to_component_index(i).first] * values.shape_grad(i, q);
    }
  });
  b.compress(dealii::VectorOperation::add);
  return b;
}

/// L2 error relative to the exact displacement at every place.
template <class Exact>
double displacement_error(const fem::ElasticProblem& problem, const fem::Vector& u,
                          const Exact& exact) {
  double difference = 0, size = 0;
  std::vector<dealii::Tensor<1, 3>> computed;
  for_each_cell(problem, problem.dofs.get_fe().degree + 2, [&](const auto&, const auto& values) {
    computed.resize(values.n_quadrature_points);
    values[dealii::FEValuesExtractors::Vector(0)].get_function_values(u, computed);
    for (const unsigned int q : values.quadrature_point_indices()) {
      const dealii::Tensor<1, 3> wanted = exact(values.quadrature_point(q));
      difference += (computed[q] - wanted).norm_square() * values.JxW(q);
      size += wanted.norm_square() * values.JxW(q);
    }
  });
  return std::sqrt(difference / size);
}

}  // namespace rollfem::testing

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/stress/energy_error.hpp"

#include "fem/discretisation/cell_terms.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>

namespace rollfem::fem {

namespace {

using Stress = std::array<double, 6>;

/// sigma : C^-1 : sigma, N/mm^2.
double energy_density(const contact::Material& material, const Stress& s) {
  const double trace = s[0] + s[1] + s[2];
  const double square =
      s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + 2 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
  const double nu = material.poisson_ratio;
  return ((1 + nu) * square - nu * trace * trace) / material.young_modulus;
}

}  // namespace

EnergyError energy_error(const Body& body, const Vector& displacement, const NodalStress& stress) {
  const auto& element = body.dofs().get_fe();
  dealii::FEValues<3> values(body.mapping(), element, dealii::QGauss<3>(element.degree + 1),
                             dealii::update_values | dealii::update_gradients |
                                 dealii::update_quadrature_points | dealii::update_JxW_values);
  const dealii::FEValuesExtractors::Vector vector(0);
  const unsigned int points = values.n_quadrature_points;
  std::vector<dealii::Tensor<2, 3>> gradients(points);
  std::vector<dealii::Tensor<1, 3>> direct(points), shear(points);
  Vector ghosted(displacement);  // copies lack ghost values
  ghosted.update_ghost_values();
  CellStress law(body.problem());
  double error = 0, energy = 0;
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    values.reinit(cell);
    law.reinit(cell, ghosted);
    values[vector].get_function_gradients(ghosted, gradients);
    values[vector].get_function_values(stress.direct, direct);
    values[vector].get_function_values(stress.shear, shear);
    for (unsigned int q = 0; q < points; ++q) {
      const Stress own = law.at(gradients[q], values.quadrature_point(q));
      Stress difference{};
      for (unsigned int c = 0; c < 3; ++c) {
        difference[c] = direct[q][c] - own[c];
        difference[3 + c] = shear[q][c] - own[3 + c];
      }
      error += energy_density(body.material(), difference) * values.JxW(q);
      energy += energy_density(body.material(), own) * values.JxW(q);
    }
  }
  const MPI_Comm communicator = body.dofs().get_communicator();
  return {std::sqrt(dealii::Utilities::MPI::sum(error, communicator)),
          std::sqrt(dealii::Utilities::MPI::sum(energy, communicator))};
}

}  // namespace rollfem::fem

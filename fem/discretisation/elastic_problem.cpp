// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/discretisation/elastic_problem.hpp"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/component_mask.h>
#include <deal.II/fe/fe.h>
#include <deal.II/numerics/vector_tools_boundary.h>

namespace rollfem::fem {

dealii::IndexSet relevant_dofs(const dealii::DoFHandler<3>& dofs) {
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(dofs, relevant);
  return relevant;
}

dealii::AffineConstraints<double> make_constraints(const dealii::DoFHandler<3>& dofs,
                                                   const dealii::Mapping<3>& mapping,
                                                   const BoundaryConditions& boundary) {
  dealii::AffineConstraints<double> constraints(relevant_dofs(dofs));
  dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);
  const dealii::Functions::ZeroFunction<3> zero(3);
  for (const auto id : boundary.clamped)
    dealii::VectorTools::interpolate_boundary_values(mapping, dofs, id, zero, constraints);
  for (const auto& [id, component] : boundary.vanishing_component) {
    dealii::ComponentMask mask(3, false);
    mask.set(component, true);
    dealii::VectorTools::interpolate_boundary_values(mapping, dofs, id, zero, constraints, mask);
  }
  constraints.close();
  return constraints;
}

Vector make_vector(const dealii::DoFHandler<3>& dofs) {
  return Vector(dofs.locally_owned_dofs(), relevant_dofs(dofs), dofs.get_communicator());
}

}  // namespace rollfem::fem

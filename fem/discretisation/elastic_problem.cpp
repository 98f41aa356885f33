// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/discretisation/elastic_problem.hpp"

#include "fem/mesh/surface_shape.hpp"

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

MaterialMotion material_motion(const SurfaceShape& shape, double speed) {
  MaterialMotion motion;
  if (!shape.is_revolved()) {
    motion.velocity[0] = -speed;
    return motion;
  }
  const meshes::AxleTrace axle = shape.axle();
  const double rotation = speed / shape.rolling_radius;
  motion.centre = {0, 0, axle.height};
  motion.rotation = dealii::Tensor<1, 3>({0, rotation * axle.cosine, rotation * axle.sine});
  return motion;
}

}  // namespace rollfem::fem

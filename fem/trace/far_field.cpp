// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/trace/far_field.hpp"

#include "contact/scene/geometry.hpp"
#include "fem/trace/prescribed.hpp"
#include "halfspace/closed_forms/point_loads.hpp"

#include <deal.II/numerics/vector_tools_boundary.h>

#include <algorithm>
#include <map>

namespace rollfem::fem {

namespace {

/// The point load's displacement at the nodes of the far boundary, zero elsewhere.
Vector values_on_far_boundary(const Body& body, unsigned int axis) {
  const VectorField displacement([&](const dealii::Point<3>& place) {
    return point_load_displacement(body.shape(), body.material(), axis, place);
  });
  std::map<dealii::types::global_dof_index, double> values;
  dealii::VectorTools::interpolate_boundary_values(body.mapping(), body.dofs(), far_boundary,
                                                   displacement, values);
  Vector nodal = make_vector(body.dofs());
  for (const auto& [dof, value] : values)
    if (nodal.in_local_range(dof)) nodal(dof) = value;
  return nodal;
}

}  // namespace

dealii::Tensor<1, 3> point_load_displacement(const SurfaceShape& shape,
                                             const contact::Material& material, unsigned int axis,
                                             const dealii::Point<3>& place) {
  const halfspace::ElasticHalfspace body{contact::shear_modulus(material), material.poisson_ratio};
  // In the closed forms z points into the body; for the rail this reverses the z axis.
  const double inwards = shape.is_wheel ? 1.0 : -1.0;
  const halfspace::Position at{place[0], place[1], std::max(0.0, inwards * place[2])};
  halfspace::Displacement u{};
  if (axis == 0) {
    u = halfspace::cerruti_displacement(body, 1.0, at);
  } else if (axis == 1) {
    const auto turned = halfspace::cerruti_displacement(body, 1.0, {at.y, at.x, at.z});
    u = {turned[1], turned[0], turned[2]};
  } else {
    u = halfspace::boussinesq_displacement(body, inwards, at);
  }
  dealii::Tensor<1, 3> result;
  result[0] = u[0];
  result[1] = u[1];
  result[2] = inwards * u[2];
  return result;
}

std::array<double, 3> resultant_force(const contact::PatchShape& shape,
                                      const contact::ContactGrid& grid,
                                      const contact::SurfaceField& traction) {
  const double area = grid.element_area();
  return {area * traction.x.dot(shape.stretch),
          area * (traction.y - shape.climb.cwiseProduct(traction.n)).sum(),
          area * (traction.n + shape.climb.cwiseProduct(traction.y)).sum()};
}

FarField::FarField(const Body& body, const LinearSolver& solver, const SurfaceCoupling& coupling) {
  std::vector<unsigned int> axes{0, 1, 2};
  // The symmetric part of a load has no force along y.
  if (body.options().half) axes = {0, 2};
  std::vector<Vector> prescribed;
  for (const unsigned int axis : axes) prescribed.push_back(values_on_far_boundary(body, axis));
  std::vector<Vector> solutions = solve_with_prescribed(body.problem(), solver, prescribed);
  fields_.fill(make_vector(body.dofs()));
  for (std::size_t k = 0; k < axes.size(); ++k) fields_[axes[k]].swap(solutions[k]);
  for (unsigned int axis = 0; axis < 3; ++axis) {
    fields_[axis].update_ghost_values();
    sampled_[axis] = coupling.sample(fields_[axis]);
  }
}

void FarField::add(const std::array<double, 3>& force, contact::SurfaceField& displacement) const {
  for (unsigned int axis = 0; axis < 3; ++axis) {
    displacement.x += force[axis] * sampled_[axis].x;
    displacement.y += force[axis] * sampled_[axis].y;
    displacement.n += force[axis] * sampled_[axis].n;
  }
}

void FarField::add(const std::array<double, 3>& force, Vector& displacement) const {
  for (unsigned int axis = 0; axis < 3; ++axis)
    if (force[axis] != 0.0) displacement.add(force[axis], fields_[axis]);
  displacement.update_ghost_values();
}

}  // namespace rollfem::fem

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/trace/rolling_inertia.hpp"

#include "contact/scene/geometry.hpp"
#include "fem/trace/compliance.hpp"
#include "fem/trace/prescribed.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <utility>

namespace rollfem::fem {

namespace {

/// Calls f(unknowns, values at the quadrature points) for every cell of this process.
template <class F>
void for_each_cell(const ElasticProblem& problem, const F& f) {
  const auto& element = problem.dofs.get_fe();
  dealii::FEValues<3> values(
      problem.mapping, element, dealii::QGauss<3>(element.degree + 1),
      dealii::update_values | dealii::update_quadrature_points | dealii::update_JxW_values);
  std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);
  for (const auto& cell : problem.dofs.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    values.reinit(cell);
    cell->get_dof_indices(indices);
    f(indices, values);
  }
}

}  // namespace

Vector centrifugal_load(const ElasticProblem& problem) {
  Vector load = make_vector(problem.dofs);
  const auto& motion = problem.motion;
  const auto& element = problem.dofs.get_fe();
  for_each_cell(problem, [&](const auto& indices, const auto& values) {
    for (const auto q : values.quadrature_point_indices()) {
      // (v.grad)v = rotation x v, which does not include translation along the axle.
      const auto force =
          -problem.material.density * values.JxW(q) *
          dealii::cross_product_3d(motion.rotation, motion.at(values.quadrature_point(q)));
      for (unsigned int i = 0; i < indices.size(); ++i)
        load(indices[i]) +=
            force[element.system_to_component_index(i).first] * values.shape_value(i, q);
    }
  });
  load.compress(dealii::VectorOperation::add);
  return load;
}

dealii::Tensor<1, 3> spinning_disc_displacement(const contact::Material& material,
                                                const MaterialMotion& motion, double outer_radius,
                                                const dealii::Point<3>& place) {
  const double nu = material.poisson_ratio, R = outer_radius;
  const double pull = material.density * motion.rotation.norm_square();
  const double omega = motion.rotation.norm();
  dealii::Tensor<1, 3> displacement;
  if (omega == 0) return displacement;
  const auto axle = motion.rotation / omega;
  const auto from_centre = place - motion.centre;
  const double along = from_centre * axle;
  const auto radial = from_centre - along * axle;
  const double r2 = radial.norm_square(), a2 = along * along;
  displacement = pull / (8 * material.young_modulus) *
                 ((1 - nu) * ((3 + nu) * R * R - (1 + nu) * r2) - 4 * nu * (1 + nu) * a2) * radial;
  const double contraction =
      (3 + nu) * R * R - 2 * (1 + nu) * r2 - 4 * nu * (1 + nu) / (3 * (1 - nu)) * a2;
  displacement -= nu * pull / (4 * material.young_modulus) * contraction * along * axle;
  return displacement;
}

Vector spinning_displacement(const Body& wheel, const LinearSolver& solver) {
  const ElasticProblem problem = wheel.problem();
  const auto on_disc = [&](const dealii::Point<3>& place) {
    return spinning_disc_displacement(problem.material, problem.motion,
                                      wheel.shape().rolling_radius, place);
  };
  const Vector load = centrifugal_load(problem);
  return std::move(
      solve_with_prescribed(problem, solver, {nodal_values(problem, on_disc)}, &load).front());
}

WheelExpansion wheel_expansion(const Body& wheel, const LinearSolver& solver,
                               const contact::ContactSurface& surface,
                               const contact::ContactGrid& grid, contact::UpwindOrder order) {
  WheelExpansion expansion;
  expansion.displacement = spinning_displacement(wheel, solver);
  const auto u = SurfaceCoupling(wheel, grid, surface).sample(expansion.displacement);
  expansion.distance = u.n;
  expansion.slip = contact::upwind_difference(grid, {u.x, u.y}, order);
  const auto turning = contact::CurvatureSlip(surface, grid)(u);
  expansion.slip.x += turning.x;
  expansion.slip.y += turning.y;
  return expansion;
}

}  // namespace rollfem::fem

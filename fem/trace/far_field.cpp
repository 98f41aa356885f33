// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/trace/far_field.hpp"

#include "base/pi.hpp"
#include "fem/discretisation/elasticity_assembly.hpp"
#include "fem/mesh/run_layout.hpp"
#include "halfspace/closed_forms/point_loads.hpp"
#include "scene/geometry.hpp"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/vector_tools_boundary.h>
#include <deal.II/numerics/vector_tools_interpolate.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rollfem::fem {

Vector nodal_values(const ElasticProblem& problem, const VectorField::Values& displacement) {
  Vector nodal = make_vector(problem.dofs);
  dealii::VectorTools::interpolate(problem.mapping, problem.dofs, VectorField(displacement), nodal);
  nodal.update_ghost_values();
  return nodal;
}

namespace {

/// K u, N, cell by cell, including every term of K and prescribed nodes; constraints are ignored.
/// `u` with ghost values. Collective.
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

}  // namespace

std::vector<Vector> solve_with_prescribed(const ElasticProblem& problem, const LinearSolver& solver,
                                          const std::vector<Vector>& prescribed,
                                          const Vector* load) {
  const auto hanging = make_constraints(problem.dofs, problem.mapping, {});
  std::vector<Vector> results, residuals;
  for (const Vector& given : prescribed) {
    Vector& consistent = results.emplace_back(make_vector(problem.dofs));
    consistent.copy_locally_owned_data_from(given);
    hanging.distribute(consistent);
    consistent.update_ghost_values();
    residuals.push_back(internal_forces(problem, consistent));
    residuals.back() *= -1.0;
    if (load != nullptr) residuals.back() += *load;
  }
  std::vector<Vector> corrections(prescribed.size(), make_vector(problem.dofs));
  solver.solve_all(corrections, residuals);
  for (std::size_t k = 0; k < results.size(); ++k) {
    results[k] += corrections[k];
    results[k].update_ghost_values();
  }
  return results;
}

namespace {

using contact::pi;

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

/// Displacement of a half-space on the axis under a point load, at depth L (Boussinesq: P (3 - 2
/// nu) / (4 pi G L)), mm; the surface moves less at that distance.
double displacement_at(const contact::Material& material, double force, double distance) {
  return force * (3.0 - 2.0 * material.poisson_ratio) /
         (4.0 * pi * contact::shear_modulus(material) * distance);
}

/// Slope at which the circle of a profile ends; 1 for the default of 44.4 degrees.
double steepest_slope(double round_to) {
  return std::max(1.0, round_to / std::sqrt(1.0 - round_to * round_to));
}

/// Change of a half-space's displacement beyond `extent` by a surface of this curvature (1/mm, sum
/// of both directions) with the last profile slope `steepest`: first order by the strain energy
/// along the surface, which is small, and second order in the slope L kappa / 4.
double curvature_error(const contact::Material& material, double force, double extent,
                       double curvature, double steepest) {
  const double kappa = std::abs(curvature);
  if (kappa == 0.0) return 0.0;
  const double free_strain = 1.0 - 2.0 * material.poisson_ratio;
  const double first = force * free_strain * free_strain * kappa /
                       (8.0 * pi * contact::shear_modulus(material)) *
                       std::log1p(1.0 / (kappa * extent));
  // Profiles continue along their steepest tangent in one of two directions.
  const double slope = std::min(0.25 * kappa * extent, 0.5 * steepest);
  return first + slope * slope * displacement_at(material, force, extent);
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

FarBoundary far_boundary_of(const contact::Scene& scene) {
  const bool given_mesh =
      has_true_sections(scene) || !scene.wheel.mesh.empty() || !scene.rail.mesh.empty();
  return options_of(scene).far_boundary.value_or(given_mesh ? FarBoundary::clamped
                                                            : FarBoundary::point_load);
}

double approach_left_out(const contact::Scene& scene, double normal_force, double extent) {
  const double spread = PatchSearch(scene).box().larger() / extent;
  const auto of_body = [&](const contact::Material& material, double curvature, double round_to) {
    const double clamped = displacement_at(material, normal_force, extent);
    if (far_boundary_of(scene) == FarBoundary::clamped) return clamped;
    // <x^2> = a^2/5 in Hertz's ellipse of pressure.
    return std::min(clamped, 0.2 * spread * spread * clamped +
                                 curvature_error(material, normal_force, extent, curvature,
                                                 steepest_slope(round_to)));
  };
  const contact::ContactSurface& surface = scene.geometry.surface;
  if (scene.has_profiles())
    return of_body(scene.wheel.material,
                   1.0 / surface.profiles->local_rolling_radius(0.0) +
                       std::abs(surface.profiles->wheel().at(0.0).second),
                   contact::usual_round_to) +
           of_body(scene.rail.material,
                   1.0 / std::abs(surface.local_rail_radius(0.0)) +
                       surface.profiles->rail().at(0.0).second,
                   contact::usual_round_to);
  return of_body(scene.wheel.material,
                 1.0 / surface.rolling_radius + 1.0 / surface.wheel_transverse_radius,
                 surface.wheel_round_to) +
         of_body(scene.rail.material,
                 1.0 / surface.rail_rolling_radius + 1.0 / surface.rail_transverse_radius,
                 surface.rail_round_to);
}

std::string far_boundary_note(const contact::Scene& scene, double extent) {
  if (far_boundary_of(scene) == FarBoundary::clamped)
    return fmt::format(
        "wheel and rail segments extend {:.4g} mm from the patch and are clamped there: the "
        "approach is that of these segments; its error estimate includes the possible increase for "
        "large bodies",
        extent);
  return fmt::format(
      "wheel and rail segments extend {:.4g} mm from the patch and move there like half-spaces "
      "under the force on it: the approach is that of large bodies, within its error estimate",
      extent);
}

}  // namespace rollfem::fem

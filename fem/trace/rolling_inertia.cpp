// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/trace/rolling_inertia.hpp"

#include "fem/trace/far_field.hpp"
#include "scene/geometry.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/vector_tools_rhs.h>

#include <cmath>
#include <utility>

namespace rollfem::fem {

Vector centrifugal_load(const ElasticProblem& problem) {
  const VectorField force([&](const dealii::Point<3>& place) {
    // (v.grad)v = rotation x v, which does not include translation along the axle.
    return -problem.material.density *
           dealii::cross_product_3d(problem.motion.rotation, problem.motion.at(place));
  });
  Vector load = make_vector(problem.dofs);
  dealii::VectorTools::create_right_hand_side(problem.mapping, problem.dofs,
                                              dealii::QGauss<3>(problem.dofs.get_fe().degree + 1),
                                              force, load);
  return load;
}

namespace {

/// Displacement of a free disc rotating with this motion, in equilibrium everywhere: in its middle
/// plane (y = 0) that of plane stress, u_r = rho omega^2 (1 - nu) ((3 + nu) R^2 r - (1 + nu)
/// r^3)/(8 E), plus -rho omega^2 nu (1 + nu) y^2 r / (2 E) outside it; along the axle -nu/E times
/// the integral of sigma_r + sigma_theta (Timoshenko and Goodier, Theory of Elasticity, the
/// rotating disk as a three-dimensional problem).
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

}  // namespace

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

// SPDX-License-Identifier: LGPL-2.1-or-later
// Inertia of steady rolling: the flow of material of wheel and rail through the contact's frame,
// and the effect of spinning on the wheel. Derivation: docs/theory.md, "Inertia".
#pragma once

#include "fem/discretisation/body.hpp"
#include "fem/linear/linear_solver.hpp"
#include "scene/contact_surface.hpp"

namespace rollfem::fem {

/// int rho (-(v.grad)v) . N: the centrifugal load of rotating material, N. Constraints are ignored.
Vector centrifugal_load(const ElasticProblem& problem);

/// Displacement of a free disc rotating with this motion, in equilibrium everywhere: in its middle
/// plane (y = 0) that of plane stress, u_r = rho omega^2 (1 - nu) ((3 + nu) R^2 r - (1 + nu)
/// r^3)/(8 E), plus -rho omega^2 nu (1 + nu) y^2 r / (2 E) outside it; along the axle -nu/E times
/// the integral of sigma_r + sigma_theta (Timoshenko and Goodier, Theory of Elasticity, the
/// rotating disk as a three-dimensional problem).
dealii::Tensor<1, 3> spinning_disc_displacement(const contact::Material& material,
                                                const MaterialMotion& motion, double outer_radius,
                                                const dealii::Point<3>& place);

/// Displacement of the wheel at its rolling speed before contact, mm: its far boundary moves like a
/// spinning disc of its rolling radius; between there and the free surface the finite elements
/// balance the centrifugal load. `solver`: solver of wheel.problem(). Collective.
Vector spinning_displacement(const Body& wheel, const LinearSolver& solver);

/// The same at the contact.
struct WheelExpansion {
  Vector displacement;
  contact::Field distance;        ///< mm, added to the undeformed distance; negative where it grows
  contact::TangentialField slip;  ///< added to the rigid slip: the surface is longer by u_r / R
};
WheelExpansion wheel_expansion(const Body& wheel, const LinearSolver& solver,
                               const contact::ContactSurface& surface,
                               const contact::ContactGrid& grid, contact::UpwindOrder order);

}  // namespace rollfem::fem

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

/// The wheel at its rolling speed before contact.
struct WheelExpansion {
  Vector displacement;            ///< mm
  contact::Field distance;        ///< mm, added to the undeformed distance; negative where it grows
  contact::TangentialField slip;  ///< added to the rigid slip: the surface is longer by u_r / R
};
/// The far boundary moves like a spinning disc of the rolling radius; between there and the free
/// surface the finite elements balance the centrifugal load. `solver`: solver of wheel.problem().
/// Collective.
WheelExpansion wheel_expansion(const Body& wheel, const LinearSolver& solver,
                               const contact::ContactSurface& surface,
                               const contact::ContactGrid& grid, contact::UpwindOrder order);

}  // namespace rollfem::fem

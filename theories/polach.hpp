// SPDX-License-Identifier: LGPL-2.1-or-later
// Polach's closed form of the creep force on an ellipse (Polach 1999, Vehicle System Dynamics
// Supplement 33, 728-739; 2005, Wear 258, 992-1000): the model "polach".
#pragma once

#include "contact/solve/model.hpp"

namespace rollfem::theories {

/// Polach's gradient of the tangential stress, eps = (pi/4) F_linear/(mu N): pi/4 of the force of
/// the linear theory over the friction force.
double polach_gradient(double linear_force, double friction_force);

/// F/(mu N) = 2/pi (k_A eps/(1 + (k_A eps)^2) + atan(k_S eps)), with the reductions k_A of the
/// adhesion and k_S of the slip area, 1 for clean surfaces.
double polach_saturation(double gradient, double adhesion, double slip);

/// The model "polach": forces only, by the friction coefficient of the rigid slip. Tractions are
/// spread like the pressure, and no slip is given. Throws contact::InputError for spin.
contact::ModelResult run_polach(const contact::Scene& scene, const contact::Progress& progress);

}  // namespace rollfem::theories

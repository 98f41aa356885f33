// SPDX-License-Identifier: LGPL-2.1-or-later
// Vermeulen and Johnson's theory of an elliptic patch without spin (J. Appl. Mech. 31, 1964), with
// Kalker's coefficients for the initial slope: the model "vermeulen-johnson".
#pragma once

#include "contact/solve/model.hpp"
#include "theories/elliptic_patch.hpp"

namespace rollfem::theories {

/// Solution at one pair of creepages. The adhesion area is an ellipse similar to the patch that
/// touches it at the leading edge.
struct VermeulenJohnson {
  double load = 0.0;         ///< tau = G a b sqrt((C11 xi)^2 + (C22 eta)^2) / (mu N)
  double stick_ratio = 0.0;  ///< semi-axes of the adhesion area over those of the patch, 1 - tau/3
  double saturation = 0.0;   ///< F / (mu N) = 1 - (1 - tau/3)^3, 1 from tau = 3
  double direction_x = 0.0;  ///< unit vector of the force on the wheel
  double direction_y = 0.0;
};

/// `friction_force` = mu N in N, shear modulus in MPa, semi-axes in mm.
VermeulenJohnson vermeulen_johnson(double semi_axis_x, double semi_axis_y, double shear_modulus,
                                   double poisson_ratio, double friction_force,
                                   const contact::Creepage& creepage);

/// |p_t| / (mu p0) at a point of the patch.
double vermeulen_johnson_traction(const VermeulenJohnson& solution, double semi_axis_x,
                                  double semi_axis_y, double x, double y);

/// The model "vermeulen-johnson". It gives no slip velocity (the record's slip is 0). Throws
/// contact::InputError for spin or extra rigid slip.
contact::ModelResult run_vermeulen_johnson(const contact::Scene& scene,
                                           const contact::Progress& progress);

// The model "linear": Kalker's linear theory of rolling contact
// (halfspace/closed_forms/kalker.hpp). No slip, no friction bound.

/// The model "linear". The forces follow from Kalker's coefficients, without a bound; the tractions
/// are those of the simplified theory without slip, which have the same F_x and F_y. Throws
/// contact::InputError for extra rigid slip.
contact::ModelResult run_linear(const contact::Scene& scene, const contact::Progress& progress);

}  // namespace rollfem::theories

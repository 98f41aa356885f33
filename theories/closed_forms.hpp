// SPDX-License-Identifier: LGPL-2.1-or-later
// Creep forces on an elliptic patch in closed form: Kalker's linear theory, Vermeulen and Johnson
// (J. Appl. Mech. 31, 1964), with spin as Shen, Hedrick and Elkins (1983, Proc. 8th IAVSD
// Symposium, 591-605), and Polach (1999, Vehicle System Dynamics Supplement 33, 728-739; 2005, Wear
// 258, 992-1000): the models "linear", "vermeulen-johnson" and "polach".
#pragma once

#include "contact/solve/model.hpp"

namespace rollfem::theories {

struct PolachOptions {
  double adhesion_reduction = 1.0;  ///< k_A
  double slip_reduction = 1.0;      ///< k_S
};

/// Solution at one pair of creepages. The adhesion area is an ellipse similar to the patch that
/// touches it at the leading edge.
struct VermeulenJohnson {
  double load = 0.0;         ///< tau = force of the linear theory, with that by spin, over mu N
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

/// Polach's gradient of the tangential stress, eps = (pi/4) F_linear/(mu N): pi/4 of the force of
/// the linear theory over the friction force.
double polach_gradient(double linear_force, double friction_force);

/// F/(mu N) = 2/pi (k_A eps/(1 + (k_A eps)^2) + atan(k_S eps)), with the reductions k_A of the
/// adhesion and k_S of the slip area, 1 for clean surfaces.
double polach_saturation(double gradient, double adhesion, double slip);

// These theories leave out extra rigid slip.

/// The forces follow from Kalker's coefficients (halfspace/closed_forms/kalker.hpp), without a
/// bound; the tractions are those of the simplified theory without slip, which have the same F_x
/// and F_y.
contact::ModelResult run_linear(const contact::Scene& scene, const contact::Progress& progress);

/// With Kalker's coefficients for the initial slope. It gives no slip velocity (the record's slip
/// is 0).
contact::ModelResult run_vermeulen_johnson(const contact::Scene& scene,
                                           const contact::Progress& progress);

/// Forces only, by the friction coefficient of the rigid slip. Tractions are spread like the
/// pressure, and no slip is given.
contact::ModelResult run_polach(const contact::Scene& scene, const contact::Progress& progress);

contact::ModelInfo linear_model();
contact::ModelInfo vermeulen_johnson_model();
contact::ModelInfo polach_model();

}  // namespace rollfem::theories

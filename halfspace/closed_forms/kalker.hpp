// SPDX-License-Identifier: LGPL-2.1-or-later
// Creepage coefficients of Kalker's linear theory of rolling contact for every aspect ratio and
// Poisson's ratio, and the resulting forces: the limit of every creep curve at small creepage.
#pragma once

#include "scene/geometry.hpp"

namespace rollfem::halfspace {

/// Creepage coefficients (Kalker 1967; 1990, table E.3) over G and the powers of c = sqrt(a b) in
/// linear_creep_forces; C32 = -C23.
struct KalkerCoefficients {
  double c11 = 0.0;  ///< longitudinal
  double c22 = 0.0;  ///< lateral
  double c23 = 0.0;  ///< lateral force by spin
  double c33 = 0.0;  ///< moment by spin
};

/// Coefficients of an ellipse with semi-axis a along rolling and b across, any a/b > 0, 0 <= nu <=
/// 0.5: within 1e-4 from a/b = 0.2 to 20 and within 3e-4 from 0.01 to 100, by polynomials through
/// kalker_table. Outside this range, the asymptotes (Kalker 1990, table E.3; C33 of long patches is
/// corrected), multiplied by a factor that makes them continuous there and tends to 1 with the
/// square of the ratio: within 1e-3. Throws contact::InputError when an argument is out of range.
KalkerCoefficients kalker_coefficients(double semi_axis_x, double semi_axis_y,
                                       double poisson_ratio);

/// Tangential forces on the wheel.
struct CreepForces {
  double longitudinal = 0.0;  ///< F_x, N
  double lateral = 0.0;       ///< F_y, N
  double spin_moment = 0.0;   ///< M_z, N mm
};

/// F_x = -G c^2 C11 xi, F_y = -G c^2 (C22 eta + c C23 phi), M_z = -G c^3 (C32 eta + c C33 phi) with
/// c = sqrt(a b) and the combined shear modulus G in MPa.
CreepForces linear_creep_forces(double semi_axis_x, double semi_axis_y, double shear_modulus,
                                double poisson_ratio, const contact::Creepage& creepage);

}  // namespace rollfem::halfspace

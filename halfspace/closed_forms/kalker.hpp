// Creepage coefficients of Kalker's linear theory of rolling contact for every aspect ratio and
// Poisson's ratio, and the resulting forces: the limit of every creep curve at small creepage.
#pragma once

#include "contact/scene/geometry.hpp"

#include <array>

namespace rollfem::halfspace {

/// Creepage coefficients (Kalker 1967; Kalker 1990, table E.3); C32 = -C23.
struct KalkerCoefficients {
  double c11 = 0.0;  ///< longitudinal
  double c22 = 0.0;  ///< lateral
  double c23 = 0.0;  ///< lateral force by spin
  double c33 = 0.0;  ///< moment by spin
};

/// Coefficients of an ellipse with semi-axis a along rolling and b across, any a/b > 0,
/// 0 <= nu <= 0.5. Between the tabulated values 1/C is quadratic in nu and C linear in the smaller
/// of a/b and b/a, as in CONTACT. Beyond 0.1 the asymptotes of Kalker (1990, table E.3), multiplied
/// by a factor that makes them continuous there and tends to 1 in proportion to the ratio.
/// Throws contact::InputError when an argument is out of range.
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

// Kalker's table of creepage coefficients at the ratios 0.1, 0.2, ... 1 and nu = 0, 1/4, 1/2.

/// Coefficients at nu = 0, 1/4, 1/2.
using KalkerRow = std::array<KalkerCoefficients, 3>;
/// Rows for the ratios 0.1, 0.2, ..., 1.
using KalkerTable = std::array<KalkerRow, 10>;

/// Ratio a/b: patches wider than long.
const KalkerTable& kalker_table_short();
/// Ratio b/a: patches longer than wide. The last row is that of the other table.
const KalkerTable& kalker_table_long();

}  // namespace rollfem::halfspace

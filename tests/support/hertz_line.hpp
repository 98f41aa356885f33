// What Hertz's theory says beyond what the program needs: the line contact, and the stress below
// the middle of an ellipse (Johnson 1985, chapters 3 and 4).
#pragma once

#include "halfspace/closed_forms/hertz.hpp"

#include <boost/math/special_functions/ellint_rd.hpp>

#include <cmath>

namespace rollfem::testing {

/// Line contact h = x^2 / (2 R), force per unit length in N/mm.
struct HertzLine {
  double half_width = 0.0;    ///< mm
  double max_pressure = 0.0;  ///< MPa
};

inline HertzLine hertz_line(double radius, double contact_modulus, double force_per_length) {
  HertzLine line;
  line.half_width = std::sqrt(4.0 * force_per_length * radius / (M_PI * contact_modulus));
  line.max_pressure = 2.0 * force_per_length / (M_PI * line.half_width);
  return line;
}

/// Stress below the middle of the patch (x = y = 0) at depth z >= 0 under the pressure alone.
struct AxisStress {
  double xx = 0.0;
  double yy = 0.0;
  double zz = 0.0;
};

/// Love's potentials V and chi (dchi/dz = V) of the pressure [Love 1929; Johnson 1985,
/// section 3.2]:
///   2 pi szz = V_z - z V_zz,  2 pi sxx = 2 nu V_z - z V_xx - (1 - 2 nu) chi_xx.
/// On the axis V_xx = -(2/3) pi a b p0 R_D(b^2 + l, l, a^2 + l) with l = z^2, and chi_xx is the
/// integral of V_xx over depth, elementary but for z V_xx. No axis is the major one, and the circle
/// is not a special case (the textbook form by Thomas and Hoersch divides by a^2 - b^2).
inline AxisStress hertz_axis_stress(const halfspace::HertzContact& contact, double nu, double z) {
  using boost::math::ellint_rd;
  const double a2 = contact.semi_axis_x * contact.semi_axis_x;
  const double b2 = contact.semi_axis_y * contact.semi_axis_y;
  const double l = z * z;
  // In units of 2 pi: s = pi a b p0 / (2 pi).
  const double s = 0.5 * contact.semi_axis_x * contact.semi_axis_y * contact.max_pressure;
  const double third = 2.0 / 3.0;
  const double v_xx = -third * s * ellint_rd(b2 + l, l, a2 + l);
  const double v_yy = -third * s * ellint_rd(a2 + l, l, b2 + l);
  const double v_z =
      z > 0.0 ? -third * s * z * ellint_rd(a2 + l, b2 + l, l) : -contact.max_pressure;
  const double alpha = std::sqrt(a2 + l);
  const double beta = std::sqrt(b2 + l);
  const double chi_xx = s * 2.0 / (alpha * (alpha + beta)) + z * v_xx;
  const double chi_yy = s * 2.0 / (beta * (alpha + beta)) + z * v_yy;
  AxisStress stress;
  stress.zz = v_z + z * (v_xx + v_yy);
  stress.xx = 2.0 * nu * v_z - z * v_xx - (1.0 - 2.0 * nu) * chi_xx;
  stress.yy = 2.0 * nu * v_z - z * v_yy - (1.0 - 2.0 * nu) * chi_yy;
  return stress;
}

}  // namespace rollfem::testing

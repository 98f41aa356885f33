// SPDX-License-Identifier: LGPL-2.1-or-later
// Materials of wheel and rail, their combined constants, and the speed of their surface waves,
// which limits how fast a load may move over an elastic body.
#pragma once

#include <limits>

namespace rollfem::contact {

/// Linear-elastic isotropic material.
struct Material {
  double young_modulus = 210e3;  ///< MPa, inf: rigid (at most one of the two bodies)
  double poisson_ratio = 0.3;
  double density = 7.85e-9;  ///< t/mm^3, used only with inertia

  bool rigid() const { return young_modulus == std::numeric_limits<double>::infinity(); }
};

inline Material rigid_material() {
  return {std::numeric_limits<double>::infinity(), 0.3, 7.85e-9};
}

/// Combined constants of two bodies of like or unlike materials (Kalker 1990, eq. 1.44).
struct CombinedMaterial {
  double shear_modulus = 0.0;    ///< MPa, 1/G = (1/G1 + 1/G2)/2
  double poisson_ratio = 0.0;    ///< nu/G = (nu1/G1 + nu2/G2)/2
  double difference = 0.0;       ///< K, K/G = ((1-2nu1)/G1 - (1-2nu2)/G2)/4; 0 for like materials
  double contact_modulus = 0.0;  ///< E* in MPa, 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2
  double layer = 0.0;            ///< h/G of a layer between the bodies in shear, mm/MPa
  double wheel_share = 0.5;      ///< the wheel's part of 1/G: 1/G1 over 1/G1 + 1/G2

  /// Whether normal and tangential contact are coupled: K exceeds rounding.
  bool couples() const { return difference > 1e-12 || difference < -1e-12; }
  /// The same without that coupling.
  CombinedMaterial uncoupled() const {
    CombinedMaterial other = *this;
    other.difference = 0.0;
    return other;
  }
};

double shear_modulus(const Material& material);
CombinedMaterial combine(const Material& wheel, const Material& rail);

/// Largest rolling speed as a fraction of the Rayleigh wave speed, at which the response to a
/// moving load becomes infinite and beyond which the stiffness with inertia is indefinite.
inline constexpr double largest_rayleigh_fraction = 0.9;

/// Rayleigh's wave speed in mm/s, inf for a massless or rigid body. With e = (c/c_s)^2, c_s the
/// speed of shear waves and k = (1 - 2 nu)/(2 (1 - nu)): e^3 - 8 e^2 + (24 - 16 k) e = 16 (1 - k),
/// the root between 0 and 1 (Lord Rayleigh, Proc. London Math. Soc. 17 (1885)).
double rayleigh_speed(const Material& material);

}  // namespace rollfem::contact

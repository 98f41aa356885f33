// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/material.hpp"

#include "base/root.hpp"

#include <cmath>

namespace rollfem::contact {

double shear_modulus(const Material& material) {
  return material.young_modulus / (2.0 * (1.0 + material.poisson_ratio));
}

CombinedMaterial combine(const Material& wheel, const Material& rail) {
  const double g1 = shear_modulus(wheel);
  const double g2 = shear_modulus(rail);
  const double nu1 = wheel.poisson_ratio;
  const double nu2 = rail.poisson_ratio;
  CombinedMaterial combined;
  combined.shear_modulus = 2.0 / (1.0 / g1 + 1.0 / g2);
  combined.poisson_ratio = combined.shear_modulus * (nu1 / g1 + nu2 / g2) / 2.0;
  combined.difference =
      combined.shear_modulus * ((1.0 - 2.0 * nu1) / g1 - (1.0 - 2.0 * nu2) / g2) / 4.0;
  combined.contact_modulus =
      1.0 / ((1.0 - nu1 * nu1) / wheel.young_modulus + (1.0 - nu2 * nu2) / rail.young_modulus);
  combined.wheel_share = 0.5 * combined.shear_modulus / g1;
  return combined;
}

double rayleigh_speed(const Material& material) {
  const double nu = material.poisson_ratio;
  const double k = (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu));
  const auto excess = [k](double e) {
    return ((e - 8.0) * e + (24.0 - 16.0 * k)) * e - 16.0 * (1.0 - k);
  };
  // Negative at 0, positive at 1, and one root between for nu >= 0.
  const double square = bracketed_root(excess, 0.0, 1.0, 1e-15, "Rayleigh's wave speed");
  return std::sqrt(square * shear_modulus(material) / material.density);
}

}  // namespace rollfem::contact

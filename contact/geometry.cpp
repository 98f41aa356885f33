#include "contact/geometry.hpp"

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
  return combined;
}

Curvatures relative_curvatures(const Case& input) {
  return {0.5 / input.wheel.rolling_radius,
          0.5 / input.wheel.transverse_radius + 0.5 / input.rail.transverse_radius};
}

double undeformed_distance(const Curvatures& curvatures, double x, double y) {
  return curvatures.A * x * x + curvatures.B * y * y;
}

TangentialField rigid_slip(const Case& input, const Creepage& creepage, const ContactGrid& grid) {
  const bool extra = input.rolling.extra_slip == ExtraSlip::rolling_radius;
  // The drop of the rail surface, in the same parabolic approximation as the undeformed distance.
  const double drop = 0.5 / input.rail.transverse_radius;
  const double radius = input.wheel.rolling_radius;
  TangentialField slip;
  slip.x = grid.sample([&](double, double y) {
    return creepage.longitudinal - creepage.spin * y - (extra ? drop * y * y / radius : 0.0);
  });
  slip.y = grid.sample([&](double x, double) { return creepage.lateral + creepage.spin * x; });
  return slip;
}

}  // namespace rollfem::contact

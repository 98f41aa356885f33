#include "contact/geometry.hpp"

#include "contact/lattice.hpp"

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
  if (input.undeformed_distance.quadratic)
    return {(*input.undeformed_distance.quadratic)[0], (*input.undeformed_distance.quadratic)[1]};
  return {0.5 / input.wheel.rolling_radius,
          0.5 / input.wheel.transverse_radius + 0.5 / input.rail.transverse_radius};
}

double undeformed_distance(const Curvatures& curvatures, double x, double y) {
  return curvatures.A * x * x + curvatures.B * y * y;
}

Field undeformed_distance(const Case& input, const ContactGrid& grid) {
  if (input.undeformed_distance.values)
    return sample_lattice(*input.undeformed_distance.values, 0, grid, "undeformed_distance.file");
  const Curvatures curvatures = relative_curvatures(input);
  return grid.sample([&](double x, double y) { return undeformed_distance(curvatures, x, y); });
}

TangentialField extra_slip(const Case& input, const ContactGrid& grid) {
  const Field zero = Field::Zero(grid.size());
  switch (input.rolling.extra_slip) {
    case ExtraSlip::none:
      return {zero, zero};
    case ExtraSlip::file: {
      const Lattice& values = input.rolling.extra_slip_values.value();
      return {sample_lattice(values, 0, grid, "rolling.extra_slip_file"),
              sample_lattice(values, 1, grid, "rolling.extra_slip_file")};
    }
    case ExtraSlip::rolling_radius:
      break;
  }
  // The drop of the rail surface, in the same parabolic approximation as the undeformed distance.
  const double drop = 0.5 / input.rail.transverse_radius;
  const double radius = input.wheel.rolling_radius;
  return {grid.sample([&](double, double y) { return -drop * y * y / radius; }), zero};
}

TangentialField rigid_slip(const Case& input, const Creepage& creepage, const ContactGrid& grid) {
  TangentialField slip = extra_slip(input, grid);
  slip.x +=
      grid.sample([&](double, double y) { return creepage.longitudinal - creepage.spin * y; });
  slip.y += grid.sample([&](double x, double) { return creepage.lateral + creepage.spin * x; });
  return slip;
}

TangentialField rigid_shift(const HistoryStep& step, const ContactGrid& grid) {
  return {
      grid.sample([&](double, double y) { return step.longitudinal_shift - step.spin_shift * y; }),
      grid.sample([&](double x, double) { return step.lateral_shift + step.spin_shift * x; })};
}

}  // namespace rollfem::contact

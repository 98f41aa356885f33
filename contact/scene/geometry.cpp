#include "contact/scene/geometry.hpp"

#include "contact/case/lattice.hpp"

#include <algorithm>

namespace rollfem::contact {

namespace {

/// Distance where the wheel has no surface, mm: as good as infinite, which the solvers refuse.
constexpr double beyond_the_wheel = 1e3;

/// Second derivative by y at the contact point. Where the curvature jumps there, the mean of both
/// sides.
double mean_second(const HeightCurve& curve) {
  constexpr double beside = 1e-6;  // mm
  return 0.5 * (curve.at(-beside).second + curve.at(beside).second);
}

/// Curvatures of the distance at the origin of the patch frame, where both surfaces are level. With
/// F = radius - f(axial) = 0 on the wheel, z_xx = -F_xx / F_z there.
Curvatures curvatures_at_contact_point(const PatchGeometry& patch) {
  const Vector3& e = patch.axle().direction;
  const Vector3 place{0.0, 0.0, patch.wheel().at(0.0).value};
  const auto [axial, radius] = patch.axle_place(place);
  const CurveValue f = patch.wheel_radius().at(axial);
  const auto radial = [&, axial = axial, radius = radius](int d) {
    return (place[d] - patch.axle().point[d] - axial * e[d]) / radius;
  };
  const double radius_xx = (1.0 - e[0] * e[0] - radial(0) * radial(0)) / radius;
  const double z_xx = -(radius_xx - f.second * e[0] * e[0]) / (radial(2) - f.slope * e[2]);
  return {0.5 * z_xx, 0.5 * (mean_second(patch.wheel()) - mean_second(patch.rail()))};
}

/// s_x of the rolling radius rho(y) beyond its tangent at the contact point, which is the geometric
/// spin: 1 - (rho - rho' y) / rho(0).
Field slip_of_rolling_radius(const PatchGeometry& patch, const ContactGrid& grid) {
  constexpr double beside = 0.01;  // mm
  const double radius = patch.local_rolling_radius(0.0);
  const double slope =
      (patch.local_rolling_radius(beside) - patch.local_rolling_radius(-beside)) / (2.0 * beside);
  return grid.sample([&](double, double y) {
    return (radius + slope * y - patch.local_rolling_radius(y)) / radius;
  });
}

}  // namespace

Curvatures relative_curvatures(const Case& input) {
  if (input.patch) return curvatures_at_contact_point(*input.patch);
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
  if (input.patch)
    return grid.sample([&](double x, double y) {
      return std::min(input.patch->distance(x, y), beyond_the_wheel);
    });
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
  if (input.patch) return {slip_of_rolling_radius(*input.patch, grid), zero};
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

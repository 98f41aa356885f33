// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/trace/far_error.hpp"

#include "contact/base/pi.hpp"
#include "contact/scene/geometry.hpp"
#include "fem/mesh/run_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::fem {

namespace {

using contact::pi;

/// Displacement of a half-space on the axis under a point load, at depth L (Boussinesq: P (3 - 2
/// nu) / (4 pi G L)), mm; the surface moves less at that distance.
double displacement_at(const contact::Material& material, double force, double distance) {
  return force * (3.0 - 2.0 * material.poisson_ratio) /
         (4.0 * pi * contact::shear_modulus(material) * distance);
}

/// Slope at which the circle of a profile ends; 1 for the default of 44.4 degrees.
double steepest_slope(double round_to) {
  return std::max(1.0, round_to / std::sqrt(1.0 - round_to * round_to));
}

/// Change of a half-space's displacement beyond `extent` by a surface of this curvature (1/mm, sum
/// of both directions) with the last profile slope `steepest`: first order by the strain energy
/// along the surface, which is small, and second order in the slope L kappa / 4.
double curvature_error(const contact::Material& material, double force, double extent,
                       double curvature, double steepest) {
  const double kappa = std::abs(curvature);
  if (kappa == 0.0) return 0.0;
  const double free_strain = 1.0 - 2.0 * material.poisson_ratio;
  const double first = force * free_strain * free_strain * kappa /
                       (8.0 * pi * contact::shear_modulus(material)) *
                       std::log1p(1.0 / (kappa * extent));
  // Profiles continue along their steepest tangent in one of two directions.
  const double slope = std::min(0.25 * kappa * extent, 0.5 * steepest);
  return first + slope * slope * displacement_at(material, force, extent);
}

}  // namespace

contact::FarBoundary far_boundary_of(const contact::Scene& scene) {
  const bool given_mesh =
      has_true_sections(scene) || !scene.wheel.mesh.empty() || !scene.rail.mesh.empty();
  return scene.options.fem.far_boundary.value_or(given_mesh ? contact::FarBoundary::clamped
                                                            : contact::FarBoundary::point_load);
}

double approach_left_out(const contact::Scene& scene, double normal_force, double extent) {
  const double spread = PatchSearch(scene).box().larger() / extent;
  const auto of_body = [&](const contact::Material& material, double curvature, double round_to) {
    const double clamped = displacement_at(material, normal_force, extent);
    if (far_boundary_of(scene) == contact::FarBoundary::clamped) return clamped;
    // <x^2> = a^2/5 in Hertz's ellipse of pressure.
    return std::min(clamped, 0.2 * spread * spread * clamped +
                                 curvature_error(material, normal_force, extent, curvature,
                                                 steepest_slope(round_to)));
  };
  const contact::ContactSurface& surface = scene.geometry.surface;
  if (scene.has_profiles())
    return of_body(scene.wheel.material,
                   1.0 / surface.profiles->local_rolling_radius(0.0) +
                       std::abs(surface.profiles->wheel().at(0.0).second),
                   contact::usual_round_to) +
           of_body(scene.rail.material,
                   1.0 / std::abs(surface.local_rail_radius(0.0)) +
                       surface.profiles->rail().at(0.0).second,
                   contact::usual_round_to);
  return of_body(scene.wheel.material,
                 1.0 / surface.rolling_radius + 1.0 / surface.wheel_transverse_radius,
                 surface.wheel_round_to) +
         of_body(scene.rail.material,
                 1.0 / surface.rail_rolling_radius + 1.0 / surface.rail_transverse_radius,
                 surface.rail_round_to);
}

std::string far_boundary_note(const contact::Scene& scene, double extent) {
  if (far_boundary_of(scene) == contact::FarBoundary::clamped)
    return fmt::format(
        "wheel and rail segments extend {:.4g} mm from the patch and are clamped there: the "
        "approach is that of these segments; its error estimate includes the possible increase for "
        "large bodies",
        extent);
  return fmt::format(
      "wheel and rail segments extend {:.4g} mm from the patch and move there like half-spaces "
      "under the force on it: the approach is that of large bodies, within its error estimate",
      extent);
}

}  // namespace rollfem::fem

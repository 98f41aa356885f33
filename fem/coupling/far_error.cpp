#include "fem/coupling/far_error.hpp"

#include "contact/base/pi.hpp"
#include "contact/scene/geometry.hpp"
#include "fem/model/run_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::fem {

namespace {

using contact::pi;

/// Of a half-space in depth under a point load at a distance L, on the axis (Boussinesq: P (3 - 2
/// nu) / (4 pi G L)); the surface moves less at that distance. mm.
double displacement_at(const contact::Material& material, double force, double distance) {
  return force * (3.0 - 2.0 * material.poisson_ratio) /
         (4.0 * pi * contact::shear_modulus(material) * distance);
}

/// What a surface of this curvature (1/mm, sum of both directions) changes in the displacement of a
/// half-space from `extent` on: to first order by the strain energy along its surface, which is
/// small, and to second order in the slope L kappa / 4.
double curvature_error(const contact::Material& material, double force, double extent,
                       double curvature) {
  const double kappa = std::abs(curvature);
  if (kappa == 0.0) return 0.0;
  const double free_strain = 1.0 - 2.0 * material.poisson_ratio;
  const double first = force * free_strain * free_strain * kappa /
                       (8.0 * pi * contact::shear_modulus(material)) *
                       std::log1p(1.0 / (kappa * extent));
  // Profiles go on along their steepest tangent, of slope 1 in one of two directions.
  const double slope = std::min(0.25 * kappa * extent, 0.5);
  return first + slope * slope * displacement_at(material, force, extent);
}

}  // namespace

contact::FarBoundary far_boundary_of(const contact::Scene& scene) {
  const bool given_mesh =
      has_true_sections(scene) || !scene.wheel.mesh.empty() || !scene.rail.mesh.empty();
  return scene.fem.far_boundary.value_or(given_mesh ? contact::FarBoundary::clamped
                                                    : contact::FarBoundary::point_load);
}

double approach_left_out(const contact::Scene& scene, double normal_force, double extent) {
  const double spread = patch_box(scene).larger() / extent;
  const auto of_body = [&](const contact::Material& material, double curvature) {
    const double clamped = displacement_at(material, normal_force, extent);
    if (far_boundary_of(scene) == contact::FarBoundary::clamped) return clamped;
    // <x^2> = a^2/5 in Hertz's ellipse of pressure.
    return std::min(clamped, 0.2 * spread * spread * clamped +
                                 curvature_error(material, normal_force, extent, curvature));
  };
  if (scene.has_profiles())
    return of_body(scene.wheel.material,
                   1.0 / scene.geometry.surface.profiles->local_rolling_radius(0.0) +
                       std::abs(scene.geometry.surface.profiles->wheel().at(0.0).second)) +
           of_body(scene.rail.material, scene.geometry.surface.profiles->rail().at(0.0).second);
  return of_body(scene.wheel.material, 1.0 / scene.geometry.surface.rolling_radius +
                                           1.0 / scene.geometry.surface.wheel_transverse_radius) +
         of_body(scene.rail.material, 1.0 / scene.geometry.surface.rail_transverse_radius);
}

std::string far_boundary_note(const contact::Scene& scene, double extent) {
  if (far_boundary_of(scene) == contact::FarBoundary::clamped)
    return fmt::format(
        "wheel and rail segments reach {:.4g} mm from the patch and are clamped there: the "
        "approach is that of these segments; its error estimate says how much more it may be for "
        "large bodies",
        extent);
  return fmt::format(
      "wheel and rail segments reach {:.4g} mm from the patch and move there as half-spaces under "
      "the force on it: the approach is that of large bodies; its error estimate says how far",
      extent);
}

}  // namespace rollfem::fem

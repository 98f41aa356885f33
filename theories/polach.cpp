// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/polach.hpp"

#include "contact/base/pi.hpp"
#include "halfspace/closed_forms/kalker.hpp"
#include "theories/elliptic_patch.hpp"

#include <cmath>

namespace rollfem::theories {

using contact::pi;

double polach_gradient(double linear_force, double friction_force) {
  return 0.25 * pi * linear_force / friction_force;
}

double polach_saturation(double gradient, double adhesion, double slip) {
  const double stuck = adhesion * gradient;
  return 2.0 / pi * (stuck / (1.0 + stuck * stuck) + std::atan(slip * gradient));
}

contact::ModelResult run_polach(const contact::Scene& scene, const contact::Progress& progress) {
  const EllipticPatch patch = elliptic_patch(scene);
  const contact::PolachOptions& options = scene.options.polach;
  const auto fill = [&](contact::PointResult& point) {
    const contact::Creepage creepage{point.creepage.longitudinal, point.creepage.lateral, 0.0};
    const halfspace::CreepForces linear = halfspace::linear_creep_forces(
        patch.hertz.semi_axis_x, patch.hertz.semi_axis_y, patch.material.shear_modulus,
        patch.material.poisson_ratio, creepage);
    const double size = std::hypot(linear.longitudinal, linear.lateral);
    if (patch.friction == 0.0 || size == 0.0) return;
    const double slip = std::hypot(creepage.longitudinal, creepage.lateral);
    const double friction = patch.falling ? patch.falling->at(slip).value : patch.friction;
    const double bound = friction * point.normal_force;
    const double force =
        bound * polach_saturation(polach_gradient(size, bound), options.adhesion_reduction,
                                  options.slip_reduction);
    contact::SurfaceField& traction = point.fields.traction;
    traction.x = force * linear.longitudinal / (size * point.normal_force) * traction.n;
    traction.y = force * linear.lateral / (size * point.normal_force) * traction.n;
    set_forces({force * linear.longitudinal / size, force * linear.lateral / size, 0.0}, point);
    set_largest_tractions(point);
  };
  contact::ModelResult result =
      run_theory(scene, patch.grid, patch.normal, "polach", progress, fill);
  result.notes.push_back(
      "Polach's formula gives forces only: tractions are spread like the pressure, and the "
      "adhesion area is the whole patch");
  if (patch.falling && patch.falling->memory())
    result.notes.push_back("friction is that of the rigid slip; memory_distance is neglected");
  return result;
}

}  // namespace rollfem::theories

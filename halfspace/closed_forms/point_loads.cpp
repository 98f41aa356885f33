// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/closed_forms/point_loads.hpp"

#include "base/pi.hpp"

#include <cmath>

namespace rollfem::halfspace {

namespace {

using contact::pi;

double distance(const Position& at) {
  return std::sqrt(at.x * at.x + at.y * at.y + at.z * at.z);
}

}  // namespace

/// Johnson 1985, eq. 3.18.
Displacement boussinesq_displacement(const ElasticHalfspace& body, double force,
                                     const Position& at) {
  const double rho = distance(at);
  const double scale = force / (4.0 * pi * body.shear_modulus);
  const double lateral =
      at.z / (rho * rho * rho) - (1.0 - 2.0 * body.poisson_ratio) / (rho * (rho + at.z));
  const double vertical = at.z * at.z / (rho * rho * rho) + 2.0 * (1.0 - body.poisson_ratio) / rho;
  return {scale * at.x * lateral, scale * at.y * lateral, scale * vertical};
}

/// Johnson 1985, eq. 3.75.
Displacement cerruti_displacement(const ElasticHalfspace& body, double force, const Position& at) {
  const double rho = distance(at);
  const double rho3 = rho * rho * rho;
  const double sum = rho + at.z;
  const double factor = 1.0 - 2.0 * body.poisson_ratio;
  const double scale = force / (4.0 * pi * body.shear_modulus);
  const double shared = 1.0 / rho3 - factor / (rho * sum * sum);
  return {scale * (1.0 / rho + factor / sum + at.x * at.x * shared), scale * at.x * at.y * shared,
          scale * at.x * (at.z / rho3 + factor / (rho * sum))};
}

}  // namespace rollfem::halfspace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Point loads on the elastic half-space (Boussinesq, Cerruti; Johnson 1985, sections 3.2 and 3.6).
// One body, z >= 0 into it, loads and displacements positive along the axes.
#pragma once

#include <array>

namespace rollfem::halfspace {

/// A half-space: shear modulus in MPa and Poisson's ratio.
struct ElasticHalfspace {
  double shear_modulus = 0.0;
  double poisson_ratio = 0.0;
};

/// A point in mm; z is the depth.
struct Position {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

using Displacement = std::array<double, 3>;  ///< u_x, u_y, u_z in mm

/// Force in N into the half-space at the origin; not at the origin itself. The displacement
/// vanishes at infinity.
Displacement boussinesq_displacement(const ElasticHalfspace& body, double force,
                                     const Position& at);

/// Force in N along x at the origin. For a force along y, exchange x and y in position and result.
Displacement cerruti_displacement(const ElasticHalfspace& body, double force, const Position& at);

}  // namespace rollfem::halfspace

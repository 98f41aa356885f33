// SPDX-License-Identifier: LGPL-2.1-or-later
// State inside the half-space under one loaded rectangle or one point force, from the potentials
// that the program sums.
#pragma once

#include "halfspace/stress/cell_stress.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

/// Uniform tractions (MPa) or forces (N) on the surface along +x, +y, +z of the local frame.
struct LocalLoad {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

inline halfspace::LocalState state_of_source(const halfspace::Potentials& source,
                                             const LocalLoad& load, double shear_modulus,
                                             double poisson_ratio, double z) {
  const halfspace::Potentials p_x = load.x * source;
  const halfspace::Potentials p_y = load.y * source;
  const halfspace::Potentials p_z = load.z * source;
  halfspace::LocalState state =
      halfspace::assemble_state(p_x.data(), p_y.data(), p_z.data(), poisson_ratio, z);
  for (std::size_t i = 0; i < halfspace::component_count; ++i)
    state[i] *= i < halfspace::s_xx ? 1.0 / (4.0 * M_PI * shear_modulus) : 1.0 / (2.0 * M_PI);
  return state;
}

/// At (x, y, z >= 0) under uniform tractions on the rectangle.
inline halfspace::LocalState rectangle_state(double x, double y, double z, double dx, double dy,
                                             const LocalLoad& traction, double shear_modulus,
                                             double poisson_ratio) {
  return state_of_source(halfspace::rectangle_potentials(x, y, z, dx, dy), traction, shear_modulus,
                         poisson_ratio, z);
}

/// Under a force at the origin.
inline halfspace::LocalState point_state(double x, double y, double z, const LocalLoad& force,
                                         double shear_modulus, double poisson_ratio) {
  return state_of_source(halfspace::point_potentials(x, y, z), force, shear_modulus, poisson_ratio,
                         z);
}

}  // namespace rollfem::testing

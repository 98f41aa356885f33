// SPDX-License-Identifier: LGPL-2.1-or-later
// What the tests of finite-element bodies share: MPI, small bodies, random tractions.
#pragma once

#include "base/grid.hpp"
#include "fem/discretisation/body.hpp"
#include "fem/trace/fem_compliance.hpp"
#include "scene/contact_surface.hpp"

#include "support/mpi_environment.hpp"
#include "support/random_field.hpp"
#include "support/test.hpp"

namespace rollfem::testing {

inline fem::SurfaceShape wheel_shape(double rolling_radius, double transverse_radius) {
  return {true, rolling_radius, transverse_radius};
}

inline fem::SurfaceShape rail_shape(double transverse_radius) {
  return {false, contact::infinity, transverse_radius};
}

/// The surface that bodies with radii share.
inline contact::ContactSurface common_surface(const fem::SurfaceShape& wheel,
                                              const fem::SurfaceShape& rail) {
  return {wheel.rolling_radius, wheel.transverse_radius, rail.transverse_radius};
}

/// The coupling of a body on its own surface: it touches another one of the same shape.
inline fem::SurfaceCoupling own_coupling(const fem::Body& body, const contact::ContactGrid& grid) {
  const double radius = body.shape().transverse_radius;
  return {body, grid,
          body.shape().is_wheel
              ? common_surface(body.shape(), rail_shape(-radius))
              : common_surface(wheel_shape(contact::infinity, -radius), body.shape())};
}

/// A body of a few thousand unknowns: fine region of 4 x 4 mm, cells of 1 mm.
inline fem::BodyOptions small_options() {
  fem::BodyOptions options;
  options.cell_size = 1.0;
  options.fine_half_length = 3.0;
  options.fine_half_width = 3.0;
  options.fine_depth = 1.0;
  options.growth = 1.0;
  options.extent = 16.0;
  return options;
}

/// x and n even, y odd about y = 0.
inline contact::SurfaceField symmetric_part(const contact::ContactGrid& grid,
                                            const contact::SurfaceField& field) {
  auto result = field;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int e = grid.index(i, j);
      const int m = grid.index(i, grid.ny - 1 - j);
      result.x[e] = 0.5 * (field.x[e] + field.x[m]);
      result.y[e] = 0.5 * (field.y[e] - field.y[m]);
      result.n[e] = 0.5 * (field.n[e] + field.n[m]);
    }
  return result;
}

}  // namespace rollfem::testing

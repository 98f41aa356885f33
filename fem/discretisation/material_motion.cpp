// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/discretisation/material_motion.hpp"

#include "fem/mesh/profile_shape.hpp"
#include "fem/mesh/surface_shape.hpp"

#include <cmath>

namespace rollfem::fem {

MaterialMotion material_motion(const SurfaceShape& shape, double speed) {
  MaterialMotion motion;
  if (!shape.is_wheel || !std::isfinite(shape.rolling_radius)) {
    motion.velocity[0] = -speed;
    return motion;
  }
  if (shape.profile) {
    motion.centre = shape.profile->axle_point();
    motion.rotation = speed / shape.rolling_radius * shape.profile->axle_direction();
    return motion;
  }
  motion.centre = dealii::Point<3>(0, 0, shape.rolling_radius);
  motion.rotation[1] = speed / shape.rolling_radius;
  return motion;
}

}  // namespace rollfem::fem

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/discretisation/material_motion.hpp"

#include "fem/mesh/surface_shape.hpp"

namespace rollfem::fem {

MaterialMotion material_motion(const SurfaceShape& shape, double speed) {
  MaterialMotion motion;
  if (!shape.is_revolved()) {
    motion.velocity[0] = -speed;
    return motion;
  }
  const meshes::AxleTrace axle = shape.axle();
  const double rotation = speed / shape.rolling_radius;
  motion.centre = {0, 0, axle.height};
  motion.rotation = dealii::Tensor<1, 3>({0, rotation * axle.cosine, rotation * axle.sine});
  return motion;
}

}  // namespace rollfem::fem

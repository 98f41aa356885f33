// SPDX-License-Identifier: LGPL-2.1-or-later
// The rigid flow of material through a mesh that is fixed in the frame of the contact.
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace rollfem::fem {

struct SurfaceShape;

/// v(x) = velocity + rotation x (x - centre): divergence-free, so that steady inertia has the
/// symmetric form in docs/theory.md. All zero: material at rest.
struct MaterialMotion {
  dealii::Tensor<1, 3> velocity;  ///< mm/s
  dealii::Tensor<1, 3> rotation;  ///< rad/s
  dealii::Point<3> centre;        ///< mm, on the axle

  bool at_rest() const { return velocity.norm_square() == 0 && rotation.norm_square() == 0; }
  dealii::Tensor<1, 3> at(const dealii::Point<3>& place) const {
    return velocity + dealii::cross_product_3d(rotation, place - centre);
  }
};

/// Material comes from +x at the contact: the rail moves rigidly with -speed along x, the wheel
/// turns about its axle with speed / rolling_radius (a flat "wheel" moves like the rail). mm/s.
MaterialMotion material_motion(const SurfaceShape& shape, double speed);

}  // namespace rollfem::fem

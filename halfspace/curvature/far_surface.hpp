// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of CurvedBody that comes from the surface beyond a rectangle around the contact: there
// the strain of the half-space is that of a few point loads, and the integral over the rest of the
// plane is a small symmetric matrix.
#pragma once

#include "halfspace/curvature/curved_body.hpp"

#include <Eigen/Core>

namespace rollfem::halfspace {

class FarSurface {
 public:
  /// `half_length`, `half_width`: mm, of the rectangle around the middle of the grid, covered by
  /// the near part.
  FarSurface(const contact::ContactGrid& grid, const BodySurface& surface, double half_length,
             double half_width);

  /// Adds the displacement (mm) under tractions (MPa).
  void add(const contact::SurfaceField& traction, contact::SurfaceField& displacement) const;

 private:
  contact::ContactGrid grid_;
  Eigen::MatrixXd along_x_;  ///< Lagrange polynomials of the nodes at the columns of the grid
  Eigen::MatrixXd along_y_;  ///< and at its rows
  Eigen::MatrixXd matrix_;   ///< forces at the nodes (x, then y, then n) to displacements
};

}  // namespace rollfem::halfspace

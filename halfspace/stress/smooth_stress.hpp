// SPDX-License-Identifier: LGPL-2.1-or-later
// The smooth part of the difference in displacement and stress below the surface between a curved,
// finite body and its half-space, the counterpart of elasticity/smooth_map.hpp below the surface:
// moments of the tractions in, polynomials in x, y and depth out.
#pragma once

#include "halfspace/elasticity/smooth_map.hpp"
#include "halfspace/stress/subsurface.hpp"

namespace rollfem::halfspace {

/// Displacement along rolling, across and along the normal into the wheel, and the stress xx yy zz
/// xy yz xz along these.
inline constexpr int smooth_components = 9;

/// Values of the polynomials of total degree up to `degree` at a point with a depth from 0 to
/// `depth` mm. Points outside box and depth are moved to the nearest limit.
Eigen::VectorXd depth_polynomials(const SmoothBox& box, double depth, int degree,
                                  const SubsurfacePoint& at);
/// Number of polynomials.
Eigen::Index depth_polynomial_count(int degree);

/// Difference between one body and its half-space under the tractions of a grid.
class SmoothStressOnGrid {
 public:
  /// `map` is not empty.
  SmoothStressOnGrid(const SmoothDepthMap& map, const contact::ContactGrid& grid,
                     const contact::SurfaceField& traction);
  /// Adds the difference to the state at a point. Outside the box it fades with the square of the
  /// distance.
  void add(const SubsurfacePoint& at, SubsurfaceState& state) const;

 private:
  SmoothBox fields_;
  double depth_;
  int degree_;
  Eigen::MatrixXd coefficients_;  ///< a column for each component
};

}  // namespace rollfem::halfspace

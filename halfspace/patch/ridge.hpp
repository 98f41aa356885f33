// SPDX-License-Identifier: LGPL-2.1-or-later
// The line across a patch along which wheel and rail are closest: x = 0 unless there is yaw. Used
// by the strip model and by the search for the extent of a patch.
#pragma once

#include "base/grid.hpp"
#include "scene/patch_geometry.hpp"

#include <vector>

namespace rollfem::halfspace {

/// Undeformed distance around its minimum along x: distance + curvature (x - x_m)^2.
struct RidgePoint {
  double x = 0.0;          ///< x_m, mm
  double distance = 0.0;   ///< mm
  double curvature = 0.0;  ///< A, 1/mm: 1/(2 rho) of the wheel's local radius
};

/// At the lateral coordinate y (mm). The distance is infinite where the wheel has no surface.
RidgePoint ridge_point(const contact::PatchGeometry& patch, double y);

/// A run of y in which the ridge is below a level.
struct RidgeRegion {
  double y_lower = 0.0, y_upper = 0.0;  ///< mm
  double x_lower = 0.0, x_upper = 0.0;  ///< mm, where the distance is below the level
  double angle = 0.0;                   ///< rad, slope angle of the rail at the least distance
  double distance = 0.0;                ///< mm, the least
};

struct Box {
  double x_lower = 0.0, x_upper = 0.0, y_lower = 0.0, y_upper = 0.0;  ///< mm
};

/// The ranges in which the ridge is below a level.
struct Overlap {
  std::vector<RidgeRegion> regions;  ///< by increasing y
  Box box;                           ///< that contains them
  double gaps = 0.0;                 ///< mm of y between them
  double covered() const { return box.y_upper - box.y_lower - gaps; }
};

/// The ridge sampled over the known range of both profiles within this contact
/// (PatchGeometry::limits).
class Ridge {
 public:
  /// Throws contact::SolveError where there is none at the reference point.
  explicit Ridge(const contact::PatchGeometry& patch);

  Overlap overlap(double level) const;
  double least_distance() const;                            ///< mm
  const std::vector<double>& places() const { return y_; }  ///< y of the samples, mm
  const std::vector<RidgePoint>& points() const { return points_; }

 private:
  std::vector<double> y_;
  std::vector<RidgePoint> points_;
  std::vector<double> angle_;
  /// Distances over x (x_along) where the ridge is low, for bodies that change along the way.
  std::vector<std::vector<double>> along_;
  void look_along(const contact::PatchGeometry& patch);
};

// Places beside a solved patch where wheel and rail touch again or nearly do.

/// Normal displacement at (x, y) by pressure elsewhere on the grid, with each element as a point
/// load on the half-space of this contact modulus, mm.
double displacement_beside(double x, double y, const contact::ContactGrid& grid,
                           const contact::Field& pressure, double modulus);

/// `patch`, extended to the places beside it where the gap falls again and the bodies would overlap
/// at this approach (mm) if half-spaces were not displaced there: finite bodies may be displaced by
/// far less than half-spaces, or the other way.
Box with_near_misses(const Box& patch, const Ridge& ridge, double approach,
                     const contact::ContactGrid& grid, const contact::Field& pressure,
                     double modulus);

}  // namespace rollfem::halfspace

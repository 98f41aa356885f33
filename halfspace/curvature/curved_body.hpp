// SPDX-License-Identifier: LGPL-2.1-or-later
// The difference between a gently curved body and a half-space, to first order in its height over
// the tangent plane. The half-space field leaves tractions on the true surface; one more half-space
// solution removes them (docs/theory.md, "Bodies that curve gently").
#pragma once

#include "base/grid.hpp"
#include "base/material.hpp"

#include <functional>
#include <limits>
#include <memory>

namespace rollfem::halfspace {

/// A body in the frame of the contact: x and y of the contact grid, z into the body.
struct BodySurface {
  contact::Material material;  ///< elastic
  /// Depth of the surface in the body at (x, y), mm; > 0 beside the middle of a convex one.
  std::function<double(double x, double y)> height;
  /// Slopes dz/dx, dz/dy of the surface that defines normal and tangents of tractions and
  /// displacements.
  std::function<double(double x)> slope_x;
  std::function<double(double y)> slope_y;
  /// Extent of the curved surface in x and y from the contact, mm; beyond it the body is a
  /// half-space.
  double extent = std::numeric_limits<double>::infinity();
};

/// The first-order correction C of one body: tractions on it (MPa, n > 0 presses it inwards) to
/// displacement of its surface (mm, n > 0 inwards). Linear and symmetric to rounding.
class CurvedBody {
 public:
  CurvedBody(const contact::ContactGrid& grid, const BodySurface& surface);
  ~CurvedBody();
  CurvedBody(CurvedBody&&) noexcept;

  struct Displacement {
    contact::SurfaceField plane;       ///< of the half-space
    contact::SurfaceField correction;  ///< the effect of the curved surface
  };
  Displacement apply(const contact::SurfaceField& traction) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rollfem::halfspace

// SPDX-License-Identifier: LGPL-2.1-or-later
// The difference between a gently curved body and a half-space, to first order in its height over
// the tangent plane. The half-space field leaves tractions on the true surface; one more half-space
// solution removes them (docs/theory.md, "Bodies that curve gently").
#pragma once

#include "contact/base/grid.hpp"
#include "contact/base/material.hpp"

#include <Eigen/Core>

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

// The part of CurvedBody that comes from the surface beyond a rectangle around the contact: there
// the strain of the half-space is that of a few point loads, and the integral over the rest of the
// plane is a small symmetric matrix (far_surface.cpp).

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

// Gradients and means of element values, taken at the corners shared by four elements, and the
// transposes of both: first-order operators built from them are symmetric on the grid.

/// One value per element or inner corner, first index along x.
using Plane = Eigen::ArrayXXd;

struct Corners {
  double dx = 0.0;  ///< mm
  double dy = 0.0;

  /// d/dx, d/dy and mean at the corners; one value less in each direction.
  Plane along_x(const Plane& u) const;
  Plane along_y(const Plane& u) const;
  static Plane mean(const Plane& u);
  // The transposes, from corners to elements.
  Plane from_x(const Plane& m) const;
  Plane from_y(const Plane& m) const;
  static Plane from_mean(const Plane& m);
};

}  // namespace rollfem::halfspace

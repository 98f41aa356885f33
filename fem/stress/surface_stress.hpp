// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress at the contact surface of a finite-element body: the tractions are known there, so that
// only the strain within the surface comes from the elements.
#pragma once

#include "fem/discretisation/body_points.hpp"
#include "result/stress_measures.hpp"
#include "scene/contact_surface.hpp"

namespace rollfem::fem {

/// Depth in cells up to which a point is on the surface: deviation of a curved element from it.
inline constexpr double surface_depth = 1e-3;

/// The points of a list that lie on the contact surface of a body.
class SurfaceStress {
 public:
  /// The body of `locator` must outlive this object. `grid` and `surface` as in SurfaceCoupling.
  /// Collective.
  SurfaceStress(const Body& body, const BodyLocator& locator, const BodyPoints& points,
                const contact::ContactGrid& grid, const contact::ContactSurface& surface);
  /// Replaces the recovered stress, xx yy zz xy yz xz of every point (MPa, global): the three
  /// components on the surface equal the tractions on the wheel (zero outside the patch), the other
  /// three follow by Hooke's law from them and the strain within the surface, a difference of the
  /// displacement over one cell (where the body ends within that cell, the strain of the recovered
  /// stress). Collective.
  void combine(const Vector& displacement, const contact::SurfaceField& traction,
               std::vector<contact::SymmetricTensor>& stress) const;

 private:
  const Body& body_;
  contact::ContactGrid grid_;
  contact::ContactSurface surface_;
  std::vector<std::size_t> on_surface_;  ///< numbers in the list
  std::vector<Place> places_;            ///< of these
  std::array<BodyPoints, 4> around_;     ///< half a cell ahead, behind, to both sides
};

}  // namespace rollfem::fem

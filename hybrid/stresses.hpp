// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement and stress below the surface by the hybrid: the half-space's integrals in
// coordinates that follow the surface of the body, plus the smooth correction.
#pragma once

#include "contact/result/result.hpp"
#include "contact/scene/below_surface.hpp"
#include "halfspace/elasticity/smooth_map.hpp"

#include <string>
#include <vector>

namespace rollfem::hybrid {

class Stresses {
 public:
  /// What the scene asks for. Both must outlive this; of the parts those below the surface are
  /// empty for bodies that are half-spaces.
  Stresses(const contact::Scene& scene, const halfspace::SmoothParts& parts);

  /// `subsurface` and `stress_maxima` of a load point solved on the grid; the latter with their
  /// places rolled out (x, arc length, depth above 0 in the wheel). Throws contact::InputError for
  /// places outside of their body by more than an eighth of the smaller semi-axis (nearer ones are
  /// moved onto its surface), and so deep below a steep surface that its normals meet.
  void add(const contact::ContactGrid& grid, contact::PointResult& point) const;
  /// Places of the largest stresses in space, and their bars, if there are any, with a part of what
  /// the bodies have beyond half-spaces: `part` of that, and of `relative` (what that changes of
  /// the tractions, as a part of them).
  void finish(const contact::ContactGrid& grid, double part, double relative,
              contact::PointResult& point) const;
  /// The place `depth` mm below the surface of a body at (x, y) of the contact grid.
  contact::Vector3 place(bool wheel, double x, double y, double depth) const {
    return (wheel ? wheel_ : rail_).place(x, y, depth);
  }

 private:
  struct Lists;
  Lists lists(const contact::SubsurfaceRequest& request, std::size_t number) const;
  struct LoadedBody;
  struct Bodies;
  /// Under the tractions of a load point.
  Bodies bodies(const contact::ContactGrid& grid, const contact::SurfaceField& traction) const;
  contact::SubsurfaceField field(const contact::SubsurfaceRequest& request, std::size_t number,
                                 const LoadedBody& body) const;

  const contact::Scene& scene_;
  const halfspace::SmoothParts& parts_;
  contact::ChartedGeometry geometry_;
  contact::BelowSurface wheel_, rail_;
  double reach_;  ///< mm
};

}  // namespace rollfem::hybrid

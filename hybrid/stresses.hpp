// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement and stress below the surface by the model hybrid: the half-space's integrals in
// coordinates that follow the surface of the body, plus the smooth correction.
#pragma once

#include "hybrid/smooth_map.hpp"
#include "result/result.hpp"
#include "scene/below_surface.hpp"

#include <string>
#include <vector>

namespace rollfem::hybrid {

class Stresses {
 public:
  /// Stresses requested by the scene. Both arguments must outlive this object; the subsurface parts
  /// are empty for bodies that are half-spaces.
  Stresses(const contact::Scene& scene, const SmoothParts& parts);

  /// `subsurface` and `stress_maxima` of a load point solved on the grid; the latter at rolled-out
  /// positions (x, arc length, depth, positive in the wheel). Throws contact::InputError for points
  /// outside their body by more than an eighth of the smaller semi-axis (closer ones are moved onto
  /// the surface), and for points so deep below a steep surface that its normals intersect.
  void add(const contact::ContactGrid& grid, contact::PointResult& point) const;
  /// Moves the largest stresses to their positions in space and widens their error bars, if there
  /// are any, by the fraction `part` of the correction to the half-space and of `relative` (the
  /// relative change of the tractions by the correction).
  void finish(const contact::ContactGrid& grid, double part, double relative,
              contact::PointResult& point) const;
  /// The point `depth` mm below the surface of a body at (x, y) of the contact grid.
  contact::Vector3 place(bool wheel, double x, double y, double depth) const {
    return (wheel ? wheel_ : rail_).place(x, y, depth);
  }

 private:
  struct Lists;
  Lists lists(const contact::SubsurfaceRequest& request, std::size_t number) const;
  struct CorrectedBody;
  struct Bodies;
  /// Under the tractions of a load point.
  Bodies bodies(const contact::ContactGrid& grid, const contact::SurfaceField& traction) const;
  contact::SubsurfaceField field(const contact::SubsurfaceRequest& request, std::size_t number,
                                 const CorrectedBody& body) const;

  const contact::Scene& scene_;
  const SmoothParts& parts_;
  contact::ChartedGeometry geometry_;
  contact::BelowSurface wheel_, rail_;
  double reach_;  ///< mm
};

}  // namespace rollfem::hybrid

// SPDX-License-Identifier: LGPL-2.1-or-later
// The flattened twin of a body: the same mesh with the contact surface unrolled into a plane. Its
// exact compliance is the half-space's, so that the error of finite elements on the twin equals
// that on the body, up to the curvature.
#pragma once

#include "fem/mesh/surface_shape.hpp"
#include "scene/contact_surface.hpp"
#include "scene/height_curve.hpp"
#include "scene/scene.hpp"

namespace rollfem::hybrid {

/// Arc length of the common surface across, from y = 0, mm.
class ArcLength {
 public:
  /// Exact up to `reach` mm to both sides, straight beyond.
  ArcLength(const contact::ContactSurface& surface, double reach);
  double at(double y) const;
  /// y of an arc length.
  double place(double arc) const;

 private:
  contact::HeightCurve arc_;
};

/// The chart of the twin of `shape`: (s, t, depth) lies at s along rolling, at the arc length of
/// the common surface at t across, and at `depth` inwards. `reach`: extent of the body in t, mm.
fem::SurfaceShape flat_twin(const fem::SurfaceShape& shape, const contact::ContactSurface& surface,
                            double reach);

/// Wheel and rail are boxes under their surface; the twins differ from them in that surface only.
bool has_boxes(const contact::Scene& scene);

/// The scene of the twins: other bodies are replaced by boxes. Like half-spaces they are solid and
/// move at their far boundary.
contact::Scene with_boxes(const contact::Scene& scene);

}  // namespace rollfem::hybrid

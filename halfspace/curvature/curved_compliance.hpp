// SPDX-License-Identifier: LGPL-2.1-or-later
// The half-space's compliance with the first-order curvature correction of
// both bodies (curved_body.hpp), without a mesh.
#pragma once

#include "contact/iteration/compliance.hpp"
#include "halfspace/curvature/curved_body.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "scene/scene.hpp"

#include <optional>

namespace rollfem::halfspace {

class CurvedCompliance : public contact::Compliance {
 public:
  /// For the wheel and rail of a scene with known surfaces. Throws contact::InputError if a
  /// quadratic form or a file replaces them.
  CurvedCompliance(const contact::Scene& scene, const contact::ContactGrid& grid);

  const contact::ContactGrid& grid() const override { return half_.grid(); }
  contact::SurfaceField apply(const contact::SurfaceField& traction) const override;
  /// With the slip u_n / R of the wheel's surface along its circles.
  contact::Response respond(const contact::SurfaceField& traction) const override;

 private:
  HalfspaceCompliance half_;
  double rolling_radius_, rail_rolling_radius_;
  std::optional<CurvedBody> wheel_;  ///< none: rigid
  std::optional<CurvedBody> rail_;
};

/// Throws contact::InputError if a quadratic form or a file replaces wheel and rail.
void check_bodies_known(const contact::Scene& scene);

/// A body of a scene as input of CurvedBody.
BodySurface body_surface(const contact::Scene& scene, bool wheel);

}  // namespace rollfem::halfspace

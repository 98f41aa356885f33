// SPDX-License-Identifier: LGPL-2.1-or-later
// The hybrid's compliance on a contact grid along the common surface: the half-space's compliance
// plus the correction for wheel and rail.
#pragma once

#include "contact/iteration/compliance.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "hybrid/smooth_map.hpp"
#include "scene/geometry.hpp"
#include "scene/scene.hpp"

#include <memory>
#include <optional>

namespace rollfem::hybrid {

class HybridCompliance : public contact::Compliance {
 public:
  HybridCompliance(const contact::Scene& scene, const contact::ChartedGeometry& geometry,
                   const contact::ContactGrid& grid, const SmoothParts& parts);
  const contact::ContactGrid& grid() const override { return half_.grid(); }
  contact::SurfaceField apply(const contact::SurfaceField& traction) const override;
  /// With the curvature slip of the wheel.
  contact::Response respond(const contact::SurfaceField& traction) const override;

 private:
  halfspace::HalfspaceCompliance half_;
  /// The response of one body that turns about its axle.
  struct Turning {
    halfspace::HalfspaceCompliance half;
    contact::CurvatureSlip curvature_slip;
  };
  std::unique_ptr<Turning> turning_wheel_, turning_rail_;
  std::unique_ptr<SmoothMapOnGrid> wheel_;
  std::unique_ptr<SmoothMapOnGrid> rail_;
};

}  // namespace rollfem::hybrid

#include "contact/scene/curvature_slip.hpp"

#include <cmath>

namespace rollfem::contact {

CurvatureSlip::CurvatureSlip(const ContactSurface& surface, const ContactGrid& grid)
    : CurvatureSlip(patch_shape(surface, grid),
                    grid.sample([&](double, double y) { return surface.local_rolling_radius(y); }),
                    surface.axle_tilt()) {}

CurvatureSlip::CurvatureSlip(const PatchShape& shape, const Field& rolling_radius,
                             double axle_tilt) {
  const double sine = std::sin(axle_tilt);
  const double cosine = std::cos(axle_tilt);
  const Field radius = shape.stretch.cwiseProduct(rolling_radius);
  normal_ = (cosine + shape.climb.array() * sine).matrix().cwiseQuotient(radius);
  lateral_ = (shape.climb.array() * cosine - sine).matrix().cwiseQuotient(radius);
}

TangentialField CurvatureSlip::operator()(const SurfaceField& displacement) const {
  return {displacement.n.cwiseProduct(normal_) + displacement.y.cwiseProduct(lateral_),
          -displacement.x.cwiseProduct(lateral_)};
}

}  // namespace rollfem::contact

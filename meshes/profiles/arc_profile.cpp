#include "meshes/profiles/arc_profile.hpp"

#include "contact/base/errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::meshes {

ArcProfile::ArcProfile(double radius) : radius_(radius) {
  if (std::isnan(radius) || radius == 0.0)
    throw contact::InputError(fmt::format(
        "transverse radius {}: allowed: any number but 0, > 0 convex, < 0 concave, inf straight",
        radius));
}

double ArcProfile::checked_root(double y) const {
  const double ratio = y / radius_;
  if (!(std::abs(ratio) < 1.0))
    throw contact::InputError(
        fmt::format("a profile of radius {} mm has no surface at y = {} mm; allowed: |y| < {} mm",
                    radius_, y, std::abs(radius_)));
  return std::sqrt((1.0 - ratio) * (1.0 + ratio));
}

double ArcProfile::drop(double y) const {
  if (std::isinf(radius_)) return 0.0;
  // R (1 - root) without the cancellation at small y.
  return y * y / (radius_ * (1.0 + checked_root(y)));
}

double ArcProfile::slope(double y) const {
  if (std::isinf(radius_)) return 0.0;
  return y / (radius_ * checked_root(y));
}

double ArcProfile::curvature() const {
  return 1.0 / radius_;
}

}  // namespace rollfem::meshes

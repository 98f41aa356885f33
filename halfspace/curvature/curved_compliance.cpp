// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/curvature/curved_compliance.hpp"

#include "base/errors.hpp"
#include "base/profile_drop.hpp"
#include "halfspace/patch/patch_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;
using contact::Scene;
using contact::SurfaceField;

namespace {

/// The curvature at the contact does not describe the distant body: heights are limited to this
/// fraction of the distance.
constexpr double steepest_way = 0.5;

/// Extent of the true shape in the default finite-element bodies (without [fem] extent), in larger
/// semi-axes of the patch.
constexpr double extent_in_semi_axes = 8.0;

double extent_of_bodies(const Scene& scene) {
  if (scene.body_extent) return *scene.body_extent;
  const ExpectedPatch patch = PatchSearch(scene).patch();
  return extent_in_semi_axes * 0.5 * std::max(patch.length, patch.width);
}

}  // namespace

void check_bodies_known(const Scene& scene) {
  if (scene.geometry.has_surfaces()) return;
  throw contact::InputError(
      scene.where(),
      "halfspace.model_error = true: only the undeformed distance of the bodies is known; "
      "allowed: wheel and rail with radii or profiles; do: give those, or remove model_error");
}

BodySurface body_surface(const Scene& scene, bool wheel) {
  check_bodies_known(scene);
  const contact::ContactSurface surface = scene.geometry.surface;
  const double along = wheel ? surface.rolling_radius : surface.rail_rolling_radius;
  const double sign = wheel ? 1.0 : -1.0;
  BodySurface body;
  body.material = (wheel ? scene.wheel : scene.rail).material;
  body.height = [=](double x, double y) {
    const double most = steepest_way * std::hypot(x, y);
    const double height =
        contact::surface_drop(surface, wheel, 0.0, y) + contact::profile_drop(along, x).value;
    return std::clamp(height, -most, most);
  };
  body.extent = extent_of_bodies(scene);
  // Each body uses the frame of its own streamline along rolling, and both use the common surface
  // across.
  body.slope_x = [=](double x) { return std::isfinite(along) ? x / along : 0.0; };
  body.slope_y = [=](double y) { return sign * surface.climb(y); };
  return body;
}

CurvedCompliance::CurvedCompliance(const Scene& scene, const ContactGrid& grid)
    : half_(grid, scene.material),
      rolling_radius_(scene.geometry.surface.rolling_radius),
      rail_rolling_radius_(scene.geometry.surface.rail_rolling_radius) {
  check_bodies_known(scene);
  if (!scene.wheel.material.rigid()) wheel_.emplace(grid, body_surface(scene, true));
  if (!scene.rail.material.rigid()) rail_.emplace(grid, body_surface(scene, false));
}

SurfaceField CurvedCompliance::apply(const SurfaceField& traction) const {
  return respond(traction).displacement;
}

contact::Response CurvedCompliance::respond(const SurfaceField& traction) const {
  contact::Response response{half_.apply(traction), {}};
  SurfaceField& u = response.displacement;
  const Field zero = Field::Zero(grid().size());
  response.curvature_slip = {zero, zero};
  if (wheel_) {
    const CurvedBody::Displacement own = wheel_->apply(traction);
    u.x += own.correction.x;
    u.y += own.correction.y;
    u.n += own.correction.n;
    response.curvature_slip.x = own.plane.n / rolling_radius_;
  }
  if (rail_) {
    // In the rail's frame z is reversed: pressure keeps its sign, tangential tractions change it.
    const CurvedBody::Displacement own = rail_->apply({-traction.x, -traction.y, traction.n});
    u.x -= own.correction.x;
    u.y -= own.correction.y;
    u.n += own.correction.n;
    response.curvature_slip.x -= own.plane.n / rail_rolling_radius_;
  }
  return response;
}

}  // namespace rollfem::halfspace

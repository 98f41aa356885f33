// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hybrid/compliance.hpp"

#include <cmath>

namespace rollfem::hybrid {

using contact::SurfaceField;

namespace {

void add(SurfaceField& field, const SurfaceField& more) {
  field.x += more.x;
  field.y += more.y;
  field.n += more.n;
}

}  // namespace

HybridCompliance::HybridCompliance(const contact::Scene& scene,
                                   const contact::ChartedGeometry& geometry,
                                   const contact::ContactGrid& grid,
                                   const halfspace::SmoothParts& parts)
    : half_(grid, scene.material) {
  if (!parts.wheel.empty())
    wheel_ = std::make_unique<halfspace::SmoothMapOnGrid>(parts.wheel, grid);
  if (!parts.rail.empty()) rail_ = std::make_unique<halfspace::SmoothMapOnGrid>(parts.rail, grid);
  const contact::ContactSurface& surface = scene.geometry.surface;
  if (!wheel_ || !std::isfinite(surface.rolling_radius)) return;
  wheel_half_ = std::make_unique<halfspace::HalfspaceCompliance>(
      grid, contact::combine(scene.wheel.material, contact::rigid_material()));
  const auto along = [&](auto&& value) {
    return grid.sample([&](double, double s) { return value(geometry.lateral_place(s)); });
  };
  contact::PatchShape shape;
  shape.climb = along([&](double y) { return surface.climb(y); });
  shape.stretch = along([&](double y) { return contact::stretch_of(surface.climb(y)); });
  curvature_slip_.emplace(shape, along([&](double y) { return surface.local_rolling_radius(y); }),
                          surface.axle_tilt());
}

SurfaceField HybridCompliance::apply(const SurfaceField& traction) const {
  return respond(traction).displacement;
}

contact::Response HybridCompliance::respond(const SurfaceField& traction) const {
  contact::Response response{half_.apply(traction), {}};
  if (wheel_) {
    const SurfaceField beyond = wheel_->apply(traction);
    add(response.displacement, beyond);
    if (wheel_half_) {
      SurfaceField u = wheel_half_->apply(traction);
      add(u, beyond);
      response.curvature_slip = (*curvature_slip_)(u);
    }
  }
  if (rail_) add(response.displacement, rail_->apply(traction));
  return response;
}

}  // namespace rollfem::hybrid

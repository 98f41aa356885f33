// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hybrid/hybrid_compliance.hpp"

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
                                   const contact::ContactGrid& grid, const SmoothParts& parts)
    : half_(grid, scene.material) {
  if (!parts.wheel.empty()) wheel_ = std::make_unique<SmoothMapOnGrid>(parts.wheel, grid);
  if (!parts.rail.empty()) rail_ = std::make_unique<SmoothMapOnGrid>(parts.rail, grid);
  const contact::ContactSurface& surface = scene.geometry.surface;
  const auto along = [&](auto&& value) {
    return grid.sample([&](double, double s) { return value(geometry.lateral_place(s)); });
  };
  contact::PatchShape shape;
  shape.climb = along([&](double y) { return surface.climb(y); });
  shape.stretch = along([&](double y) { return contact::stretch_of(surface.climb(y)); });
  if (wheel_ && std::isfinite(surface.rolling_radius))
    turning_wheel_.reset(
        new Turning{{grid, contact::combine(scene.wheel.material, contact::rigid_material())},
                    {shape, along([&](double y) { return surface.local_rolling_radius(y); }),
                     surface.axle_tilt()}});
  if (rail_ && surface.rail_is_roller())
    turning_rail_.reset(
        new Turning{{grid, contact::combine(contact::rigid_material(), scene.rail.material)},
                    {shape, along([&](double y) { return -surface.local_rail_radius(y); }),
                     surface.rail_tilt()}});
}

SurfaceField HybridCompliance::apply(const SurfaceField& traction) const {
  return respond(traction).displacement;
}

contact::Response HybridCompliance::respond(const SurfaceField& traction) const {
  contact::Response response{half_.apply(traction), {}};
  const auto add_body = [&](const auto& parts, const std::unique_ptr<Turning>& turning) {
    if (!parts) return;
    const SurfaceField beyond = parts->apply(traction);
    add(response.displacement, beyond);
    if (!turning) return;
    SurfaceField u = turning->half.apply(traction);
    add(u, beyond);
    contact::TangentialField slip = turning->curvature_slip(u);
    if (response.curvature_slip.x.size() == 0)
      response.curvature_slip = std::move(slip);
    else
      response.curvature_slip = {response.curvature_slip.x + slip.x,
                                 response.curvature_slip.y + slip.y};
  };
  add_body(wheel_, turning_wheel_);
  add_body(rail_, turning_rail_);
  return response;
}

}  // namespace rollfem::hybrid

#include "hybrid/compliance.hpp"

#include <cmath>

namespace rollfem::hybrid {

using contact::SurfaceField;

namespace {

contact::Material rigid() {
  contact::Material material;
  material.young_modulus = contact::infinity;
  return material;
}

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
      grid, contact::combine(scene.wheel.material, rigid()));
  const double tilt_sine = std::sin(surface.axle_tilt());
  const double tilt_cosine = std::cos(surface.axle_tilt());
  const auto along = [&](double numerator_at, double y) {
    return numerator_at / contact::stretch_of(surface.climb(y)) / surface.local_rolling_radius(y);
  };
  towards_axle_n_ = grid.sample([&](double, double s) {
    const double y = geometry.lateral_place(s);
    return along(tilt_cosine + surface.climb(y) * tilt_sine, y);
  });
  towards_axle_y_ = grid.sample([&](double, double s) {
    const double y = geometry.lateral_place(s);
    return along(surface.climb(y) * tilt_cosine - tilt_sine, y);
  });
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
      response.curvature_slip = {
          u.n.cwiseProduct(towards_axle_n_) + u.y.cwiseProduct(towards_axle_y_),
          -u.x.cwiseProduct(towards_axle_y_)};
    }
  }
  if (rail_) add(response.displacement, rail_->apply(traction));
  return response;
}

}  // namespace rollfem::hybrid

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/contact_surface.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace rollfem::contact {

namespace {

/// Height z of the wheel over (x, y), with dz/dy at x = 0; without profiles.
CurveValue wheel_height(const ContactSurface& surface, double x, double y) {
  const ProfileDrop drop = surface.wheel_drop(y);
  const double radius = surface.rolling_radius - drop.value;
  return {drop.value + circle_drop(radius, x), drop.slope, 0.0};
}

CurveValue rail_height(const ContactSurface& surface, double x, double y) {
  if (surface.profiles) {
    CurveValue height = surface.profiles->rail().at(y);
    if (surface.profiles->is_roller() || surface.profiles->varies())
      height.value = surface.profiles->rail_height(x, y);
    return height;
  }
  const ProfileDrop drop = surface.rail_drop(y);
  return {-drop.value - circle_drop(surface.local_rail_radius(y), x), -drop.slope, 0.0};
}

/// Distance along the normal of the common surface at y to a surface of the given height, by
/// Newton's method; the approximation of the slope (relative error x^2 / R^2) slows convergence but
/// does not affect the result.
template <class HeightAt>
double way_along_normal(const ContactSurface& surface, double y, HeightAt&& height_at) {
  const double climb = surface.climb(y);
  const double stretch = stretch_of(climb);
  const double start = surface.height(y);
  double way = 0.0;
  for (int step = 0; step < 30; ++step) {
    const CurveValue height = height_at(y - climb * way / stretch);
    const double change =
        (height.value - (start + way / stretch)) * stretch / (1.0 + climb * height.slope);
    way += change;
    if (std::abs(change) < 1e-15 * (1.0 + std::abs(way))) break;
  }
  return way;
}

/// Distance along the normal of the common surface at (x, y) to the wheel as a surface of
/// revolution at its height under load, and back by the approach along that normal; by Newton's
/// method, infinite where there is none.
double way_to_profile(const ContactSurface& surface, double x, double y) {
  const PatchGeometry& profiles = *surface.profiles;
  const double climb = surface.climb(y);
  const double stretch = stretch_of(climb);
  const double start = surface.height(y);
  const Vector3 normal{0.0, -climb / stretch, 1.0 / stretch};
  const Sinking& sunk = profiles.sinking();
  const Vector3 from{x, y - sunk.way[0], start - sunk.way[1]};
  const double back = sunk.approach[0] * normal[1] + sunk.approach[1] * normal[2];
  double way = (profiles.wheel().at(y).value - start) / stretch - back +
               0.5 * x * x / (surface.rolling_radius * stretch);
  for (int step = 0; step < 40; ++step) {
    const AxlePlace at =
        profiles.axle_place({x, from[1] + way * normal[1], from[2] + way * normal[2]});
    // A change along the circle slows convergence but does not affect the result.
    const RadiusAround wheel = profiles.radius_around(at);
    const double by_way = dot(at.across, normal) / at.radius -
                          wheel.by_axial * dot(profiles.axle().direction, normal);
    if (!(by_way < -1e-3)) return infinity;
    const double change = (at.radius - wheel.value) / by_way;
    way -= change;
    // Rounding of a radius of 500 mm is 1e-13 mm.
    if (std::abs(change) < 1e-11 * (1.0 + std::abs(way))) return way + back;
  }
  return infinity;
}

}  // namespace

double stretch_of(double climb) {
  return std::sqrt(1.0 + climb * climb);
}

double ContactSurface::climb(double y) const {
  if (profiles)
    return 0.5 * follows * (profiles->wheel_under_load(y).slope + profiles->rail().at(y).slope);
  return 0.5 * follows * (wheel_drop(y).slope - rail_drop(y).slope);
}

double ContactSurface::height(double y) const {
  if (profiles)
    return 0.5 * follows * (profiles->wheel_under_load(y).value + profiles->rail().at(y).value);
  return 0.5 * follows * (wheel_drop(y).value - rail_drop(y).value);
}

double ContactSurface::local_rolling_radius(double y) const {
  if (profiles) return profiles->local_rolling_radius(y);
  return rolling_radius - wheel_drop(y).value;
}

double ContactSurface::local_rail_radius(double y) const {
  if (!std::isfinite(rail_rolling_radius)) return rail_rolling_radius;
  if (profiles) return profiles->local_rail_radius(y);
  return rail_rolling_radius - rail_drop(y).value;
}

ProfileDrop ContactSurface::wheel_drop(double y) const {
  return profile_drop(wheel_transverse_radius, y, wheel_round_to);
}

ProfileDrop ContactSurface::rail_drop(double y) const {
  return profile_drop(rail_transverse_radius, y, rail_round_to);
}

double ContactSurface::relative_rolling_radius() const {
  return rail_is_roller() ? 1.0 / (1.0 / rolling_radius + 1.0 / local_rail_radius(0.0))
                          : rolling_radius;
}

double ContactSurface::axle_tilt() const {
  return profiles ? profiles->tilt() : 0.0;
}

double ContactSurface::rail_tilt() const {
  return profiles && profiles->is_roller() ? profiles->rail_tilt() : 0.0;
}

bool ContactSurface::known(double y) const {
  return !profiles || profiles->known(y);
}

ContactSurface ContactSurface::of(std::shared_ptr<const PatchGeometry> patch) {
  const double radius = patch->local_rolling_radius(0.0);
  const double rail_radius = patch->rail_rolling_radius();
  ContactSurface surface{radius, infinity, infinity, std::move(patch)};
  surface.rail_rolling_radius = rail_radius;
  return surface;
}

double surface_drop(const ContactSurface& surface, bool wheel, double x, double y) {
  if (!wheel)
    return std::abs(x) < std::abs(surface.local_rail_radius(y)) ? -rail_height(surface, x, y).value
                                                                : infinity;
  if (surface.profiles) return surface.profiles->wheel_height(x, y);
  if (!(std::abs(x) < surface.local_rolling_radius(y))) return infinity;
  return wheel_height(surface, x, y).value;
}

PatchShape patch_shape(const ContactSurface& surface, const ContactGrid& grid) {
  // Four-point Gauss rule: exact to rounding on elements that are small compared with the radii.
  constexpr std::array<double, 2> points{0.8611363115940526, 0.3399810435848563};
  constexpr std::array<double, 2> weights{0.3478548451374538, 0.6521451548625461};
  const auto mean = [&](double y, auto&& function) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 2; ++k)
      for (const double side : {-1.0, 1.0})
        sum += 0.5 * weights[k] * function(y + side * 0.5 * grid.dy * points[k]);
    return sum;
  };
  const auto climb = [&](double y) { return surface.climb(y); };
  PatchShape shape;
  shape.climb = grid.sample([&](double, double y) { return mean(y, climb); });
  shape.stretch = grid.sample(
      [&](double, double y) { return mean(y, [&](double at) { return stretch_of(climb(at)); }); });
  return shape;
}

double undeformed_distance(const ContactSurface& surface, double x, double y) {
  const double rail =
      way_along_normal(surface, y, [&](double at) { return rail_height(surface, x, at); });
  if (surface.profiles) return way_to_profile(surface, x, y) - rail;
  return way_along_normal(surface, y, [&](double at) { return wheel_height(surface, x, at); }) -
         rail;
}

}  // namespace rollfem::contact

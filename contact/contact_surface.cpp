#include "contact/contact_surface.hpp"

#include <array>
#include <cmath>

namespace rollfem::contact {

namespace {

constexpr double steepest_sine = 0.7;

double stretch_of(double climb) {
  return std::sqrt(1.0 + climb * climb);
}

/// A body's surface as a height z over (x, y).
struct Height {
  double value;
  double slope;  ///< dz/dy at x = 0
};

Height wheel_height(const ContactSurface& surface, double x, double y) {
  const ProfileDrop drop = profile_drop(surface.wheel_transverse_radius, y);
  const double radius = surface.rolling_radius - drop.value;
  // R - sqrt(R^2 - x^2) without cancellation.
  const double rise =
      std::isfinite(radius) ? x * x / (radius + std::sqrt(radius * radius - x * x)) : 0.0;
  return {drop.value + rise, drop.slope};
}

Height rail_height(const ContactSurface& surface, double y) {
  const ProfileDrop drop = profile_drop(surface.rail_transverse_radius, y);
  return {-drop.value, -drop.slope};
}

/// Way along the normal of the common surface at y to a surface of that height, by Newton's method;
/// what the slope leaves out (x^2 / R^2 of it) costs digits of each step, not of the result.
template <class HeightAt>
double way_along_normal(const ContactSurface& surface, double y, HeightAt&& height_at) {
  const double climb = surface.climb(y);
  const double stretch = stretch_of(climb);
  const double start = surface.height(y);
  double way = 0.0;
  for (int step = 0; step < 30; ++step) {
    const Height height = height_at(y - climb * way / stretch);
    const double change =
        (height.value - (start + way / stretch)) * stretch / (1.0 + climb * height.slope);
    way += change;
    if (std::abs(change) < 1e-15 * (1.0 + std::abs(way))) break;
  }
  return way;
}

}  // namespace

ProfileDrop profile_drop(double transverse_radius, double y) {
  if (!std::isfinite(transverse_radius)) return {};
  const double radius = std::abs(transverse_radius);
  const double sign = transverse_radius > 0 ? 1.0 : -1.0;
  const double distance = std::min(std::abs(y), steepest_sine * radius);
  const double root = std::sqrt(1.0 - (distance / radius) * (distance / radius));
  const double slope = distance / (radius * root);
  // y^2 / (R + sqrt(R^2 - y^2)) rather than R - sqrt(R^2 - y^2): no cancellation.
  const double drop =
      distance * distance / (radius * (1.0 + root)) + slope * (std::abs(y) - distance);
  return {sign * drop, sign * (y < 0 ? -slope : slope)};
}

double ContactSurface::climb(double y) const {
  return 0.5 * (profile_drop(wheel_transverse_radius, y).slope -
                profile_drop(rail_transverse_radius, y).slope);
}

double ContactSurface::height(double y) const {
  return 0.5 * (profile_drop(wheel_transverse_radius, y).value -
                profile_drop(rail_transverse_radius, y).value);
}

double ContactSurface::local_rolling_radius(double y) const {
  return rolling_radius - profile_drop(wheel_transverse_radius, y).value;
}

ContactSurface contact_surface(const Case& input) {
  return {input.wheel.rolling_radius, input.wheel.transverse_radius, input.rail.transverse_radius};
}

double surface_drop(const ContactSurface& surface, bool wheel, double x, double y) {
  if (!wheel) return -rail_height(surface, y).value;
  if (!(std::abs(x) < surface.local_rolling_radius(y))) return infinity;
  return wheel_height(surface, x, y).value;
}

PatchShape patch_shape(const ContactSurface& surface, const ContactGrid& grid) {
  // Gauss's rule of four points: exact to rounding on elements that are small beside the radii.
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
  const double wheel =
      way_along_normal(surface, y, [&](double at) { return wheel_height(surface, x, at); });
  const double rail =
      way_along_normal(surface, y, [&](double at) { return rail_height(surface, at); });
  return wheel - rail;
}

TangentialField rigid_slip(const ContactSurface& surface, const Creepage& creepage,
                           const ContactGrid& grid) {
  // omega R(y) = (1 - xi) (1 - drop / R0); 1 less it without cancellation.
  const double turning = 1.0 - creepage.longitudinal;
  TangentialField slip;
  slip.x = grid.sample([&](double, double y) {
    const double drop = profile_drop(surface.wheel_transverse_radius, y).value;
    return creepage.longitudinal + turning * drop / surface.rolling_radius - creepage.spin * y;
  });
  slip.y = grid.sample([&](double x, double y) {
    return (creepage.lateral + creepage.spin * x) / stretch_of(surface.climb(y));
  });
  return slip;
}

}  // namespace rollfem::contact

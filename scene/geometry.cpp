// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/geometry.hpp"

#include "case/lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::contact {

namespace {

/// Distance where the wheel has no surface, mm: practically infinite, but finite because the
/// solvers reject infinity.
constexpr double beyond_the_wheel = 1e3;
/// Step of the arc length, mm.
constexpr double arc_step = 0.05;
/// Extent of a rolled-out surface without profile ends, mm, and the slope at which it ends.
constexpr double farthest = 100.0;
constexpr double steepest_climb = 2.0;

/// Second derivative by y at the contact point; the mean of both sides where the curvature jumps.
double mean_second(const HeightCurve& curve) {
  constexpr double beside = 1e-6;  // mm
  return 0.5 * (curve.at(-beside).second + curve.at(beside).second);
}

/// Curvature of the distance along x, 1/mm, of bodies that change along it: over millimetres.
double curvature_along(const PatchGeometry& patch) {
  constexpr double step = 1.0;  // mm
  return (patch.distance(step, 0.0) - 2.0 * patch.distance(0.0, 0.0) + patch.distance(-step, 0.0)) /
         (step * step);
}

/// Curvatures of the distance at the origin of the patch frame, where both surfaces are level. With
/// F = radius - f(axial) = 0 on the wheel, z_xx = -F_xx / F_z there.
Curvatures curvatures_at_contact_point(const PatchGeometry& patch) {
  const Vector3& e = patch.axle().direction;
  const AxlePlace at = patch.axle_place({0.0, 0.0, patch.wheel().at(0.0).value});
  const CurveValue f = patch.wheel_radius().at(at.axial);
  const auto radial = [&](std::size_t d) { return at.across[d] / at.radius; };
  const double radius_xx = (1.0 - e[0] * e[0] - radial(0) * radial(0)) / at.radius;
  double z_xx = -(radius_xx - f.second * e[0] * e[0]) / (radial(2) - f.slope * e[2]);
  if (patch.varies())
    z_xx = curvature_along(patch);
  else if (patch.is_roller())
    z_xx += patch.rail_axle().direction[1] / patch.local_rail_radius(0.0);
  return {0.5 * z_xx, 0.5 * (mean_second(patch.wheel()) - mean_second(patch.rail()))};
}

/// y over the arc length of the common surface from y = 0.
HeightCurve unrolled(const ContactSurface& surface) {
  std::vector<HeightKnot> knots;
  const auto walk = [&](double direction) {
    double at = 0.0, way = 0.0;
    double stretch = stretch_of(surface.climb(at));
    while (std::abs(at) < farthest) {
      const double next = at + direction * arc_step;
      const double climb = surface.climb(next);
      if (!surface.known(next) || std::abs(climb) > steepest_climb) return;
      const double middle = stretch_of(surface.climb(0.5 * (at + next)));
      way += (next - at) * (stretch + 4.0 * middle + stretch_of(climb)) / 6.0;
      at = next;
      stretch = stretch_of(climb);
      knots.push_back({way, at, 1.0 / stretch});
    }
  };
  walk(-1.0);
  std::reverse(knots.begin(), knots.end());
  knots.push_back({0.0, 0.0, 1.0 / stretch_of(surface.climb(0.0))});
  walk(1.0);
  return HeightCurve(std::move(knots));
}

/// Direction of the wheel's axle.
Vector3 axle_of(const ContactSurface& surface) {
  return surface.profiles ? surface.profiles->axle().direction : Vector3{0.0, 1.0, 0.0};
}

/// The same of a roller.
Vector3 rail_axle_of(const ContactSurface& surface) {
  return surface.profiles && surface.profiles->is_roller() ? surface.profiles->rail_axle().direction
                                                           : Vector3{0.0, 1.0, 0.0};
}

}  // namespace

Geometry::Geometry(const Case& input)
    : quadratic(input.undeformed_distance.quadratic),
      distance_values(input.undeformed_distance.values),
      extra_slip(input.rolling.extra_slip),
      extra_slip_values(input.rolling.extra_slip_values) {
  if (!has_surfaces()) return;
  surface.rolling_radius = input.wheel.rolling_radius > 0.0 ? input.wheel.rolling_radius : infinity;
  surface.wheel_transverse_radius = input.wheel.transverse_radius;
  surface.rail_transverse_radius = input.rail.transverse_radius;
  surface.wheel_round_to = input.wheel.round_to;
  surface.rail_round_to = input.rail.round_to;
  surface.rail_rolling_radius = input.rail.rolling_radius;
  const ContactShapeCase& shape = input.geometry;
  if (shape.shape != ContactShape::line) return;
  // In a line contact only the curvature of the distance matters.
  surface.rolling_radius = shape.relative_radius.value_or(
      1.0 / (1.0 / surface.rolling_radius + 1.0 / surface.rail_rolling_radius));
  surface.rail_rolling_radius = infinity;
  line = LineContact{shape.width, shape.reference_distance.value_or(surface.rolling_radius)};
}

Curvatures relative_curvatures(const Geometry& geometry) {
  if (geometry.has_profiles()) return curvatures_at_contact_point(*geometry.surface.profiles);
  if (geometry.quadratic) return {(*geometry.quadratic)[0], (*geometry.quadratic)[1]};
  const ContactSurface& surface = geometry.surface;
  return {0.5 / surface.rolling_radius + 0.5 / surface.rail_rolling_radius,
          0.5 / surface.wheel_transverse_radius + 0.5 / surface.rail_transverse_radius};
}

double undeformed_distance(const Curvatures& curvatures, double x, double y) {
  return curvatures.A * x * x + curvatures.B * y * y;
}

ChartedGeometry::ChartedGeometry(Geometry geometry, Chart chart)
    : geometry_(std::move(geometry)), chart_(chart) {
  if (chart_ == Chart::arc) place_ = unrolled(geometry_.surface);
}

double ChartedGeometry::lateral_place(double grid_y) const {
  return chart_ == Chart::arc ? place_.at(grid_y).value : grid_y;
}

double ChartedGeometry::climb(double grid_y) const {
  return curved() ? geometry_.surface.climb(lateral_place(grid_y)) : 0.0;
}

PatchShape ChartedGeometry::shape(const ContactGrid& grid) const {
  if (!curved()) return {};
  if (chart_ == Chart::projected) return patch_shape(geometry_.surface, grid);
  PatchShape shape;
  shape.stretch = Field::Ones(grid.size());
  shape.climb = grid.sample([&](double, double s) { return climb(s); });
  shape.y = grid.sample([&](double, double s) { return lateral_place(s); });
  return shape;
}

/// Points beyond the limits belong to another contact.
bool ChartedGeometry::is_this_contact(double y) const {
  return !geometry_.has_profiles() || geometry_.surface.profiles->within_limits(y);
}

void ChartedGeometry::add_averaging(const ContactGrid& grid, Field& distance) const {
  if (!geometry_.has_profiles()) return;
  const PatchGeometry& profiles = *geometry_.surface.profiles;
  const Vector3& axle = profiles.axle().direction;
  for (int j = 0; j < grid.ny; ++j) {
    const double stretch = stretch_of(climb(grid.y(j)));
    const double width = chart_ == Chart::arc ? grid.dy / stretch : grid.dy;
    const double y = lateral_place(grid.y(j));
    // A mean over an edge would lift the elements beside it.
    const auto& ends = profiles.free_ends();
    if (std::any_of(ends.begin(), ends.end(),
                    [&](const FreeEnd& end) { return std::abs(end.y - y) < 1.5 * width; }))
      continue;
    const double rail = profiles.rail().averaging(y, width);
    const double y_wheel = y - profiles.sinking().way[0];
    double change = 0.0;
    for (int i = 0; i < grid.nx; ++i) {
      // The section of a yawed wheel at x equals its section at x = 0 at another y.
      if (i == 0 || axle[0] != 0.0)
        change =
            (profiles.wheel().averaging(y_wheel + grid.x(i) * axle[0] / axle[1], width) - rail) /
            stretch;
      distance[grid.index(i, j)] += change;
    }
  }
}

Field ChartedGeometry::undeformed_distance(const ContactGrid& grid) const {
  Field distance;
  undeformed_distance(grid, distance);
  return distance;
}

void ChartedGeometry::undeformed_distance(const ContactGrid& grid, Field& distance) const {
  if (geometry_.distance_values) {
    distance = sample_lattice(*geometry_.distance_values, 0, grid, "undeformed_distance.file");
    return;
  }
  if (curved() && geometry_.has_surfaces()) {
    grid.sample_into(distance, [&](double x, double y) {
      const double at = lateral_place(y);
      if (!is_this_contact(at)) return beyond_the_wheel;
      // Not a number where a body has no surface.
      return std::fmin(contact::undeformed_distance(geometry_.surface, x, at), beyond_the_wheel);
    });
    return add_averaging(grid, distance);
  }
  if (geometry_.has_profiles()) {
    grid.sample_into(distance, [&](double x, double y) {
      if (!is_this_contact(y)) return beyond_the_wheel;
      return std::min(geometry_.surface.profiles->distance(x, y), beyond_the_wheel);
    });
    return add_averaging(grid, distance);
  }
  const Curvatures curvatures = relative_curvatures(geometry_);
  grid.sample_into(
      distance, [&](double x, double y) { return contact::undeformed_distance(curvatures, x, y); });
}

TangentialField ChartedGeometry::rigid_slip(const Creepage& creepage,
                                            const ContactGrid& grid) const {
  TangentialField slip;
  rigid_slip(creepage, grid, slip);
  return slip;
}

void ChartedGeometry::rigid_slip(const Creepage& creepage, const ContactGrid& grid,
                                 TangentialField& slip) const {
  const ContactSurface& surface = geometry_.surface;
  const bool from_surface = geometry_.extra_slip == ExtraSlip::automatic;
  const double radius = surface.rolling_radius;
  const double rail_turning = from_surface ? 1.0 / surface.rail_rolling_radius : 0.0;
  const double rail_speed =
      rail_turning != 0.0 ? rail_turning * surface.local_rail_radius(0.0) : 1.0;
  const double turning =
      from_surface && std::isfinite(radius) ? (rail_speed - creepage.longitudinal) / radius : 0.0;
  const Vector3 e = axle_of(surface), g = rail_axle_of(surface);
  const double beyond = creepage.spin - turning * e[2] - rail_turning * g[2];
  slip.x.resize(grid.size());
  slip.y.resize(grid.size());
  for (int j = 0; j < grid.ny; ++j) {
    const double y = lateral_place(grid.y(j));
    const double rise = climb(grid.y(j));
    const double cosine = 1.0 / stretch_of(rise);
    const double drop = turning > 0.0 ? radius - surface.local_rolling_radius(y) : 0.0;
    // 1 - (1 - xi) rho / rho_0 without cancellation.
    double along = creepage.longitudinal + turning * drop - beyond * y;
    double turning_about_normal = turning * (e[2] - rise * e[1]) * cosine;
    if (rail_turning != 0.0) {
      along += rail_turning * surface.local_rail_radius(y) - rail_speed;
      turning_about_normal += rail_turning * (g[2] - rise * g[1]) * cosine;
    }
    for (int i = 0; i < grid.nx; ++i) {
      const int k = grid.index(i, j);
      slip.x[k] = along;
      slip.y[k] =
          (creepage.lateral + beyond * grid.x(i)) * cosine + turning_about_normal * grid.x(i);
    }
  }
  if (geometry_.extra_slip == ExtraSlip::file) {
    const Lattice& values = geometry_.extra_slip_values.value();
    slip.x += sample_lattice(values, 0, grid, "rolling.extra_slip_file");
    slip.y += sample_lattice(values, 1, grid, "rolling.extra_slip_file");
  }
}

TangentialField ChartedGeometry::extra_slip(const Creepage& creepage,
                                            const ContactGrid& grid) const {
  TangentialField slip = rigid_slip(creepage, grid);
  const TangentialField uniform = uniform_slip(creepage, grid);
  slip.x -= uniform.x;
  slip.y -= uniform.y;
  return slip;
}

TangentialField uniform_slip(const Creepage& creepage, const ContactGrid& grid) {
  return {grid.sample([&](double, double y) { return creepage.longitudinal - creepage.spin * y; }),
          grid.sample([&](double x, double) { return creepage.lateral + creepage.spin * x; })};
}

double largest_extra_slip(const Geometry& geometry, double y_lower, double y_upper) {
  constexpr int pieces = 64;
  const double step = (y_upper - y_lower) / pieces;
  const ContactGrid grid{1, pieces + 1, 1.0, step, 0.0, y_lower};
  const Field extra = ChartedGeometry(geometry, Chart::plane).extra_slip({}, grid).x;
  return extra.cwiseAbs().maxCoeff();
}

CurvatureSlip::CurvatureSlip(const ContactSurface& surface, const ContactGrid& grid, bool wheel)
    : CurvatureSlip(patch_shape(surface, grid), grid.sample([&](double, double y) {
        return wheel ? surface.local_rolling_radius(y) : -surface.local_rail_radius(y);
      }),
                    wheel ? surface.axle_tilt() : surface.rail_tilt()) {}

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

std::string why_flanks_touch(const Geometry& geometry, double y) {
  const ContactSurface& surface = geometry.surface;
  const auto straight = [&](double radius, double round_to) {
    return std::isfinite(radius) && std::abs(y) > round_to * std::abs(radius);
  };
  if (!geometry.has_surfaces() || geometry.has_profiles() ||
      !straight(surface.wheel_transverse_radius, surface.wheel_round_to) ||
      !straight(surface.rail_transverse_radius, surface.rail_round_to))
    return "";
  return fmt::format(
      "the contact patch reaches past the circles of wheel and rail, which end at {} and {} of "
      "their radii across, onto straight flanks (the potential contact area ends at y = {:.4g} "
      "mm); equally steep flanks touch along their whole length, which no grid can contain; do: "
      "give [wheel] and [rail] a larger round_to (at most 0.9), a smaller load, or transverse "
      "radii that differ more (docs/meshes.md)",
      surface.wheel_round_to, surface.rail_round_to, y);
}

}  // namespace rollfem::contact

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/patch_geometry.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace rollfem::contact {

namespace {

/// Largest slope at which a section is a height over y.
constexpr double steepest = 12.0;
/// Tolerance of Newton's method, relative to a radius.
constexpr double rounding_of_radius = 1e-15;
/// Knots of the wheel's section; closer where it turns by more than this between two.
constexpr double knot_distance = 0.05, least_knot_distance = 1e-3;  // mm
constexpr double largest_turn = 0.5;                                // rad

/// Gradient of the distance from the axle less the radius, by the place.
Vector3 normal_of(const Axle& axle, const AxlePlace& at, const RadiusAround& radius) {
  Vector3 normal{};
  for (std::size_t d = 0; d < 3; ++d)
    normal[d] = at.across[d] / at.radius - radius.by_axial * axle.direction[d];
  if (radius.by_angle == 0.0) return normal;
  // The angle grows along the circle.
  const Vector3 along = cross(at.across, axle.direction);
  for (std::size_t d = 0; d < 3; ++d)
    normal[d] -= radius.by_angle * along[d] / (at.radius * at.radius);
  return normal;
}

/// A surface of revolution.
auto round(const HeightCurve& radius) {
  return [&radius](const AxlePlace& at) {
    const CurveValue here = radius.at(at.axial);
    return RadiusAround{here.value, here.slope, 0.0};
  };
}

struct Height {
  double value;
  double slope;  ///< dz/dy
  bool found;
};

/// Newton's method on radius(z) - radius_at(axial(z), angle(z)) = 0 from `start`.
template <class RadiusAt>
Height height_of(const RadiusAt& radius_at, const Axle& axle, double x, double y, double start) {
  double z = start;
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < 60; ++step) {
    const AxlePlace at = axle_place(axle, {x, y, z});
    const RadiusAround wanted = radius_at(at);
    const double defect = at.radius - wanted.value;
    const Vector3 by_place = normal_of(axle, at, wanted);
    const double by_z = by_place[2], by_y = by_place[1];
    if (!(by_z < -1e-3)) return {z, 0.0, false};
    const double change = defect / by_z;
    if (std::abs(change) < 1e-13 * (1.0 + std::abs(z)) ||
        (std::abs(change) < std::max(1e-11, rounding_of_radius * at.radius) &&
         std::abs(change) >= last))
      return {z - change, -by_y / by_z, true};
    last = std::abs(change);
    z -= change;
  }
  return {z, 0.0, false};
}

HeightCurve section(const HeightCurve& wheel_radius, const Axle& axle, double y_lower,
                    double y_upper) {
  std::vector<HeightKnot> knots;
  knots.reserve(4096);  // usual ones are fewer
  const auto walk = [&](double end) {
    const double direction = end > 0.0 ? 1.0 : -1.0;
    double y = 0.0, z = 0.0, way = 0.0;
    Height last{0.0, 0.0, false};
    while (direction * y <= direction * end) {
      const Height height = height_of(round(wheel_radius), axle, 0.0, y, z);
      if (height.found && last.found && way > least_knot_distance &&
          std::abs(std::atan(height.slope) - std::atan(last.slope)) > largest_turn) {
        way *= 0.5;
        y -= direction * way;
        z -= direction * last.slope * way;
        continue;
      }
      if (!height.found || std::abs(height.slope) > steepest) return;
      if (!wheel_radius.contains(axle_place(axle, {0.0, y, height.value}).axial)) return;
      knots.push_back({y, height.value, height.slope});
      way = knot_distance / std::sqrt(1.0 + height.slope * height.slope);
      y += direction * way;
      z = height.value + height.slope * direction * way;
      last = height;
    }
  };
  walk(y_lower);
  std::reverse(knots.begin(), knots.end());
  if (!knots.empty()) knots.pop_back();  // y = 0, where the next walk begins
  walk(y_upper);
  if (knots.size() < 2)
    throw InputError(
        "wheel.rolling_radius: the wheel has no surface at the contact reference point; allowed: a "
        "radius much larger than the heights of the profile; do: give it in mm");
  return HeightCurve(std::move(knots));
}

}  // namespace

AxlePlace axle_place(const Axle& axle, const Vector3& place) {
  const Vector3 arm = plus(place, axle.point, -1.0);
  const double axial = dot(arm, axle.direction);
  const Vector3 across = plus(arm, axle.direction, -axial);
  return {axial, std::sqrt(dot(across, across)), across};
}

double angle_about(const Axle& axle, const Vector3& across) {
  const Vector3 ahead = cross({0.0, 0.0, -1.0}, axle.direction);
  const Vector3 down = cross(axle.direction, ahead);
  return std::atan2(dot(across, ahead), dot(across, down));
}

PatchGeometry::PatchGeometry(HeightCurve rail, HeightCurve wheel_radius, const Axle& axle,
                             double y_lower, double y_upper)
    : rail_(std::move(rail)),
      wheel_radius_(std::move(wheel_radius)),
      wheel_(section(wheel_radius_, axle, y_lower, y_upper)),
      axle_(axle) {}

PatchGeometry PatchGeometry::under_load(double approach, const std::array<double, 2>& sinks,
                                        const std::array<double, 2>& along) const {
  PatchGeometry loaded = *this;
  loaded.sinking_ = {{-approach * sinks[0] / sinks[1], -approach},
                     {approach * along[0] / along[1], approach}};
  return loaded;
}

double PatchGeometry::wheel_height(double x, double y) const {
  const double section = wheel_.at(y).value;
  const double start = section + 0.5 * x * x / axle_place({0.0, y, section}).radius;
  const auto here = [this](const AxlePlace& at) { return radius_around(at); };
  const Height height = wheel_surface_ ? height_of(here, axle_, x, y, start)
                                       : height_of(round(wheel_radius_), axle_, x, y, start);
  return height.found ? height.value : std::numeric_limits<double>::infinity();
}

RadiusAround PatchGeometry::radius_around(const AxlePlace& at) const {
  return wheel_surface_ ? wheel_surface_(at.axial, angle_about(axle_, at.across))
                        : round(wheel_radius_)(at);
}

void PatchGeometry::set_surfaces(RailSurface rail, WheelSurface wheel) {
  rail_surface_ = std::move(rail);
  wheel_surface_ = std::move(wheel);
}

void PatchGeometry::set_roller(double rolling_radius, HeightCurve radius, const Axle& axle) {
  rail_rolling_radius_ = rolling_radius;
  rail_radius_ = std::move(radius);
  rail_axle_ = axle;
}

double PatchGeometry::rail_height(double x, double y) const {
  if (rail_surface_) return rail_surface_(x, y);
  const double section = rail_.at(y).value;
  if (!is_roller() || x == 0.0) return section;
  // Seen upside down, a roller is a wheel; a ring lies below its axle as a wheel does.
  const double up = rail_rolling_radius_ > 0.0 ? -1.0 : 1.0;
  Axle axle = rail_axle_;
  axle.point[2] *= up;
  axle.direction[2] *= up;
  const double start = up * section + 0.5 * x * x / std::abs(local_rail_radius(y));
  const Height height = height_of(round(rail_radius_), axle, x, y, start);
  return height.found ? up * height.value : -std::numeric_limits<double>::infinity();
}

double PatchGeometry::local_rail_radius(double y) const {
  return std::copysign(contact::axle_place(rail_axle_, {0.0, y, rail_.at(y).value}).radius,
                       rail_rolling_radius_);
}

double PatchGeometry::distance(double x, double y) const {
  return wheel_height(x, y - sinking_.way[0]) - rail_height(x, y);
}

double PatchGeometry::local_rolling_radius(double y) const {
  return axle_place({0.0, y, wheel_.at(y).value}).radius;
}

double PatchGeometry::tilt() const {
  return std::atan2(axle_.direction[2], axle_.direction[1]);
}

double PatchGeometry::rail_tilt() const {
  return std::atan2(rail_axle_.direction[2], rail_axle_.direction[1]);
}

double turn_between(const ContactPlace& a, const ContactPlace& b) {
  // Towards the middle of the track a convex rail falls ever more steeply.
  const double turn = b.contact_angle - a.contact_angle;
  return b.way_across < a.way_across ? turn : -turn;
}

double rail_inclination(const PatchGeometry& patch, const ContactPlace& place, double y) {
  // y points to the field on the left and to the middle on the right.
  const double rise = std::atan(patch.rail().at(y).slope);
  return (place.left ? -rise : rise) - place.contact_angle;
}

std::string ContactPlace::key(char between) const {
  return fmt::format("{1}{0}{2}{0}{3}", between, side(), position, patch);
}

std::string ContactPlace::label(const std::string& noun) const {
  std::string text = side() + noun;
  if (position > 0) text += fmt::format(", position {}", position);
  if (patches > 1) text += fmt::format(", patch {} of {}", patch, patches);
  return text;
}

}  // namespace rollfem::contact

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/below_surface.hpp"

#include <cmath>

namespace rollfem::contact {

namespace {

/// Step for the curvature of the surface, mm.
constexpr double bend_step = 0.01;

}  // namespace

BelowSurface::BelowSurface(const ChartedGeometry& geometry, bool wheel)
    : geometry_(geometry),
      surface_(geometry.geometry().surface),
      wheel_(wheel),
      turns_(std::isfinite(wheel ? surface_.rolling_radius : surface_.rail_rolling_radius)) {
  if (!turns_) return;
  // Of a roller the axle lies below.
  const double above = wheel ? surface_.rolling_radius : -surface_.rail_rolling_radius;
  if (surface_.profiles)
    axle_ = wheel ? surface_.profiles->axle() : surface_.profiles->rail_axle();
  else
    axle_.point = {0.0, 0.0, above};
  const double tilt = wheel ? surface_.axle_tilt() : surface_.rail_tilt();
  axle_.direction = {0.0, std::cos(tilt), std::sin(tilt)};
  const double to_surface = above > 0.0 ? 1.0 : -1.0;
  down_ = {0.0, to_surface * axle_.direction[2], -to_surface * axle_.direction[1]};
}

/// The body's own section at x = 0.
CurveValue BelowSurface::own(double y) const {
  if (surface_.profiles)
    return (wheel_ ? surface_.profiles->wheel() : surface_.profiles->rail()).at(y);
  const ProfileDrop drop = wheel_ ? surface_.wheel_drop(y) : surface_.rail_drop(y);
  const double sign = wheel_ ? 1.0 : -1.0;
  return {sign * drop.value, sign * drop.slope, 0.0};
}

/// Second derivative of the common surface, 1/mm.
double BelowSurface::bend(double y) const {
  return (surface_.climb(y + bend_step) - surface_.climb(y - bend_step)) / (2.0 * bend_step);
}

double BelowSurface::arc_of(double y) const {
  double arc = y;
  for (int step = 0; step < 30; ++step) {
    const double change = (y - geometry_.lateral_place(arc)) * stretch_of(surface_.climb(y));
    arc += change;
    if (std::abs(change) < 1e-12 * (1.0 + std::abs(y))) break;
  }
  return arc;
}

Vector3 BelowSurface::turned_direction(const Vector3& v, double angle) const {
  const double radial = dot(v, down_);
  const double x = v[0] * std::cos(angle) + radial * std::sin(angle);
  const double change = radial * (std::cos(angle) - 1.0) - v[0] * std::sin(angle);
  return {x, v[1] + change * down_[1], v[2] + change * down_[2]};
}

Vector3 BelowSurface::turned_about_axle(const Vector3& in_section, double angle) const {
  return plus(turned_direction(plus(in_section, axle_.point, -1.0), angle), axle_.point);
}

BelowSurface::Coordinates BelowSurface::coordinates(const Vector3& place) const {
  Vector3 section = place;
  double angle = 0.0;
  if (turns_) {
    const Vector3 radial = plus(place, axle_.point, -1.0);
    angle = std::atan2(radial[0], dot(radial, down_));
    section = turned_about_axle(place, -angle);
  }
  // The foot point on the body's section, along the normal of the common surface.
  double y = section[1];
  bool found = false;
  for (int step = 0; step < 60 && !found; ++step) {
    const CurveValue at = own(y);
    const double climb = surface_.climb(y);
    const double above = section[2] - at.value;
    const double change =
        (section[1] - y + climb * above) / (1.0 + climb * at.slope - bend(y) * above);
    y += change;
    found = std::abs(change) < 1e-10 * (1.0 + std::abs(y));
  }
  const double climb = surface_.climb(y);
  const double stretch = stretch_of(climb);
  const double upwards = (section[2] - own(y).value - climb * (section[1] - y)) / stretch;
  Coordinates result;
  result.x = turns_ ? angle * surface_.local_rolling_radius(y) : place[0];
  result.y = arc_of(y);
  result.depth = wheel_ ? upwards : -upwards;
  result.spread = found ? 1.0 - bend(y) * upwards / (stretch * stretch * stretch) : 0.0;
  result.axes = {{{1.0, 0.0, 0.0},
                  {0.0, 1.0 / stretch, climb / stretch},
                  {0.0, -climb / stretch, 1.0 / stretch}}};
  if (turns_)
    for (Vector3& axis : result.axes) axis = turned_direction(axis, angle);
  return result;
}

Vector3 BelowSurface::place(double x, double arc, double depth) const {
  const double y = geometry_.lateral_place(arc);
  const double climb = surface_.climb(y);
  const double upwards = (wheel_ ? depth : -depth) / stretch_of(climb);
  const Vector3 section{turns_ ? 0.0 : x, y - climb * upwards, own(y).value + upwards};
  return turns_ ? turned_about_axle(section, x / surface_.local_rolling_radius(y)) : section;
}

Vector3 BelowSurface::below(double x, double y, double depth) const {
  if (!turns_) return {x, y, own(y).value + (wheel_ ? depth : -depth)};
  const Vector3 section{0.0, y, own(y).value + depth};
  const double radius = dot(plus(section, axle_.point, -1.0), down_);
  if (!(std::abs(x) < radius)) return {x, y, infinity};
  return turned_about_axle(section, std::asin(x / radius));
}

}  // namespace rollfem::contact

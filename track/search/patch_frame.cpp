// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/search/patch_frame.hpp"

#include "contact/scene/geometry.hpp"
#include "profiles/profiles.hpp"
#include "track/placement/along_way.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace rollfem::track {

using contact::Axle;
using contact::Case;
using contact::Vector3;

namespace {

/// Extent of the wheel's section from the contact (mm), larger than any patch.
constexpr double section_reach = 60.0;

/// Transformation of a curve into another frame, and the range of its y.
struct Change {
  double sign_y = 1.0;
  double factor = 1.0;
  double added = 0.0;
  double first = -contact::infinity;
  double last = contact::infinity;
};

contact::HeightCurve changed(const contact::HeightCurve& curve, const Change& change) {
  const std::vector<double>& knots = curve.knots();
  auto begin = std::lower_bound(knots.begin(), knots.end(), change.first);
  auto end = std::upper_bound(begin, knots.end(), change.last);
  // One beyond each end.
  if (begin != knots.begin()) --begin;
  if (end != knots.end()) ++end;
  std::vector<double> y, z, slope;
  for (auto* list : {&y, &z, &slope}) list->reserve(static_cast<std::size_t>(end - begin));
  for (; begin != end; ++begin) {
    const contact::CurveValue at = curve.at(*begin);
    y.push_back(change.sign_y * *begin);
    z.push_back(change.factor * at.value + change.added);
    slope.push_back(change.sign_y * change.factor * at.slope);
  }
  if (change.sign_y < 0.0)
    for (auto* list : {&y, &z, &slope}) std::reverse(list->begin(), list->end());
  return {std::move(y), std::move(z), std::move(slope)};
}

/// An axle of the side frame in the frame of a patch: for the right side (sign_y = -1) y changes
/// its sign, and the direction is reversed so that it points to larger y again (with its axial
/// coordinate, as in `changed`).
Axle in_patch(const PatchAxes& axes, double sign_y, const Axle& axle) {
  const Vector3 &p = axle.point, &d = axle.direction;
  return {{p[0], sign_y * axes.across(p[1], p[2]), axes.along_normal(p[1], p[2])},
          {sign_y * d[0], axes.cosine * d[1] - axes.sine * d[2],
           sign_y * (-axes.sine * d[1] - axes.cosine * d[2])}};
}

/// The part of a roller's surface about its contact, from its section there.
void turn_rail(double roller, const RailPlace& place, const profiles::ProfileCurve& section,
               const AlongRail& along, const PatchAxes& axes, double sign_y, double at_touch,
               double reach, contact::PatchGeometry& geometry) {
  if (std::isinf(roller)) return;
  const Axle level = roller_axle(place, roller);
  const Axle axle{along.place_to_top(level.point), along.direction_to_top(level.direction)};
  const double axial = contact::axle_place(axle, {0.0, axes.y0, axes.z0}).axial;
  const profiles::ProfileCurve from_axle =
      section.part(at_touch - reach, at_touch + reach)
          .moved(0.0, -axle.point[1], -axle.point[2])
          .moved(-std::atan2(axle.direction[2], axle.direction[1]), 0.0, 0.0);
  const double outwards = roller > 0.0 ? 1.0 : -1.0;
  geometry.set_roller(roller,
                      changed(profiles::height_over_y(from_axle, at_touch),
                              {sign_y, -outwards, 0.0, axial - reach, axial + reach}),
                      in_patch(axes, sign_y, axle));
}

/// The wheel's axle in the frame of a contact, lowered until that touches.
Axle lowered_axle(const PatchAxes& axes, double sign_y, const Axle& axle_of_side,
                  const OutlinePoint& touch, double sink, bool vertically) {
  Axle axle = axle_of_side;
  if (vertically) axle.point[2] += sink;
  axle = {touch.along.place_to_top(axle.point), touch.along.direction_to_top(axle.direction)};
  if (!vertically) axle.point[2] += sink;
  return in_patch(axes, sign_y, axle);
}

/// The surfaces of bodies that change along the way, in the frame of a contact.
void set_surfaces(const BodiesAlongWay& bodies, const PatchAxes& axes, double sign_y,
                  const OutlinePoint& touch, contact::PatchGeometry& geometry) {
  const AlongRail& along = touch.along;
  const SurfaceFrame frame{
      along.place_from_top({0.0, axes.y0, axes.z0}), along.direction_from_top({1.0, 0.0, 0.0}),
      along.direction_from_top({0.0, sign_y * axes.cosine, -sign_y * axes.sine}),
      along.direction_from_top({0.0, -axes.sine, -axes.cosine})};
  const contact::AxlePlace here = geometry.axle_place({0.0, 0.0, geometry.wheel().at(0.0).value});
  const double angle_there = contact::angle_about(geometry.axle(), here.across);
  geometry.set_surfaces(
      bodies.rail_in(frame),
      bodies.wheel_around(bodies.angle_of({along.x, touch.y, touch.z}), angle_there, sign_y));
}

std::vector<contact::FreeEnd> free_ends(const Case& input, const SearchScene& scene,
                                        const PatchAxes& axes, const Axle& axle, bool left) {
  std::vector<contact::FreeEnd> ends;
  if (input.rail.profile.free_ends)
    for (const profiles::ProfilePoint& end : profiles::free_ends_of(scene.rail(left).curve))
      ends.push_back({(left ? 1.0 : -1.0) * axes.across(end.y, end.z), false});
  if (input.wheel.profile.free_ends)
    for (const profiles::ProfilePoint& end : profiles::free_ends_of(scene.profiles.wheel)) {
      const Vector3& d = axle.direction;
      const double radius = input.wheel.rolling_radius + end.z, across = std::hypot(d[1], d[2]);
      const double axial = left ? end.y : -end.y;
      ends.push_back({axle.point[1] + axial * d[1] + radius * d[2] / across, true});
    }
  return ends;
}

}  // namespace

contact::PatchGeometry make_geometry(const Case& input, const SearchScene& scene,
                                     const BodiesAlongWay* bodies, const PatchAxes& axes,
                                     const Axle& axle_of_side, bool left, const OutlinePoint& touch,
                                     double sink, const std::array<double, 2>& overlap,
                                     double around_overlap) {
  const double reach = std::max(-overlap[0], overlap[1]) + around_overlap;
  const bool rail_changes = bodies != nullptr && bodies->rail_changes();
  const bool wheel_changes = bodies != nullptr && bodies->wheel_changes();
  const profiles::ProfileCurve along =
      rail_changes ? bodies->rail_section(touch.along) : profiles::ProfileCurve();
  const profiles::ProfileCurve& whole_rail = rail_changes ? along : scene.rail(left).curve;
  const double at_touch = parameter_near(whole_rail, axes.y0, axes.z0);
  // Shifted to the touching point, then rotated.
  const double cosine = axes.cosine, sine = axes.sine;
  const profiles::ProfileCurve rail =
      whole_rail.part(at_touch - reach, at_touch + reach)
          .moved(std::atan2(sine, cosine), sine * axes.z0 - cosine * axes.y0,
                 -sine * axes.y0 - cosine * axes.z0);
  // z of the patch points up, that of the profile down.
  const double sign_y = left ? 1.0 : -1.0;
  const Change to_patch{sign_y, -1.0, 0.0};
  contact::HeightCurve heights =
      changed(profiles::height_over_y(rail, parameter_near(rail, 0.0, 0.0)), to_patch);
  const std::vector<double>& heads = scene.rail(left).place.tops_and_grooves;
  if (rail_changes && !(heights.contains(overlap[0]) && heights.contains(overlap[1])))
    heights = changed(seen_from_above(rail), to_patch);
  else if (heads.size() > 1 && !(heights.contains(overlap[0]) && heights.contains(overlap[1])))
    heights = changed(rail_heights(rail, heads), to_patch);
  const profiles::ProfileCurve turned =
      wheel_changes ? bodies->wheel_section(bodies->angle_of({touch.along.x, touch.y, touch.z}))
                    : profiles::ProfileCurve();
  const profiles::ProfileCurve& wheel = wheel_changes ? turned : scene.profiles.wheel;
  const double height = touch.radius - input.wheel.rolling_radius;
  // The part about the running circle uses the same knots for every contact there.
  constexpr double same_place = 1e-3;  // mm
  const contact::HeightCurve& tread = scene.wheel_tread;
  const bool on_tread = !wheel_changes && tread.contains(touch.profile_y) &&
                        std::abs(tread.at(touch.profile_y).value - height) < same_place;
  const Change to_radius{sign_y, 1.0, input.wheel.rolling_radius, touch.profile_y - reach,
                         touch.profile_y + reach};
  contact::HeightCurve radius =
      on_tread
          ? changed(tread, to_radius)
          : changed(profiles::height_over_y(wheel, parameter_near(wheel, touch.profile_y, height)),
                    to_radius);
  const Axle axle = lowered_axle(axes, sign_y, axle_of_side, touch, sink, bodies != nullptr);
  const double section = std::min(section_reach, reach);
  contact::PatchGeometry geometry{std::move(heights), std::move(radius), axle, -section, section};
  turn_rail(input.rail.rolling_radius, scene.rail(left).place, whole_rail, touch.along, axes,
            sign_y, at_touch, reach, geometry);
  if (bodies != nullptr) set_surfaces(*bodies, axes, sign_y, touch, geometry);
  geometry.set_free_ends(free_ends(input, scene, axes, axle, left));
  geometry.set_rounding({rail.knots().rounding, wheel.knots().rounding});
  return geometry;
}

}  // namespace rollfem::track

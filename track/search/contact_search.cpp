// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/search/contact_search.hpp"

#include "base/errors.hpp"
#include "base/pi.hpp"
#include "case/case.hpp"
#include "profiles/profiles.hpp"
#include "scene/geometry.hpp"
#include "scene/patch_geometry.hpp"
#include "track/placement/along_way.hpp"
#include "track/placement/vertical_gap.hpp"
#include "track/placement/wheelset_pose.hpp"
#include "track/search/patch_groups.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::track {

using contact::Axle;
using contact::Case;
using contact::Vector3;

namespace {

// Wheel and rail in the frame of one contact: sections, axles and surfaces, from where the search
// has them.

/// The frame of a patch on the rail; coordinates as in a right-handed patch frame on the left side,
/// where y points to the field; on the right the lateral axis is reversed at the end.
struct PatchAxes {
  double y0, z0;        ///< side frame, mm
  double cosine, sine;  ///< of the contact angle
  double across(double y, double z) const { return cosine * (y - y0) - sine * (z - z0); }
  double along_normal(double y, double z) const { return -sine * (y - y0) - cosine * (z - z0); }
};

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
  const std::vector<contact::HeightKnot>& knots = curve.knots();
  auto begin = std::partition_point(knots.begin(), knots.end(),
                                    [&](const auto& knot) { return knot.y < change.first; });
  auto end = std::partition_point(begin, knots.end(),
                                  [&](const auto& knot) { return knot.y <= change.last; });
  // One beyond each end.
  if (begin != knots.begin()) --begin;
  if (end != knots.end()) ++end;
  std::vector<contact::HeightKnot> made;
  made.reserve(static_cast<std::size_t>(end - begin));
  for (; begin != end; ++begin) {
    const contact::CurveValue at = curve.at(begin->y);
    made.push_back({change.sign_y * begin->y, change.factor * at.value + change.added,
                    change.sign_y * change.factor * at.slope});
  }
  if (change.sign_y < 0.0) std::reverse(made.begin(), made.end());
  return contact::HeightCurve(std::move(made));
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

/// `bodies`: null of bodies that do not change along the way; `axle_of_side`: at first touch of the
/// wheel, which sinks by `sink` (mm) until this contact touches at `touch`; `overlap`: range of y
/// of the patch frame, beyond which the bodies are known for `around_overlap` (mm).
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
  geometry.set_rounding({rail.rounding(), wheel.rounding()});
  return geometry;
}

/// Default of SearchOptions::merge_angle.
constexpr double angle_on_plane = 0.35;
constexpr double angle_on_surface = 0.8;

/// Sinking under the load of the case, as estimated.
double sinking_under_load(const Case& input, const VerticalGap& gap,
                          const std::vector<Stretch>& stretches) {
  const double modulus =
      contact::combine(input.wheel.material, input.rail.material).contact_modulus;
  const GapMinimum& deepest = deepest_of(stretches).deepest;
  const double cosine = deepest.cosine();
  if (input.load.approach) return deepest.gap + *input.load.approach / cosine;
  const double vertical = input.load.vertical_force
                              ? *input.load.vertical_force
                              : input.load.normal_force.value_or(0.0) * cosine;
  return estimate_sinking(gap, stretches, vertical, modulus);
}

/// Side frame to track frame.
Vector3 to_track(bool left, const Vector3& v) {
  return {v[0], side_sign(left) * v[1], v[2]};
}

class WheelSearch {
 public:
  WheelSearch(const Case& input, const SearchScene& scene, const WheelsetPose& pose, int position,
              bool left)
      : input_(input),
        scene_(scene),
        position_(position),
        left_(left),
        pose_(pose),
        gap_(touching_gap(input, scene, pose_, position, left)),
        axle_(place_axle(pose_, input, left)),
        modulus_(contact::combine(input.wheel.material, input.rail.material).contact_modulus) {}

  std::vector<WheelRailContact> contacts(const SearchOptions& options) const {
    const bool curved = input_.surface == contact::SurfaceForm::curved;
    const double angle = options.merge_angle.value_or(curved ? angle_on_surface : angle_on_plane);
    const auto [groups, sinking, humps] =
        group_minima(gap_, angle, [&](const std::vector<Stretch>& stretches) {
          if (options.height) return *options.height - pose_.height;
          return options.sinking ? *options.sinking : sinking_under_load(input_, gap_, stretches);
        });
    std::vector<WheelRailContact> found;
    found.reserve(groups.size());
    int loaded = 0;
    for (std::size_t k = 0; k < groups.size(); ++k) {
      found.push_back(describe(groups[k], sinking, k > 0, k + 1 < groups.size(), options));
      found.back().reserve = !(found.back().normal_force > 0.0);
      if (!found.back().reserve) ++loaded;
    }
    add_near_misses(humps, groups, sinking, options, found);
    share_vertical_force(found);
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return a.normal_force != b.normal_force ? a.normal_force > b.normal_force
                                              : a.place.separation < b.place.separation;
    });
    for (std::size_t k = 0; k < found.size(); ++k) {
      found[k].place.patches = loaded;
      found[k].place.patch = found[k].normal_force > 0.0 ? static_cast<int>(k) + 1 : 0;
    }
    return found;
  }

 private:
  /// Humps that do not touch, within contacts or beyond them; humps of a reserve are already
  /// listed.
  void add_near_misses(const std::vector<Stretch>& humps, const std::vector<Stretch>& groups,
                       double sinking, const SearchOptions& options,
                       std::vector<WheelRailContact>& found) const {
    const auto of_reserve = [&](const GapMinimum& minimum) {
      return std::any_of(groups.begin(), groups.end(), [&](const Stretch& group) {
        return group.deepest.gap >= sinking && group.deepest.y == minimum.y;
      });
    };
    SearchOptions plain = options;
    plain.reference_offset = 0.0;
    for (const Stretch& hump : humps) {
      const GapMinimum& lowest = hump.deepest;
      if (lowest.gap < sinking || of_reserve(lowest)) continue;
      if (lowest.gap * lowest.cosine() > options.near_miss) continue;
      found.push_back(describe(hump, sinking, false, false, plain));
    }
  }

  /// The estimates use the angles of first contact; their sum is the load of the case.
  void share_vertical_force(std::vector<WheelRailContact>& found) const {
    if (!input_.load.vertical_force) return;
    double sum = 0.0;
    for (const WheelRailContact& contact : found)
      sum += contact.normal_force * std::cos(contact.place.contact_angle);
    for (WheelRailContact& contact : found)
      contact.normal_force *= *input_.load.vertical_force / sum;
  }

  WheelRailContact describe(const Stretch& group, double sinking, bool neighbour_inside,
                            bool neighbour_outside, const SearchOptions& options) const {
    const GapMinimum& first = group.deepest;
    auto [y, slope, spread] = reference_of(gap_, group, sinking);
    if (const double offset = options.reference_offset; offset != 0.0) {
      y += offset;
      slope = gap_.with_surface(y).slope;
    }
    const contact::CurveValue rail = gap_.rail().at(y);
    const OutlinePoint touch = gap_.wheel().at(y);
    // In the plane across a rail that climbs.
    const double level = gap_.bodies() ? touch.along.cosine : 1.0;
    const double angle = -std::atan(slope * level);
    const PatchAxes axes{y, rail.value, std::cos(angle), std::sin(angle)};
    WheelRailContact contact;
    contact.pose = pose_;
    contact.spread_of_normals = spread;
    contact.next_hump = (group.next_gap - first.gap) * axes.cosine;
    contact.approach = std::max(0.0, approach_of(group, sinking));
    contact.normal_force = estimate_force(gap_, group, contact.approach, modulus_);
    fill_place(contact.place, group, axes, touch);
    fill_frames(contact, axes, touch);
    fill_motion(contact);
    if (contact.normal_force > 0.0) check_reach(group, sinking);
    const auto across = [&](double at) { return axes.across(at, gap_.rail().at(at).value); };
    const auto pair = [&](double lower, double upper) {
      return left_ ? std::array<double, 2>{lower, upper} : std::array<double, 2>{-upper, -lower};
    };
    const auto reach = reach_of(gap_, group, std::max(sinking, first.gap));
    contact.reach = pair(across(reach[0]), across(reach[1]));
    contact.limits = pair(neighbour_inside ? across(group.limits[0]) : -contact::infinity,
                          neighbour_outside ? across(group.limits[1]) : contact::infinity);
    for (const GapMinimum& minimum : group.minima)
      if (minimum.gap < sinking || minimum.y == first.y)
        contact.touching.push_back(
            {(left_ ? 1.0 : -1.0) * across(minimum.y), minimum.gap * axes.cosine});
    contact.geometry = make_geometry(input_, scene_, gap_.bodies().get(), axes, axle_, left_, touch,
                                     first.gap, contact.reach, options.around_overlap);
    contact.geometry.set_limits(contact.limits);
    if (contact.geometry.varies()) set_variation(contact, touch.relative_radius);
    return contact;
  }

  void fill_place(contact::ContactPlace& place, const Stretch& stretch, const PatchAxes& axes,
                  const OutlinePoint& touch) const {
    place.left = left_;
    place.position = position_;
    const double sign = frame_sign(input_.wheelset);
    place.lateral_shift = sign * pose_.lateral_shift;
    place.yaw = sign * pose_.yaw;
    place.roll = sign * pose_.roll;
    place.height = pose_.height;
    const Vector3 at = contact_place(axes, touch);
    const RailPlace& rail = scene_.rail(left_).place;
    const double roller_axle_z = roller_axle(rail, input_.rail.rolling_radius).point[2];
    const double z_at_top = AlongRail::height_at_top(at, roller_axle_z);
    place.x_track = at[0];
    place.y_track = side_sign(left_) * at[1];
    place.z_track = at[2];
    place.y_rail = profile_coordinates(rail, at[1], z_at_top)[0];
    place.rail_turn = rail.angle;
    place.y_wheel = touch.profile_y;
    place.contact_angle = std::atan2(axes.sine, axes.cosine);
    place.rolling_radius = touch.radius;
    place.climb = 0.0 - std::asin(touch.along.sine);
    place.way_across = way_across(axes.y0);
    place.separation = stretch.deepest.gap * axes.cosine;
  }

  /// Reference point on the rail, side frame.
  static Vector3 contact_place(const PatchAxes& axes, const OutlinePoint& touch) {
    return touch.along.place_from_top({0.0, axes.y0, axes.z0});
  }

  /// Arc length of the common surface outward to y, mm, from the middle of its known part.
  double way_across(double y) const {
    constexpr double step = 0.05;  // mm
    const double start = 0.5 * (gap_.first() + gap_.last());
    const int pieces = 1 + static_cast<int>(std::abs(y - start) / step);
    const double dy = (y - start) / pieces;
    double way = 0.0;
    for (int k = 0; k < pieces; ++k) {
      const double at = start + (k + 0.5) * dy;
      const double slope = gap_.with_surface(at).slope;
      way += dy * std::sqrt(1.0 + slope * slope);
    }
    return way;
  }

  void fill_frames(WheelRailContact& contact, const PatchAxes& axes,
                   const OutlinePoint& touch) const {
    contact.origin = to_track(left_, contact_place(axes, touch));
    contact.along = to_track(left_, touch.along.direction_from_top({1.0, 0.0, 0.0}));
    contact.normal =
        to_track(left_, touch.along.direction_from_top({0.0, -axes.sine, -axes.cosine}));
    contact.across = contact::cross(contact.normal, contact.along);
  }

  /// Sets the axle, and the velocities that come from the displacements of wheel and rail; the
  /// motion of the wheelset adds to them (track/motion/wheelset_motion.hpp).
  void fill_motion(WheelRailContact& contact) const {
    const std::size_t side = left_ ? 0 : 1;
    const contact::Displacement &wheel = input_.wheel_displacement,
                                &rail = input_.rail_displacement;
    const auto of_side = [&](const Axle& axle) {
      const double sign = side_sign(left_);
      const Vector3& e = axle.direction;
      return Axle{to_track(left_, axle.point), {sign * e[0], e[1], sign * e[2]}};
    };
    contact.axle = of_side(axle_);
    const Vector3 middle = wheelset_axle(pose_, input_).point;
    contact.middle = {middle[0] + wheel.longitudinal[side], middle[1] + wheel.lateral[side],
                      middle[2] + wheel.vertical[side]};
    const auto add = [&](double sign, const Vector3& velocity, double rate, const Vector3& turning,
                         const Vector3& about) {
      const Vector3 arm = contact::plus(contact.origin, about, -1.0);
      const Vector3 by_turning = contact::cross(turning, arm);
      for (int d = 0; d < 3; ++d) {
        contact.own_velocity[d] += sign * (velocity[d] + rate * by_turning[d]);
        contact.own_turning[d] += sign * rate * turning[d];
      }
    };
    const auto add_own = [&](double sign, const contact::Displacement& of, const Vector3& ahead,
                             const Vector3& origin) {
      add(sign,
          {of.longitudinal_velocity[side], of.lateral_velocity[side], of.vertical_velocity[side]},
          of.roll_velocity[side], ahead, origin);
      add(sign, {}, of.yaw_velocity[side], {0.0, 0.0, 1.0}, origin);
    };
    const Vector3& e = contact.axle.direction;
    add_own(1.0, wheel, ahead_of(e), profile_origin(contact.axle, input_.wheel.rolling_radius));
    add(1.0, {}, -wheel.rotation[side], e, contact.axle.point);
    const RailPlace& place = scene_.rail(left_).place;
    add_own(-1.0, rail, {1.0, 0.0, 0.0}, to_track(left_, {0.0, place.shift_y, place.shift_z}));
    const double radius = input_.rail.rolling_radius;
    contact.own_velocity[0] += std::isinf(radius) ? 1.0 : 0.0;
    if (std::isfinite(radius)) {
      const Axle roller = of_side(roller_axle(place, radius));
      add(-1.0, {}, 1.0 / radius, roller.direction, roller.point);
    }
  }

  /// Over the ellipse of the overlap, less than half of which is the patch.
  void set_variation(WheelRailContact& contact, double relative_radius) const {
    if (!(contact.approach > 0.0)) return;
    contact::PatchGeometry plain = contact.geometry;
    plain.set_surfaces({}, {});
    const double half_length = std::sqrt(relative_radius * contact.approach);
    const double middle = 0.5 * (contact.reach[0] + contact.reach[1]);
    const double half_width = 0.5 * (contact.reach[1] - contact.reach[0]);
    constexpr int places = 24;
    double most = 0.0;
    for (int k = 0; k < places; ++k) {
      const double angle = 2.0 * contact::pi * k / places;
      const double x = half_length * std::cos(angle), y = middle + half_width * std::sin(angle);
      const double difference = std::abs(contact.geometry.distance(x, y) - plain.distance(x, y));
      if (std::isinf(difference) && gap_.bodies()->heads_end())
        fail_where_head_ends(input_, position_, left_);
      most = std::max(most, difference);
    }
    contact.geometry.set_variation(most / contact.approach);
  }

  void check_reach(const Stretch& stretch, double sinking) const {
    const auto reach = reach_of(gap_, stretch, sinking);
    if (reach[0] <= gap_.first())
      fail_at_end(input_, gap_, true, position_, left_, "under its load the patch reaches");
    if (reach[1] >= gap_.last())
      fail_at_end(input_, gap_, false, position_, left_, "under its load the patch reaches");
  }

  const Case& input_;
  const SearchScene& scene_;
  int position_;
  bool left_;
  WheelsetPose pose_;
  VerticalGap gap_;  ///< sets the height of the pose
  Axle axle_;
  double modulus_;
};

}  // namespace

std::vector<WheelRailContact> find_contacts(const Case& input, const SearchScene& scene,
                                            const WheelsetPose& pose, int position, bool left,
                                            const SearchOptions& options) {
  return WheelSearch(input, scene, pose, position, left).contacts(options);
}

std::vector<WheelRailContact> find_contacts(const Case& input, const SearchScene& scene,
                                            int position, const SearchOptions& options) {
  const WheelsetPose pose = find_pose(input, scene, position);
  std::vector<WheelRailContact> all;
  for (const bool left : {true, false}) {
    const contact::WheelSide other = left ? contact::WheelSide::right : contact::WheelSide::left;
    if (input.wheelset.side == other) continue;
    SearchOptions here = options;
    if (!input.wheelset.height.empty() && !options.height)
      here.height = input.wheelset.height.at(static_cast<std::size_t>(position - 1));
    for (WheelRailContact& contact : contact::at_place({file_of(input)}, [&] {
           return find_contacts(input, scene, pose, position, left, here);
         }))
      all.push_back(std::move(contact));
  }
  return all;
}

}  // namespace rollfem::track

// SPDX-License-Identifier: LGPL-2.1-or-later
// Positions of rails and wheels on the track. Everything is done in the *side frame* of one wheel:
// x along the track, Y from the middle of the track outward to the field side, z down, so that
// profile y and Y point the same way on both sides and the left side is the mirror image of the
// right one. Track frame: y_track = Y on the right, -Y on the left.
#pragma once

#include "case/case.hpp"
#include "profiles/profile_curve.hpp"
#include "profiles/section_surface.hpp"
#include "scene/patch_geometry.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace rollfem::track {

/// Wheel and rail in their profile coordinates, the same on both sides.
struct ProfilePair {
  profiles::ProfileCurve wheel;
  profiles::ProfileCurve rail;
  /// Sections of a body that changes along its way; its profile is then one of them.
  std::shared_ptr<const profiles::SectionSurface> wheel_sections = nullptr, rail_sections = nullptr;
};

/// Position of the wheelset, or of a wheel by itself (Wheelset::on_rail): signs of the track frame.
struct WheelsetPose {
  double lateral_shift = 0.0;  ///< mm, of the middle of the axle, positive to the right
  double yaw = 0.0;            ///< rad about z, positive from x to y
  double roll = 0.0;           ///< rad about the yawed x, positive from y to z
  double height = 0.0;         ///< mm, z of the middle of the axle plus the nominal radius: 0 puts
                               ///< the running circle of an unrolled wheel level with the rails
};

/// Motion of a rail from profile coordinates to its position: rotation by `angle` (rad, from y to
/// z) about (0, 0), then a shift.
struct RailPlace {
  double angle = 0.0;
  double shift_y = 0.0;  ///< mm
  double shift_z = 0.0;  ///< mm
  /// Part of this angle (rad) that comes from the displacement of the rail, with the axle of a
  /// roller, and the shift along z before it.
  double roll = 0.0, upright_z = 0.0;
  /// Parameters of the tops of the heads and of the bottoms of the grooves between them, in order;
  /// only the top for an ordinary rail.
  std::vector<double> tops_and_grooves;
};

/// Axle of a roller in the side frame: level, and its rolling radius below z = 0, before the rail's
/// displacement. Its axial coordinate is 0 at the origin of the profile.
contact::Axle roller_axle(const RailPlace& place, double rolling_radius);

/// Turns the profile towards the middle of the track by the inclination, puts the top of its head
/// at z = 0 and its gauge face half the gauge from the middle: track.gauge_face, or else the point
/// nearest to the middle among those within gauge_height of the top. Of several heads (with a
/// groove deeper than gauge_height between them) this is the one nearest to track.gauge_face, or
/// else the only one at whose place the wheel `fits` (default: all do) of those that reach down to
/// gauge_height towards the middle. Throws contact::InputError where several fit or none reaches
/// down so far. Where the case gives the place of the profile's origin, there.
RailPlace rail_place(const profiles::ProfileCurve& rail, const contact::Track& track,
                     const std::function<bool(const RailPlace&)>& fits = {});

/// The rail of one side where the case's displacement takes it.
RailPlace displaced(RailPlace place, const contact::Case& input, bool left);

/// Way along a rail from the plane x = 0 through its top: a shift on a straight rail, a rotation on
/// a roller, both on a rail that changes along the track. Turning a scene back by it brings its
/// contact to the top, where the rail is level along x and its section on a roller is its profile.
struct AlongRail {
  double x = 0.0;                   ///< mm, of the place
  double sine = 0.0, cosine = 1.0;  ///< of the angle from z to x by which the scene is turned back
  /// mm, x and z about which it is turned, and of that point when it has been turned back.
  std::array<double, 2> from{}, to{};

  AlongRail() = default;
  /// To a place with this radial height z (mm); roller_axle_z: the z of its axle.
  AlongRail(double x, double z, double roller_axle_z);
  /// To a place of a rail whose height changes by this slope dz/dx there.
  static AlongRail sloping(double x, double z, double slope);
  /// z of a place when it has been turned about a roller's axle to the plane x = 0.
  static double height_at_top(const contact::Vector3& place, double roller_axle_z);
  double slope() const { return sine / cosine; }  ///< dz/dx
  contact::Vector3 place_from_top(const contact::Vector3& place) const;
  contact::Vector3 place_to_top(const contact::Vector3& place) const;
  contact::Vector3 direction_from_top(const contact::Vector3& v) const;
  contact::Vector3 direction_to_top(const contact::Vector3& v) const;
};

/// The rail in the side frame.
profiles::ProfileCurve place_rail(const profiles::ProfileCurve& rail, const RailPlace& place);

/// Back to profile coordinates: the inverse of RailPlace.
std::array<double, 2> profile_coordinates(const RailPlace& place, double y, double z);

/// +1 for the right wheel, -1 for the left one: y_track = side_sign Y.
double side_sign(bool left);

/// Sign of the case's lateral positions and turns in the track frame: -1 for a left wheel by
/// itself, which is placed in the frame of its rail.
double frame_sign(const contact::Wheelset& wheelset);

/// Axle of a wheel in the side frame (x, Y, z), moved by the case's displacement. Its axial
/// coordinate is the wheel's profile y, so axial 0 is the running circle; the direction points to
/// the field side.
contact::Axle place_axle(const WheelsetPose& pose, const contact::Case& input, bool left);

/// The level direction forward, across an axle whose direction points to the right (or to the field
/// side): the wheel rolls to the side about it.
contact::Vector3 ahead_of(const contact::Vector3& axle_direction);
/// Origin of the wheel's profile at the lowest place of its running circle, about which roll and
/// yaw of the case's displacement turn the wheel.
contact::Vector3 profile_origin(const contact::Axle& axle, double rolling_radius);

/// Axle of the wheelset in the track frame, whose middle is the centre of a wheel by itself:
/// without the case's displacement. Its direction points to the right.
contact::Axle wheelset_axle(const WheelsetPose& pose, const contact::Case& input);

}  // namespace rollfem::track

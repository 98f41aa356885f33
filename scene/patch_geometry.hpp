// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheel and rail as they meet at one contact, in the frame of the patch: origin at the contact
// reference point on the rail, x along the rail (the rolling direction), z along the normal of the
// contact's plane into the wheel, y = z cross x. Undeformed distance and rigid slip
// of the true profiles follow from it (docs/track.md).
#pragma once

#include "base/members.hpp"
#include "scene/height_curve.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::contact {

using Vector3 = std::array<double, 3>;

/// a + factor b.
inline Vector3 plus(const Vector3& a, const Vector3& b, double factor = 1.0) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

inline double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The wheel's axle: a point of it (the one at axial coordinate 0) and its unit direction, which
/// points to larger axial coordinates and has a positive y component. A yaw of the wheelset turns
/// it out of the plane x = 0.
struct Axle {
  Vector3 point{};  ///< mm
  Vector3 direction{0.0, 1.0, 0.0};
};

/// Position of a point relative to the axle.
struct AxlePlace {
  double axial = 0.0;   ///< mm along the axle
  double radius = 0.0;  ///< mm from the axle
  Vector3 across{};     ///< mm, from the axle, perpendicular to it
};
AxlePlace axle_place(const Axle& axle, const Vector3& place);

/// Angle about the axle from the direction straight into the rail (-z), rad, positive towards x.
double angle_about(const Axle& axle, const Vector3& across);

/// Radius of a wheel that is not round, mm, with its derivatives by the axial coordinate and by the
/// angle (mm/rad).
struct RadiusAround {
  double value = 0.0, by_axial = 0.0, by_angle = 0.0;
};
/// Over the axial coordinate and angle_about. The radius is infinite where it is not known.
using WheelSurface = std::function<RadiusAround(double axial, double angle)>;
/// Height z of a rail that changes along the track, mm; minus infinity where it is not known.
using RailSurface = std::function<double(double x, double y)>;

/// Position of the wheel under load, y and z of the patch frame.
struct Sinking {
  std::array<double, 2> way{};  ///< mm, of the wheel from first touch; z is minus the approach
  std::array<double, 2>
      approach{};  ///< mm, of the bodies as subtracted again by the contact problem
};

/// An end of a body across rolling (ProfileSource::free_ends).
struct FreeEnd {
  double y = 0.0;  ///< mm, patch frame
  bool of_wheel = false;
};

/// Pressure with which independent errors of heights press where contact is full, MPa, rms: a wave
/// of the number k presses with E*/2 k times its height, and up to k = pi / spacing the mean of k^2
/// is a third of the largest. `contact_modulus`: E*, MPa; `scatter`, `spacing`: of the heights, mm.
inline double pressure_of_scatter(double contact_modulus, double scatter, double spacing) {
  return 0.5 * contact_modulus * scatter * M_PI / (std::sqrt(3.0) * spacing);
}

class PatchGeometry {
 public:
  PatchGeometry() = default;
  /// `rail`: z over y in the patch frame, through (0, 0), where it need not be level.
  /// `wheel_radius`: radius over the axial coordinate. The wheel's section at x = 0 is evaluated
  /// between `y_lower` and `y_upper` within the profile. Throws std::invalid_argument when the
  /// wheel has no surface below its axle there.
  PatchGeometry(HeightCurve rail, HeightCurve wheel_radius, const Axle& axle, double y_lower,
                double y_upper);

  const HeightCurve& rail() const { return rail_; }
  /// Section of the wheel at x = 0: height z over y.
  const HeightCurve& wheel() const { return wheel_; }
  const HeightCurve& wheel_radius() const { return wheel_radius_; }
  const Axle& axle() const { return axle_; }

  /// Makes the rail a roller of this rolling radius (Rail::rolling_radius): `radius` over the axial
  /// coordinate of its axle, which lies in the plane x = 0; rail() is its section there.
  void set_roller(double rolling_radius, HeightCurve radius, const Axle& axle);
  bool is_roller() const { return std::isfinite(rail_rolling_radius_); }
  double rail_rolling_radius() const { return rail_rolling_radius_; }  ///< mm, infinite: straight
  const HeightCurve& rail_radius() const { return rail_radius_; }      ///< of a roller
  const Axle& rail_axle() const { return rail_axle_; }                 ///< of a roller
  /// tilt() of that axle.
  double rail_tilt() const;

  /// Bodies that change along the way: then rail(), wheel() and wheel_radius() are their sections
  /// at x = 0, and distances are those of the surfaces. Either may be empty.
  void set_surfaces(RailSurface rail, WheelSurface wheel);
  bool varies() const { return rail_surface_ || wheel_surface_; }
  /// Largest difference over the patch between this distance and that of a round wheel on a
  /// straight rail with these sections, divided by the approach; 0 for such bodies.
  double variation() const { return variation_; }
  void set_variation(double over_approach) { variation_ = over_approach; }

  /// The same bodies with distances of the wheel at its height under load, still measured from
  /// first touch: the approach is added again. In a plane whose normal is not vertical, a sinking
  /// wheel also moves sideways, which closes some flanks and opens others by microns; a small
  /// second patch has an approach of microns. `approach`: mm along z; `sinks`: y and z of the
  /// direction against which the wheel sinks; `along`: direction along which the contact problem
  /// subtracts the approach (NormalLoad).
  PatchGeometry under_load(double approach, const std::array<double, 2>& sinks,
                           const std::array<double, 2>& along) const;
  const Sinking& sinking() const { return sinking_; }
  /// wheel() after the sideways motion; z as at first touch.
  CurveValue wheel_under_load(double y) const { return wheel_.at(y - sinking_.way[0]); }

  AxlePlace axle_place(const Vector3& place) const { return contact::axle_place(axle_, place); }
  /// Radius of the wheel there.
  RadiusAround radius_around(const AxlePlace& at) const;
  /// Height z of the wheel's surface, mm; infinite outside the wheel.
  double wheel_height(double x, double y) const;
  /// The same of the rail; minus infinity outside a roller.
  double rail_height(double x, double y) const;
  /// Undeformed distance along z, mm; 0 where the bodies just touch, which need not be the origin.
  /// Under load (`under_load`) microns more or less.
  double distance(double x, double y) const;
  /// Distance of the wheel's surface at x = 0 from the axle, mm.
  double local_rolling_radius(double y) const;
  /// The same of a roller, with the sign of its rolling radius.
  double local_rail_radius(double y) const;
  /// Angle of the axle against the y axis in the plane x = 0, rad: sine = e_z.
  double tilt() const;
  /// Beyond these y (mm) any contact of the bodies is a separate contact.
  const std::array<double, 2>& limits() const { return limits_; }
  void set_limits(const std::array<double, 2>& limits) { limits_ = limits; }
  bool within_limits(double y) const { return y >= limits_[0] && y <= limits_[1]; }

  /// Ends of the bodies themselves, rather than of what is known of them.
  const std::vector<FreeEnd>& free_ends() const { return free_ends_; }
  void set_free_ends(std::vector<FreeEnd> ends) { free_ends_ = std::move(ends); }

  /// Standard deviation of the heights of rail and wheel where files round their points, mm.
  const std::array<double, 2>& rounding() const { return rounding_; }
  void set_rounding(const std::array<double, 2>& rounding) { rounding_ = rounding; }

  /// Whether both profiles are known here.
  bool known(double y) const { return rail_.contains(y) && wheel_.contains(y); }

 private:
  HeightCurve rail_;
  HeightCurve wheel_radius_;
  HeightCurve wheel_;
  Axle axle_;
  double rail_rolling_radius_ = std::numeric_limits<double>::infinity();
  HeightCurve rail_radius_;
  Axle rail_axle_;
  RailSurface rail_surface_;
  WheelSurface wheel_surface_;
  double variation_ = 0.0;
  Sinking sinking_;
  std::array<double, 2> limits_{-std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::infinity()};
  std::vector<FreeEnd> free_ends_;
  std::array<double, 2> rounding_{};
};

/// "left" or "right": the wheel in texts, files and names.
inline const char* side_word(bool left) {
  return left ? "left" : "right";
}

/// Position of a patch on the track and on the profiles, for reports. Track frame: x along the
/// track, y to the right, z down, origin in the middle of the track at the level of the rails.
/// Profile coordinates are those of the profile files: y towards the field side positive, z down,
/// of the wheel outward.
struct ContactPlace {
  bool left = true;  ///< wheel
  int position = 1, patch = 1, patches = 1;
  double lateral_shift = 0.0, yaw = 0.0, roll = 0.0, height = 0.0;
  double x_track = 0.0, y_track = 0.0, z_track = 0.0, y_rail = 0.0, y_wheel = 0.0;
  double contact_angle = 0.0, climb = 0.0, rolling_radius = 0.0, separation = 0.0;
  double rail_turn = 0.0;  ///< rad, of the rail's profile from y to z, as it stands
  /// mm along the common surface of wheel and rail across, outward; only differences between
  /// contacts of one wheel are meaningful.
  double way_across = 0.0;
  double vertical_force = 0.0;  ///< N, of this patch with friction, 0: unknown
  /// Direction of the patch frame's y along way_across: to the field side on the left wheel, to the
  /// middle on the right.
  double outward() const { return left ? 1.0 : -1.0; }
  const char* side() const { return side_word(left); }
  bool same_wheel(const ContactPlace& other) const {
    return left == other.left && position == other.position;
  }
  bool same_patch(const ContactPlace& other) const {
    return same_wheel(other) && patch == other.patch;
  }
  /// "left_3_1": side, position and patch, which tell the patches of a case apart.
  std::string key(char between = '_') const;
  /// "left, position 3, patch 1 of 2", with a `noun` "left wheel, position 3"; empty parts left
  /// out.
  std::string label(const std::string& noun = "") const;

  static constexpr auto members() {
    using P = ContactPlace;
    return std::tuple(
        member_within("left", &P::left), member("wheel", &P::side, "", "left or right"),
        member("position", &P::position, "-", "number of the wheelset's position, from 1"),
        member("patch", &P::patch, "-",
               "number of the patch of this wheel at this position, from 1, the most loaded first"),
        member("patches", &P::patches, "-", "number of patches of this wheel at this position"),
        member("lateral_shift", &P::lateral_shift, "mm", "of the wheelset, positive to the right"),
        member("yaw", &P::yaw, "rad",
               "of the wheelset, positive from x to y of the track (to the right)"),
        member("roll", &P::roll, "rad",
               "of the wheelset, positive from y to z of the track (right wheel down)"),
        member("height", &P::height, "mm",
               "z of the middle of the axle (down) plus the nominal rolling radius"),
        member("x_track", &P::x_track, "mm",
               "contact point in the track frame, ahead of the middle of the axle"),
        member("y_track", &P::y_track, "mm", "contact point in the track frame, y to the right"),
        member("z_track", &P::z_track, "mm",
               "contact point in the track frame, z down from the top of the rails"),
        member("y_rail", &P::y_rail, "mm", "contact point in the rail's profile coordinates"),
        member("y_wheel", &P::y_wheel, "mm", "contact point in the wheel's profile coordinates"),
        member("contact_angle", &P::contact_angle, "rad",
               "of the contact plane, positive where it falls towards the middle of the track, as "
               "at a flange"),
        member("climb", &P::climb, "rad",
               "rise of the contact plane ahead, on a rail that changes along the track"),
        member("rolling_radius", &P::rolling_radius, "mm",
               "distance of the contact point from the axle"),
        member("separation", &P::separation, "mm",
               "distance along the normal at first contact of the wheel"),
        member_within("rail_turn", &P::rail_turn), member_within("way_across", &P::way_across),
        member_within("vertical_force", &P::vertical_force));
  }
};

/// Angle between the planes of two contacts of a wheel, rad: positive where the rail is convex and
/// the wheel concave between them.
double turn_between(const ContactPlace& a, const ContactPlace& b);

/// Inclination of the rail's surface at y of the patch frame against the track plane, rad: negative
/// where it falls towards the middle of the track (gauge face), on either side; at the reference
/// point minus the contact angle, but for the waves of the profile.
double rail_inclination(const PatchGeometry& patch, const ContactPlace& place, double y);

}  // namespace rollfem::contact

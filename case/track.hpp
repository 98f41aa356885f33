// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheels with true profiles on a track: profiles, gauge, inclination, wheelset, motion. Plain
// values; track/ turns them into scenes. Track frame: x along the track, y to the right, z down.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rollfem::contact {

/// Whether a file is a list of sections along the way: .sections, .slcs (CONTACT, of a rail) or
/// .slcw (of a wheel).
inline bool is_list_of_sections(std::string_view file) {
  for (const std::string_view ending : {".sections", ".slcs", ".slcw"})
    if (file.size() > ending.size() && file.substr(file.size() - ending.size()) == ending)
      return true;
  return false;
}

enum class LengthUnit { mm, m, inch };

/// A profile as given in the case: [wheel] profile and [wheel_profile], or the same for the rail.
/// Defects of a file are repaired only where one of these keys requests it.
struct ProfileSource {
  std::string name;  ///< built in, "arcs", "polynomial" or a file; empty: the body has radii
  /// "arcs": radii in mm, > 0 convex (of the body), < 0 concave, inf straight, tangent to each
  /// other; ends in mm of y. Symmetric: from the middle outwards, one end each; otherwise from
  /// small to large y, one end more than radii, around (0, 0), where dz/dy is `slope`.
  std::vector<double> radii;
  std::vector<double> ends;
  bool symmetric = false;
  double slope = 0.0;
  /// "polynomial": z in mm over y in mm, lowest order first, the same number for every piece;
  /// limits of the pieces, one more than pieces.
  std::vector<double> coefficients;
  std::vector<double> limits;
  // For all profiles.
  bool mirror = false;                ///< y -> -y
  bool free_ends = false;             ///< the body has side faces where its profile ends
  double rotation = 0.0;              ///< rad, from y to z, about (0, 0), before the shift
  std::array<double, 2> shift{0, 0};  ///< mm, along y and z
  // For files.
  bool for_track =
      true;  ///< a wheel with a flange or a rail with a head, which show where z points
  LengthUnit unit = LengthUnit::mm;
  std::string section;           ///< of a file with several profiles
  std::string text;              ///< the contents of the file; empty: it is read
  bool flip = false;             ///< z -> -z: the file's z is upward
  bool reverse = false;          ///< the file's last point first
  bool sort = false;             ///< by increasing y
  bool drop_duplicates = false;  ///< points that repeat the previous one
  double thinning = 0.0;         ///< mm; closer points are merged; 0: keep all
  bool drop_zigzag = false;      ///< points at which the curve turns back
  double longest_gap = 5.0;      ///< mm between two points
  double largest_kink = 20.0;    ///< degrees between two chords
  double rounding = 0.0;         ///< mm dropped on both sides of a kink or step
  double smoothing = 0.0;        ///< mm, scatter to be smoothed away; 0: through the points

  bool lists_sections() const { return is_list_of_sections(name); }
};

struct Track {
  double gauge = 1435.0;       ///< mm, between the rails
  double gauge_height = 14.0;  ///< mm below the top of the rails at which it is measured
  /// mm, y of the gauge face in the coordinates of the rail's profile; none: found from it.
  std::optional<double> gauge_face;
  double inclination = 0.0;  ///< of each rail towards the middle, as a tangent: 1/40
  /// mm, of the origin of the rail's profile from the middle of the track outwards, and down:
  /// instead of the gauge
  std::optional<std::array<double, 2>> rail_position;
  /// N/mm, of the springs under each rail, across and vertical; none: the rails stay in place.
  std::optional<std::array<double, 2>> rail_stiffness;
  /// N, on the rail besides that of the contact, to the right and down.
  std::array<double, 2> rail_force{};
};

enum class WheelSide { left, right, both };

/// Condition for the rotation of the wheelset, when no longitudinal creepage is given.
enum class FreeRolling {
  none,    ///< Wheelset::rotation_change
  force,   ///< F_x on each wheel separately is Wheelset::longitudinal_force
  torque,  ///< the torque of the wheels' tractions about the axle is Wheelset::axle_torque
};

/// Displacement and velocity of wheels or rails from where wheelset and track put them, left and
/// right, in the track frame. Both are turned about the origin of their profile, with their axles;
/// velocities are those of this origin and about it, rotation is about the wheel's axle. A
/// displaced body moves as it would without displacement, about its displaced axle.
struct Displacement {
  using Sides = std::array<double, 2>;
  Sides longitudinal{}, lateral{}, vertical{};  ///< mm; vertical: down
  Sides roll{}, yaw{};                          ///< rad
  /// Over the forward speed; rotations in rad/mm.
  Sides longitudinal_velocity{}, lateral_velocity{}, vertical_velocity{};
  Sides roll_velocity{}, yaw_velocity{}, rotation{};
};

struct Wheelset {
  /// The wheel alone is placed in the coordinates of the rail's profile, y to the field and z down,
  /// without a track: positions and motion are those of its centre, with the signs of that frame.
  bool on_rail = false;
  WheelSide side = WheelSide::left;      ///< which wheels are computed
  double flange_back_distance = 1360.0;  ///< mm, between the backs of the flanges
  double flange_back_position = -70.0;   ///< mm, of the back in the wheel's profile coordinates
  /// Positions: lists of one length.
  std::vector<double> lateral_shift{0.0};  ///< mm, positive to the right
  std::vector<double> yaw{0.0};            ///< rad, positive from x to y (to the right)
  std::vector<double> roll;                ///< rad, positive from y to z; empty: found by contact
  /// mm, z of the middle of the axle plus the rolling radius; empty: the load determines it
  std::vector<double> height;
  std::vector<double> track_position;  ///< mm along the track; empty: nothing depends on it
  /// rad, of the section of a wheel that points down, larger as the wheel rolls forward; empty: the
  /// wheel is round
  std::vector<double> wheel_angle;
  double lateral_velocity =
      0.0;                     ///< of the wheelset, over the forward speed, positive to the right
  double yaw_velocity = 0.0;   ///< rad/mm: yaw rate over the forward speed
  double roll_velocity = 0.0;  ///< rad/mm
  /// Over the forward speed, downwards; not given: wheel and rail neither part nor overlap.
  std::optional<double> vertical_velocity;
  /// Relative change of the rotation against V / rolling_radius; load points. Empty: 0.
  std::vector<double> rotation_change;
  FreeRolling free_rolling = FreeRolling::none;
  std::vector<double> longitudinal_force, axle_torque;  ///< N, N mm; load points. Empty: 0
  std::size_t positions() const { return lateral_shift.size(); }
};

}  // namespace rollfem::contact

// How wheels with true profiles stand on a track: profiles, gauge, inclination, wheelset, motion.
// Values in, no behaviour; scenes are made of them by meshes/. Track frame: x along the track, y to
// the right, z down.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rollfem::contact {

/// A profile as the case names it.
struct ProfileSource {
  std::string name;  ///< built in, "arcs", "polynomial" or a file; empty: the body has radii
};

struct Track {
  double gauge = 1435.0;       ///< mm, between the rails
  double gauge_height = 14.0;  ///< mm below the top of the rails at which it is measured
  double inclination = 0.0;    ///< of each rail towards the middle, as a tangent: 1/40
};

enum class WheelSide { left, right, both };

/// What decides how fast the wheelset turns, when no longitudinal creepage is given.
enum class FreeRolling {
  none,    ///< Wheelset::rotation_change
  force,   ///< F_x = 0 on each wheel by itself
  torque,  ///< the two wheels' tractions make no torque about the axle
};

struct Wheelset {
  WheelSide side = WheelSide::left;      ///< which wheels are computed
  double flange_back_distance = 1360.0;  ///< mm, between the backs of the flanges
  double flange_back_position = -70.0;   ///< mm, of the back in the wheel's profile coordinates
  /// Positions: lists of one length.
  std::vector<double> lateral_shift{0.0};  ///< mm, positive to the right
  std::vector<double> yaw{0.0};            ///< rad, positive from x to y (to the right)
  std::vector<double> roll;                ///< rad, positive from y to z; empty: found by contact
  double lateral_velocity =
      0.0;                    ///< of the wheelset, over the forward speed, positive to the right
  double yaw_velocity = 0.0;  ///< rad/mm: yaw rate over the forward speed
  /// Relative change of the rotation against V / rolling_radius; load points. Empty: 0.
  std::vector<double> rotation_change;
  FreeRolling free_rolling = FreeRolling::none;
  std::size_t positions() const { return lateral_shift.size(); }
};

}  // namespace rollfem::contact

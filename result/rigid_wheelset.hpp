// SPDX-License-Identifier: LGPL-2.1-or-later
// A laterally shifted wheelset whose rigid, unloaded wheels touch their rails.
#pragma once

#include "base/members.hpp"

#include <optional>

namespace rollfem::contact {

struct RigidWheelset {
  double lateral_shift = 0.0, roll = 0.0;
  double radius_left = 0.0, radius_right = 0.0;
  double angle_left = 0.0, angle_right = 0.0;
  double y_wheel_left = 0.0, y_wheel_right = 0.0;
  /// At the amplitude of the shift (track/motion/wheelset_motion.hpp). None at 0, and where the
  /// wheelset does not recentre.
  std::optional<double> conicity_harmonic = {}, conicity_wave = {}, wave_length = {};
  double y_track_left = 0.0, y_track_right = 0.0;  ///< mm, from the middle of the track outward
  /// Difference of rolling radius over speed of the supporting surface (V = 1), mm: steers the
  /// wheelset, also on rollers.
  double rolling_difference = 0.0;

  double radius_difference() const { return radius_right - radius_left; }  ///< mm

  static constexpr auto members() {
    using W = RigidWheelset;
    return std::tuple(member("lateral_shift", &W::lateral_shift, "mm", "to the right"),
                      member("roll", &W::roll, "rad", "positive from y to z"),
                      member("radius_left", &W::radius_left, "mm", "rolling radius"),
                      member("radius_right", &W::radius_right, "mm", "rolling radius"),
                      member("radius_difference", &W::radius_difference, "mm", "right minus left"),
                      member("angle_left", &W::angle_left, "rad",
                             "contact angle, positive where the surfaces fall towards the middle"),
                      member("angle_right", &W::angle_right, "rad", "the same"),
                      member("y_wheel_left", &W::y_wheel_left, "mm", "of the wheel's profile"),
                      member("y_wheel_right", &W::y_wheel_right, "mm", "of the wheel's profile"),
                      member("conicity_harmonic", &W::conicity_harmonic, "-",
                             "equivalent conicity by harmonic linearisation"),
                      member("conicity_wave", &W::conicity_wave, "-",
                             "equivalent conicity by the wave of the free wheelset"),
                      member("wave_length", &W::wave_length, "mm", "of this wave"),
                      member_within("y_track_left", &W::y_track_left),
                      member_within("y_track_right", &W::y_track_right),
                      member_within("rolling_difference", &W::rolling_difference));
  }
};

}  // namespace rollfem::contact

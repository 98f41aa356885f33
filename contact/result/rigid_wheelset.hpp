// SPDX-License-Identifier: LGPL-2.1-or-later
// A laterally shifted wheelset whose rigid, unloaded wheels touch their rails.
#pragma once

#include <optional>

namespace rollfem::contact {

struct RigidWheelset {
  double lateral_shift = 0.0;                      ///< mm, to the right
  double roll = 0.0;                               ///< rad
  double radius_left = 0.0, radius_right = 0.0;    ///< mm, rolling radii
  double angle_left = 0.0, angle_right = 0.0;      ///< rad, contact angles, positive where the
                                                   ///< surfaces fall towards the middle
  double y_wheel_left = 0.0, y_wheel_right = 0.0;  ///< mm, of the wheel's profile
  /// Equivalent conicity at the amplitude of the shift (track/motion/wheelset_motion.hpp), by
  /// harmonic linearisation and by the wave of the free wheelset, and its wavelength in mm. None at
  /// 0, and where the wheelset does not recentre.
  std::optional<double> conicity_harmonic = {}, conicity_wave = {}, wave_length = {};
  double y_track_left = 0.0, y_track_right = 0.0;  ///< mm, from the middle of the track outward

  /// Of the radii over the speeds (V = 1) of the surfaces on which they roll, which steers, mm.
  double rolling_difference = 0.0;

  double radius_difference() const { return radius_right - radius_left; }  ///< mm
};

}  // namespace rollfem::contact

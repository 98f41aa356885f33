// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact points of the rigid, unloaded wheels of a wheelset as it moves sideways: the rolling
// radii and contact angles for the conicity (wheelset_motion.hpp).
#pragma once

#include "contact/case/case.hpp"
#include "track/placement/wheelset_pose.hpp"

#include <optional>
#include <vector>

namespace rollfem::track {

/// The lowest point of the gap under a wheel.
struct RigidTouch {
  double rolling_radius = 0.0;  ///< mm
  double contact_angle = 0.0;   ///< rad, positive where the surfaces fall towards the middle
  double y_wheel = 0.0;         ///< mm, of the wheel's profile
  double y_track = 0.0;         ///< mm, from the middle of the track outward
};

struct WheelsetTouch {
  double lateral_shift = 0.0;  ///< mm, to the right
  double roll = 0.0;           ///< rad
  RigidTouch left, right;
  /// mm, of the right wheel less that of the left one.
  double radius_difference() const { return right.rolling_radius - left.rolling_radius; }
};

/// Touching points at the given shifts, without yaw; roll from the case, otherwise computed. Ends
/// before the first shift at which a wheel leaves its rail or its profile ends. Throws as find_pose
/// at the first shift.
std::vector<WheelsetTouch> rigid_touches(const contact::Case& input, const SearchScene& search,
                                         const std::vector<double>& lateral_shifts);

struct WheelsetRow {
  WheelsetTouch touch;
  /// Equivalent conicity at the amplitude of this shift (wheelset_motion.hpp), by harmonic
  /// linearisation and by the wave of the free wheelset, and its wavelength in mm. None at 0, and
  /// where the wheelset does not recentre.
  std::optional<double> harmonic, wave, wave_length;
};

/// Distance of the running circles, mm: 1500 on a gauge of 1435.
double contact_distance(const contact::Track& track);

/// From the middle to `reach` mm by `step` mm; the other side is the mirror image.
std::vector<WheelsetRow> wheelset_rows(const contact::Case& input, const SearchScene& search,
                                       double reach, double step);

/// At any shift (mm, either side), with the conicity at its amplitude from the radii of `rows`,
/// which begin in the middle; empty where a wheel leaves its rail or its profile ends.
std::optional<WheelsetRow> wheelset_row(const contact::Case& input, const SearchScene& search,
                                        const std::vector<WheelsetRow>& rows, double shift);

}  // namespace rollfem::track

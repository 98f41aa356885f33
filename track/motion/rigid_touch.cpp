// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/motion/rigid_touch.hpp"

#include "contact/base/errors.hpp"
#include "track/motion/wheelset_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::track {

namespace {

RigidTouch touch_of(const contact::Case& input, const SearchScene& search, WheelsetPose pose,
                    int position, bool left) {
  const VerticalGap gap = touching_gap(input, search, pose, position, left);
  const GapMinimum lowest = gap.lowest();
  const OutlinePoint at = gap.wheel().at(lowest.y);
  return {at.radius, lowest.angle(), at.profile_y, lowest.y};
}

}  // namespace

std::vector<WheelsetTouch> rigid_touches(const contact::Case& input, const SearchScene& search,
                                         const std::vector<double>& lateral_shifts) {
  contact::Case moved = input;
  moved.wheelset.lateral_shift = lateral_shifts;
  moved.wheelset.yaw.assign(lateral_shifts.size(), 0.0);
  if (!input.wheelset.roll.empty())
    moved.wheelset.roll.assign(lateral_shifts.size(), input.wheelset.roll.front());
  std::vector<WheelsetTouch> touches;
  for (std::size_t k = 0; k < lateral_shifts.size(); ++k) {
    const int position = static_cast<int>(k) + 1;
    try {
      const WheelsetPose pose = find_pose(moved, search, position);
      WheelsetTouch touch;
      touch.lateral_shift = lateral_shifts[k];
      touch.roll = pose.roll;
      touch.left = touch_of(moved, search, pose, position, true);
      touch.right = touch_of(moved, search, pose, position, false);
      touches.push_back(touch);
    } catch (const contact::SolveError&) {
      if (touches.empty()) throw;
      break;
    } catch (const contact::InputError&) {
      if (touches.empty()) throw;
      break;
    }
  }
  return touches;
}

double contact_distance(const contact::Track& track) {
  return track.gauge + 65.0;
}

namespace {

/// Empty for fewer than two rows.
std::optional<RadiusDifference> radii_of(const std::vector<WheelsetRow>& rows) {
  std::vector<double> at, difference;
  for (const WheelsetRow& row : rows) {
    at.push_back(row.touch.lateral_shift);
    // In the middle both wheels are alike.
    difference.push_back(at.size() == 1 ? 0.0 : row.touch.radius_difference());
  }
  if (at.size() < 2) return {};
  return RadiusDifference(std::move(at), std::move(difference));
}

void add_conicity(const contact::Case& input, const RadiusDifference& radii, WheelsetRow& row) {
  const double amplitude = row.touch.lateral_shift;
  const double distance = contact_distance(input.track);
  const double radius = input.wheel.rolling_radius;
  row.harmonic = radii.harmonic_conicity(amplitude);
  row.wave_length = radii.wave_length(amplitude, distance, radius);
  if (row.wave_length) row.wave = conicity_of_wave(*row.wave_length, distance, radius);
}

WheelsetTouch mirrored(const WheelsetTouch& touch) {
  return {0.0 - touch.lateral_shift, 0.0 - touch.roll, touch.right, touch.left};
}

}  // namespace

std::vector<WheelsetRow> wheelset_rows(const contact::Case& input, const SearchScene& search,
                                       double reach, double step) {
  std::vector<double> shifts;
  for (int k = 0; k <= std::lround(reach / step); ++k) shifts.push_back(k * step);
  std::vector<WheelsetRow> rows;
  for (const WheelsetTouch& touch : rigid_touches(input, search, shifts))
    rows.push_back({touch, {}, {}, {}});
  const std::optional<RadiusDifference> radii = radii_of(rows);
  for (std::size_t k = 1; k < rows.size(); ++k) add_conicity(input, *radii, rows[k]);
  return rows;
}

std::optional<WheelsetRow> wheelset_row(const contact::Case& input, const SearchScene& search,
                                        const std::vector<WheelsetRow>& rows, double shift) {
  const double amplitude = std::abs(shift);
  WheelsetRow row;
  try {
    row.touch = rigid_touches(input, search, {amplitude}).front();
  } catch (const contact::SolveError&) {
    return {};
  } catch (const contact::InputError&) {
    return {};
  }
  const std::optional<RadiusDifference> radii = radii_of(rows);
  // Within the first piece the radii are known only at its ends.
  if (radii && amplitude >= rows[1].touch.lateral_shift &&
      amplitude <= radii->largest_shift() * (1.0 + 1e-12))
    add_conicity(input, *radii, row);
  if (shift < 0.0) row.touch = mirrored(row.touch);
  return row;
}

}  // namespace rollfem::track

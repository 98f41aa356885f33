// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/motion/rigid_touch.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "track/motion/wheelset_motion.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace rollfem::track {

namespace {

/// The wheelset that touches at the lowest points of the gaps under its wheels.
RigidWheelset touching(const contact::Case& input, const SearchScene& search, int position) {
  const WheelsetPose pose = find_pose(input, search, position);
  RigidWheelset touch;
  touch.lateral_shift = pose.lateral_shift;
  touch.roll = pose.roll;
  for (const bool left : {true, false}) {
    WheelsetPose lowered = pose;
    const VerticalGap gap = touching_gap(input, search, lowered, position, left);
    const GapMinimum lowest = gap.lowest();
    const OutlinePoint at = gap.wheel().at(lowest.y);
    const double roller = input.rail.rolling_radius;
    const contact::Vector3 place{0.0, lowest.y, gap.rail().at(lowest.y).value};
    double speed = 1.0;
    if (std::isfinite(roller))
      speed = contact::axle_place(roller_axle(search.rail(left).place, roller), place).radius /
              std::abs(roller);
    touch.rolling_difference += side_sign(left) * at.radius / speed;
    (left ? touch.radius_left : touch.radius_right) = at.radius;
    (left ? touch.angle_left : touch.angle_right) = lowest.angle();
    (left ? touch.y_wheel_left : touch.y_wheel_right) = at.profile_y;
    (left ? touch.y_track_left : touch.y_track_right) = lowest.y;
  }
  return touch;
}

}  // namespace

std::vector<RigidWheelset> rigid_touches(const contact::Case& input, const SearchScene& search,
                                         const std::vector<double>& lateral_shifts) {
  contact::Case moved = input;
  moved.wheelset.lateral_shift = lateral_shifts;
  moved.wheelset.yaw.assign(lateral_shifts.size(), 0.0);
  for (auto* list :
       {&moved.wheelset.roll, &moved.wheelset.track_position, &moved.wheelset.wheel_angle})
    if (!list->empty()) list->assign(lateral_shifts.size(), list->front());
  std::vector<RigidWheelset> touches(lateral_shifts.size());
  std::atomic<std::size_t> count{touches.size()};  // before the first that does not touch
  contact::for_each_index(touches.size(), [&](std::size_t k) {
    if (k > count) return;
    try {
      touches[k] = touching(moved, search, static_cast<int>(k) + 1);
    } catch (const contact::Failure&) {
      if (k == 0) throw;
      for (std::size_t before = count; k < before && !count.compare_exchange_weak(before, k);) {
      }
    }
  });
  touches.resize(count);
  return touches;
}

double contact_distance(const contact::Track& track) {
  return track.gauge + 65.0;
}

namespace {

/// Empty for fewer than two rows.
std::optional<RadiusDifference> radii_of(const std::vector<RigidWheelset>& rows) {
  std::vector<double> at, difference;
  for (const RigidWheelset& row : rows) {
    at.push_back(row.lateral_shift);
    // In the middle both wheels are alike.
    difference.push_back(at.size() == 1 ? 0.0 : row.rolling_difference);
  }
  if (at.size() < 2) return {};
  return RadiusDifference(std::move(at), std::move(difference));
}

void add_conicity(const contact::Case& input, const RadiusDifference& radii, RigidWheelset& row) {
  const double amplitude = row.lateral_shift;
  const double distance = contact_distance(input.track);
  const double radius = input.wheel.rolling_radius;
  row.conicity_harmonic = radii.harmonic_conicity(amplitude);
  row.wave_length = radii.wave_length(amplitude, distance, radius);
  if (row.wave_length) row.conicity_wave = conicity_of_wave(*row.wave_length, distance, radius);
}

RigidWheelset mirrored(RigidWheelset wheelset) {
  wheelset.lateral_shift = 0.0 - wheelset.lateral_shift;
  wheelset.roll = 0.0 - wheelset.roll;
  std::swap(wheelset.radius_left, wheelset.radius_right);
  wheelset.rolling_difference = 0.0 - wheelset.rolling_difference;
  std::swap(wheelset.angle_left, wheelset.angle_right);
  std::swap(wheelset.y_wheel_left, wheelset.y_wheel_right);
  std::swap(wheelset.y_track_left, wheelset.y_track_right);
  return wheelset;
}

}  // namespace

std::vector<RigidWheelset> wheelset_rows(const contact::Case& input, const SearchScene& search,
                                         double reach, double step) {
  std::vector<double> shifts;
  for (int k = 0; k <= std::lround(reach / step); ++k) shifts.push_back(k * step);
  std::vector<RigidWheelset> rows = rigid_touches(input, search, shifts);
  const std::optional<RadiusDifference> radii = radii_of(rows);
  for (std::size_t k = 1; k < rows.size(); ++k) add_conicity(input, *radii, rows[k]);
  return rows;
}

std::optional<RigidWheelset> wheelset_row(const contact::Case& input, const SearchScene& search,
                                          const std::vector<RigidWheelset>& rows, double shift) {
  const double amplitude = std::abs(shift);
  auto touch = contact::attempt([&] { return rigid_touches(input, search, {amplitude}).front(); });
  if (!touch) return {};
  RigidWheelset& row = *touch;
  const std::optional<RadiusDifference> radii = radii_of(rows);
  // Within the first piece the radii are known only at its ends.
  if (radii && amplitude >= rows[1].lateral_shift &&
      amplitude <= radii->largest_shift() * (1.0 + 1e-12))
    add_conicity(input, *radii, row);
  return shift < 0.0 ? mirrored(row) : row;
}

}  // namespace rollfem::track

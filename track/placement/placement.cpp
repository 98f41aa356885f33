// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/placement/placement.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/root.hpp"

#include <boost/math/tools/minima.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace rollfem::track {

namespace {

/// Minimum of a function, refined around the smallest of the values `known` at the points `at`.
template <class Value>
double smallest(const std::vector<double>& at, const std::vector<double>& known,
                const Value& value) {
  const std::size_t best =
      static_cast<std::size_t>(std::min_element(known.begin(), known.end()) - known.begin());
  // At a smooth minimum, half the digits of the argument give all digits of the value.
  constexpr int bits = std::numeric_limits<double>::digits / 2;
  const auto beside = boost::math::tools::brent_find_minima(
      value, at[best > 0 ? best - 1 : 0], at[std::min(best + 1, at.size() - 1)], bits);
  return std::min(known[best], beside.second);
}

}  // namespace

double side_sign(bool left) {
  return left ? -1.0 : 1.0;
}

RailPlace rail_place(const profiles::ProfileCurve& rail, const contact::Track& track) {
  RailPlace place;
  place.angle = -std::atan(track.inclination);
  if (track.rail_position)
    return {place.angle, (*track.rail_position)[0], (*track.rail_position)[1]};
  const profiles::ProfileCurve turned = rail.moved(place.angle, 0.0, 0.0);
  // Dense enough for a profile to turn little between neighbours.
  const std::vector<double> at = profiles::dense_parameters(turned, 0.25);
  std::vector<double> y, z;
  for (const double t : at) {
    const profiles::ProfilePoint point = turned.at(t);
    y.push_back(point.y);
    z.push_back(point.z);
  }
  const double top = smallest(at, z, [&](double t) { return turned.at(t).z; });
  const double limit = top + track.gauge_height;
  // Only above the gauge height; just below it the face may be even closer to the middle.
  const auto crown = static_cast<std::size_t>(std::min_element(z.begin(), z.end()) - z.begin());
  const double deepest =
      *std::max_element(z.begin(), z.begin() + static_cast<std::ptrdiff_t>(crown) + 1);
  if (deepest < limit - 1e-9)
    throw contact::InputError(
        fmt::format("rail.profile: ends {:.4g} mm below its top on the gauge side, but the gauge "
                    "is measured {:.4g} mm below; allowed: a profile that extends at least to that "
                    "depth; do: use a longer profile, a smaller track.gauge_height, or mirror the "
                    "profile if its gauge face is at the larger y",
                    deepest - top, track.gauge_height));
  std::size_t first = crown;
  while (first > 0 && z[first] <= limit) --first;
  // Between `first` and the next the face crosses the gauge height.
  const auto depth = [&](double t) { return turned.at(t).z - limit; };
  double above = at[first];
  if (depth(above) > 0.0)
    above = contact::bracketed_root(depth, above, at[first + 1], 1e-13, "gauge of the track");
  std::vector<double> face{above}, face_y{turned.at(above).y};
  for (std::size_t k = first + 1; k <= crown; ++k)
    if (at[k] > above) {
      face.push_back(at[k]);
      face_y.push_back(y[k]);
    }
  const double gauge_y = smallest(face, face_y, [&](double t) { return turned.at(t).y; });
  place.shift_y = 0.5 * track.gauge - gauge_y;
  place.shift_z = -top;
  return place;
}

RailPlace rail_place(const profiles::ProfileCurve& rail, const contact::Case& input, bool left) {
  if (input.wheelset.on_rail) return {};
  RailPlace place = rail_place(rail, input.track);
  const contact::Displacement& moved = input.rail_displacement;
  const std::size_t side = left ? 0 : 1;
  place.upright_z = place.shift_z;
  place.roll = side_sign(left) * moved.roll[side];
  place.angle += place.roll;
  place.shift_y += side_sign(left) * moved.lateral[side];
  place.shift_z += moved.vertical[side];
  return place;
}

AlongRail::AlongRail(double at_x, double z, double rail_rolling_radius)
    : x(at_x), rolling_radius(rail_rolling_radius) {
  if (!on_roller()) return;
  sine = x / (rolling_radius - z);
  cosine = std::sqrt(1.0 - sine * sine);
}

contact::Vector3 AlongRail::place_from_top(const contact::Vector3& place) const {
  if (!on_roller()) return {place[0] + x, place[1], place[2]};
  const double up = rolling_radius - place[2];
  return {cosine * place[0] + sine * up, place[1], rolling_radius + sine * place[0] - cosine * up};
}

contact::Vector3 AlongRail::place_to_top(const contact::Vector3& place) const {
  if (!on_roller()) return {place[0] - x, place[1], place[2]};
  const double up = rolling_radius - place[2];
  return {cosine * place[0] - sine * up, place[1], rolling_radius - sine * place[0] - cosine * up};
}

contact::Vector3 AlongRail::direction_from_top(const contact::Vector3& v) const {
  return {cosine * v[0] - sine * v[2], v[1], sine * v[0] + cosine * v[2]};
}

contact::Vector3 AlongRail::direction_to_top(const contact::Vector3& v) const {
  return {cosine * v[0] + sine * v[2], v[1], cosine * v[2] - sine * v[0]};
}

profiles::ProfileCurve place_rail(const profiles::ProfileCurve& rail, const RailPlace& place) {
  return rail.moved(place.angle, place.shift_y, place.shift_z);
}

std::array<double, 2> profile_coordinates(const RailPlace& place, double y, double z) {
  const double c = std::cos(place.angle), s = std::sin(place.angle);
  const double dy = y - place.shift_y, dz = z - place.shift_z;
  return {c * dy + s * dz, -s * dy + c * dz};
}

double frame_sign(const contact::Wheelset& wheelset) {
  return wheelset.on_rail && wheelset.side == contact::WheelSide::left ? -1.0 : 1.0;
}

contact::Axle roller_axle(const RailPlace& place, double rolling_radius) {
  const double sine = std::sin(place.roll), cosine = std::cos(place.roll);
  const double below = rolling_radius - place.upright_z;
  return {{0.0, place.shift_y - below * sine, place.shift_z + below * cosine}, {0.0, cosine, sine}};
}

contact::Axle wheelset_axle(const WheelsetPose& pose, const contact::Case& input) {
  contact::Axle axle;
  axle.direction = {-std::sin(pose.yaw) * std::cos(pose.roll),
                    std::cos(pose.yaw) * std::cos(pose.roll), std::sin(pose.roll)};
  axle.point = {0.0, pose.lateral_shift, pose.height - input.wheel.rolling_radius};
  return axle;
}

contact::Axle place_axle(const WheelsetPose& pose, const contact::Case& input, bool left) {
  const double sign = side_sign(left);
  const contact::Wheelset& wheelset = input.wheelset;
  const contact::Displacement& moved = input.wheel_displacement;
  const std::size_t side = left ? 0 : 1;
  const auto direction_at = [sign](double yaw, double roll) {
    return contact::Vector3{-sign * std::sin(yaw) * std::cos(roll), std::cos(yaw) * std::cos(roll),
                            sign * std::sin(roll)};
  };
  contact::Axle axle;
  axle.direction = direction_at(pose.yaw, pose.roll);
  // Distance of profile y = 0 of an upright, centred wheel from the middle of the track.
  const double middle =
      wheelset.on_rail ? 0.0 : 0.5 * wheelset.flange_back_distance - wheelset.flange_back_position;
  const contact::Vector3 centre{moved.longitudinal[side],
                                sign * (pose.lateral_shift + moved.lateral[side]),
                                pose.height + moved.vertical[side] - input.wheel.rolling_radius};
  for (int d = 0; d < 3; ++d) axle.point[d] = centre[d] + middle * axle.direction[d];
  if (moved.roll[side] != 0.0 || moved.yaw[side] != 0.0) {
    const double roll = pose.roll + moved.roll[side];
    axle.direction = direction_at(pose.yaw + moved.yaw[side], roll);
    axle.point[1] += sign * input.wheel.rolling_radius * (std::sin(roll) - std::sin(pose.roll));
    axle.point[2] -= input.wheel.rolling_radius * (std::cos(roll) - std::cos(pose.roll));
  }
  return axle;
}

}  // namespace rollfem::track

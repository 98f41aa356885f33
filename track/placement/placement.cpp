// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/placement/placement.hpp"

#include "base/errors.hpp"
#include "base/root.hpp"

#include <boost/math/tools/minima.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
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

/// Points along a profile: parameters and coordinates.
struct Samples {
  std::vector<double> at, y, z;
  Samples part(std::size_t from, std::size_t to) const {
    const auto cut = [&](const std::vector<double>& list) {
      return std::vector<double>(list.begin() + static_cast<std::ptrdiff_t>(from),
                                 list.begin() + static_cast<std::ptrdiff_t>(to));
    };
    return {cut(at), cut(y), cut(z)};
  }
};

Samples samples_of(const profiles::ProfileCurve& curve) {
  // Dense enough for a profile to turn little between neighbours.
  Samples samples{profiles::dense_parameters(curve, 0.25), {}, {}};
  for (const double t : samples.at) {
    const profiles::ProfilePoint point = curve.at(t);
    samples.y.push_back(point.y);
    samples.z.push_back(point.z);
  }
  return samples;
}

/// The samples of each head, from the gauge side on. Heads are parted by grooves so deep that each
/// has a gauge face; neighbours share the bottom of the groove.
std::vector<Samples> heads_of(const Samples& samples, double gauge_height) {
  constexpr double least_depth = 5.0;  // mm
  const profiles::Valley groove = profiles::deepest_valley(samples.z);
  if (groove.depth < std::max(least_depth, gauge_height)) return {samples};
  std::vector<Samples> heads = heads_of(samples.part(0, groove.bottom + 1), gauge_height);
  for (Samples& head : heads_of(samples.part(groove.bottom, samples.at.size()), gauge_height))
    heads.push_back(std::move(head));
  return heads;
}

/// A head of the turned profile.
struct Head {
  double top_at = 0.0, top = 0.0;  ///< parameter and z of its highest point
  double end_y = 0.0;              ///< y of its end towards the middle
  double deepest = 0.0;            ///< largest z between that end and the top
  std::optional<double> gauge_y;   ///< none: it ends above the gauge height there
};

Head describe_head(const profiles::ProfileCurve& turned, const Samples& samples,
                   double gauge_height) {
  const auto& [at, y, z] = samples;
  const auto crown = static_cast<std::size_t>(std::min_element(z.begin(), z.end()) - z.begin());
  Head head;
  head.top_at = at[crown];
  head.top = smallest(at, z, [&](double t) { return turned.at(t).z; });
  head.end_y = y.front();
  head.deepest = *std::max_element(z.begin(), z.begin() + static_cast<std::ptrdiff_t>(crown) + 1);
  const double limit = head.top + gauge_height;
  if (head.deepest < limit - 1e-9) return head;
  // Only above the gauge height; just below it the face may be even closer to the middle.
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
  head.gauge_y = smallest(face, face_y, [&](double t) { return turned.at(t).y; });
  return head;
}

/// Puts the top of the head at z = 0 and its gauge face, or the y of the profile given for it, half
/// the gauge from the middle.
void move_to_gauge(RailPlace& place, const Head& head, const contact::Track& track) {
  const double c = std::cos(place.angle), s = std::sin(place.angle);
  const double gauge_y = track.gauge_face
                             ? (*track.gauge_face - s * (head.top + track.gauge_height)) / c
                             : head.gauge_y.value_or(head.end_y);
  place.shift_y = 0.5 * track.gauge - gauge_y;
  place.shift_z = -head.top;
}

/// y of the gauge face in profile coordinates, as track.gauge_face has it.
double gauge_face_of(const Head& head, double angle, const contact::Track& track) {
  return std::cos(angle) * head.gauge_y.value_or(head.end_y) +
         std::sin(angle) * (head.top + track.gauge_height);
}

[[noreturn]] void refuse_end(const Head& head, const contact::Track& track) {
  throw contact::InputError(
      fmt::format("rail.profile: ends {:.4g} mm below its top on the gauge side, but the gauge "
                  "is measured {:.4g} mm below; allowed: a profile that extends at least to that "
                  "depth; do: use a longer profile, a smaller track.gauge_height, or mirror the "
                  "profile if its gauge face is at the larger y, or give the y of the gauge face "
                  "as track.gauge_face",
                  head.deepest - head.top, track.gauge_height));
}

[[noreturn]] void ask_for_head(const profiles::ProfileCurve& rail, const std::vector<Head>& heads,
                               const RailPlace& place, const contact::Track& track) {
  const std::size_t all = place.tops_and_grooves.size() / 2 + 1;
  std::string places, keys;
  for (const Head& head : heads) {
    const profiles::ProfilePoint top = rail.at(head.top_at);
    const double face = gauge_face_of(head, place.angle, track);
    const std::string separator = places.empty() ? "" : " or ";
    places +=
        fmt::format("{}at y = {:.4f} mm (of the head with its top at y = {:.1f} mm, z = {:.1f} mm)",
                    separator, face, top.y, top.z);
    keys += fmt::format("{}`gauge_face = {:.4f}`", separator, face);
  }
  throw contact::InputError(fmt::format(
      "rail.profile has {} heads, whose gauge face may be {}; allowed: one gauge face; do: put {} "
      "under [track], or name a file with the points of the head that carries the wheel alone",
      all == 2 ? "two" : std::to_string(all), places, keys));
}

}  // namespace

double side_sign(bool left) {
  return left ? -1.0 : 1.0;
}

RailPlace rail_place(const profiles::ProfileCurve& rail, const contact::Track& track,
                     const std::function<bool(const RailPlace&)>& fits) {
  RailPlace place;
  place.angle = -std::atan(track.inclination);
  const profiles::ProfileCurve turned = rail.moved(place.angle, 0.0, 0.0);
  std::vector<Head> heads;
  // In given coordinates nothing is measured, and the wheel may run in a groove.
  const double least_groove = track.rail_position ? 0.0 : track.gauge_height;
  for (const Samples& samples : heads_of(samples_of(turned), least_groove)) {
    if (!heads.empty()) place.tops_and_grooves.push_back(samples.at.front());
    heads.push_back(describe_head(turned, samples, track.gauge_height));
    place.tops_and_grooves.push_back(heads.back().top_at);
  }
  if (track.rail_position) {
    place.shift_y = (*track.rail_position)[0];
    place.shift_z = (*track.rail_position)[1];
    return place;
  }
  if (track.gauge_face) {
    const auto distance = [&](const Head& head) {
      return std::abs(gauge_face_of(head, place.angle, track) - *track.gauge_face);
    };
    move_to_gauge(
        place,
        *std::min_element(heads.begin(), heads.end(),
                          [&](const Head& a, const Head& b) { return distance(a) < distance(b); }),
        track);
    return place;
  }
  // A head whose side towards the middle was not measured is taken for a guard rail's.
  std::vector<Head> candidates, fitting;
  std::copy_if(heads.begin(), heads.end(), std::back_inserter(candidates),
               [](const Head& head) { return head.gauge_y.has_value(); });
  if (candidates.empty()) refuse_end(heads.front(), track);
  if (candidates.size() > 1 && fits)
    for (const Head& head : candidates) {
      move_to_gauge(place, head, track);
      if (fits(place)) fitting.push_back(head);
    }
  if (fitting.empty()) fitting = candidates;
  if (fitting.size() > 1) ask_for_head(rail, fitting, place, track);
  move_to_gauge(place, fitting.front(), track);
  return place;
}

RailPlace displaced(RailPlace place, const contact::Case& input, bool left) {
  const contact::Displacement& moved = input.rail_displacement;
  const std::size_t side = left ? 0 : 1;
  place.upright_z = place.shift_z;
  place.roll = side_sign(left) * moved.roll[side];
  place.angle += place.roll;
  place.shift_y += side_sign(left) * moved.lateral[side];
  place.shift_z += moved.vertical[side];
  return place;
}

AlongRail::AlongRail(double at_x, double z, double roller_axle_z) : x(at_x), from{at_x, 0.0} {
  if (!std::isfinite(roller_axle_z)) return;
  from = to = {0.0, roller_axle_z};
  sine = x / (roller_axle_z - z);
  cosine = std::sqrt(1.0 - sine * sine);
}

AlongRail AlongRail::sloping(double x, double z, double slope) {
  AlongRail along;
  along.x = x;
  along.cosine = 1.0 / std::hypot(1.0, slope);
  along.sine = slope * along.cosine;
  along.from = {x, z};
  along.to = {0.0, z};
  return along;
}

double AlongRail::height_at_top(const contact::Vector3& place, double roller_axle_z) {
  if (std::isinf(roller_axle_z)) return place[2];
  const double up = roller_axle_z - place[2], x = place[0];
  const double radial = std::copysign(std::hypot(up, x), up);
  return place[2] - x * x / (radial + up);
}

contact::Vector3 AlongRail::place_from_top(const contact::Vector3& place) const {
  const contact::Vector3 turned =
      direction_from_top({place[0] - to[0], place[1], place[2] - to[1]});
  return {turned[0] + from[0], turned[1], turned[2] + from[1]};
}

contact::Vector3 AlongRail::place_to_top(const contact::Vector3& place) const {
  const contact::Vector3 turned =
      direction_to_top({place[0] - from[0], place[1], place[2] - from[1]});
  return {turned[0] + to[0], turned[1], turned[2] + to[1]};
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

namespace {

/// In the track frame, or in the side frame of the wheel with this sign.
contact::Vector3 axle_direction(double sign, double yaw, double roll) {
  return contact::Vector3{-sign * std::sin(yaw) * std::cos(roll), std::cos(yaw) * std::cos(roll),
                          sign * std::sin(roll)};
}

}  // namespace

contact::Vector3 ahead_of(const contact::Vector3& axle) {
  const double level = std::hypot(axle[0], axle[1]);
  return {axle[1] / level, -axle[0] / level, 0.0};
}

contact::Vector3 profile_origin(const contact::Axle& axle, double rolling_radius) {
  return contact::plus(axle.point, contact::cross(ahead_of(axle.direction), axle.direction),
                       rolling_radius);
}

contact::Axle wheelset_axle(const WheelsetPose& pose, const contact::Case& input) {
  return {{0.0, pose.lateral_shift, pose.height - input.wheel.rolling_radius},
          axle_direction(1.0, pose.yaw, pose.roll)};
}

contact::Axle place_axle(const WheelsetPose& pose, const contact::Case& input, bool left) {
  const double sign = side_sign(left);
  const contact::Wheelset& wheelset = input.wheelset;
  const contact::Displacement& moved = input.wheel_displacement;
  const std::size_t side = left ? 0 : 1;
  contact::Axle axle;
  axle.direction = axle_direction(sign, pose.yaw, pose.roll);
  // Distance of profile y = 0 of an upright, centred wheel from the middle of the track.
  const double middle =
      wheelset.on_rail ? 0.0 : 0.5 * wheelset.flange_back_distance - wheelset.flange_back_position;
  const contact::Vector3 centre{moved.longitudinal[side],
                                sign * (pose.lateral_shift + moved.lateral[side]),
                                pose.height + moved.vertical[side] - input.wheel.rolling_radius};
  axle.point = contact::plus(centre, axle.direction, middle);
  if (moved.roll[side] != 0.0 || moved.yaw[side] != 0.0) {
    const contact::Vector3 origin = profile_origin(axle, input.wheel.rolling_radius);
    axle.direction = axle_direction(sign, pose.yaw + moved.yaw[side], pose.roll + moved.roll[side]);
    const contact::Vector3 turned = profile_origin(axle, input.wheel.rolling_radius);
    axle.point = contact::plus(axle.point, contact::plus(origin, turned, -1.0));
  }
  return axle;
}

}  // namespace rollfem::track

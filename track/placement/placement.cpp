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

profiles::ProfileCurve place_rail(const profiles::ProfileCurve& rail, const RailPlace& place) {
  return rail.moved(place.angle, place.shift_y, place.shift_z);
}

std::array<double, 2> profile_coordinates(const RailPlace& place, double y, double z) {
  const double c = std::cos(place.angle), s = std::sin(place.angle);
  const double dy = y - place.shift_y, dz = z - place.shift_z;
  return {c * dy + s * dz, -s * dy + c * dz};
}

contact::Axle place_axle(const WheelsetPose& pose, const contact::Wheelset& wheelset,
                         double rolling_radius, bool left) {
  const double sign = side_sign(left);
  contact::Axle axle;
  axle.direction = {-sign * std::sin(pose.yaw) * std::cos(pose.roll),
                    std::cos(pose.yaw) * std::cos(pose.roll), sign * std::sin(pose.roll)};
  // Distance of profile y = 0 of an upright, centred wheel from the middle of the track.
  const double middle = 0.5 * wheelset.flange_back_distance - wheelset.flange_back_position;
  const contact::Vector3 centre{0.0, sign * pose.lateral_shift, pose.height - rolling_radius};
  for (int d = 0; d < 3; ++d) axle.point[d] = centre[d] + middle * axle.direction[d];
  return axle;
}

}  // namespace rollfem::track

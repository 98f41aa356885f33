// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/base/errors.hpp"
#include "track/placement/vertical_gap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace rollfem::track {

using contact::Axle;
using contact::Vector3;

namespace {

/// Directions across the axle: `down` in the plane x = 0, `ahead` as close to x as possible.
struct AxleFrame {
  Vector3 down{}, ahead{};
  double tangent_of_yaw = 0.0;  ///< d_x / sqrt(1 - d_x^2)
};

AxleFrame axle_frame(const Axle& axle) {
  const Vector3& d = axle.direction;
  const double across = std::sqrt(1.0 - d[0] * d[0]);
  AxleFrame frame;
  frame.tangent_of_yaw = d[0] / across;
  frame.ahead = {across, -d[0] * d[1] / across, -d[0] * d[2] / across};
  frame.down = {0.0, -d[2] / across, d[1] / across};
  return frame;
}

struct Seen {
  Vector3 place{};
  double slope = 0.0;  ///< dz/dy of the outline
  double profile_y = 0.0;
};

/// Wheel surface n = u - r' d with u = cos(a) down + sin(a) ahead; n_x = 0 gives sin(a).
std::optional<Seen> seen(const profiles::ProfilePoint& at, double rolling_radius, const Axle& axle,
                         const AxleFrame& frame) {
  if (!(at.tangent_y > 0.0)) return {};
  const double by_axial = at.tangent_z / at.tangent_y;
  const double sine = by_axial * frame.tangent_of_yaw;
  if (std::abs(sine) > 0.9) return {};
  const double cosine = std::sqrt(1.0 - sine * sine);
  const double radius = rolling_radius + at.z;
  Seen result;
  Vector3 normal{};
  for (int d = 0; d < 3; ++d) {
    const double across = cosine * frame.down[d] + sine * frame.ahead[d];
    result.place[d] = axle.point[d] + at.y * axle.direction[d] + radius * across;
    normal[d] = across - by_axial * axle.direction[d];
  }
  if (!(normal[2] > 0.0)) return {};
  result.slope = -normal[1] / normal[2];
  result.profile_y = at.y;
  if (std::abs(result.slope) > profiles::steepest) return {};
  return result;
}

/// Interpolates values between knots. Slopes from chords are accurate enough for x and the profile
/// coordinate, which only position a contact.
double value_over_y(const std::vector<double>& knots, const std::vector<double>& values, double y) {
  const auto slope = [&](std::size_t k) {
    const std::size_t a = k > 0 ? k - 1 : 0, b = std::min(k + 1, knots.size() - 1);
    return (values[b] - values[a]) / (knots[b] - knots[a]);
  };
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, y);
  const auto k = static_cast<std::size_t>(above - knots.begin()) - 1;
  const double h = knots[k + 1] - knots[k];
  // Beyond the ends, along the tangent.
  const double t = std::clamp((y - knots[k]) / h, 0.0, 1.0);
  const double inside =
      contact::hermite(h, t, values[k], values[k + 1], slope(k), slope(k + 1)).value;
  return inside + (y - (knots[k] + h * t)) * slope(t > 0.5 ? k + 1 : k);
}

}  // namespace

WheelPoints wheel_points(const profiles::ProfileCurve& wheel, double tread_y) {
  WheelPoints result;
  const std::vector<double> at = profiles::dense_parameters(wheel, 0.1, 0.01);
  for (const double parameter : at) result.points.push_back(wheel.at(parameter));
  result.start = static_cast<std::size_t>(
      std::lower_bound(at.begin(), at.end(), wheel.parameter_at(tread_y)) - at.begin());
  return result;
}

Silhouette::Silhouette(const WheelPoints& wheel, double rolling_radius, const Axle& axle)
    : axle_(axle) {
  const AxleFrame frame = axle_frame(axle);
  // From the tread both ways, as far as the outline remains a height over y.
  const auto start = static_cast<std::ptrdiff_t>(wheel.start);
  std::vector<Seen> inner, outer;
  inner.reserve(wheel.start);
  outer.reserve(wheel.points.size() - wheel.start);
  const auto walk = [&](std::ptrdiff_t first, int step, std::vector<Seen>& part) {
    for (std::ptrdiff_t k = first; k >= 0 && k < static_cast<std::ptrdiff_t>(wheel.points.size());
         k += step) {
      const auto point =
          seen(wheel.points[static_cast<std::size_t>(k)], rolling_radius, axle, frame);
      if (!point) return;
      if (!part.empty() && step * (point->place[1] - part.back().place[1]) <= 1e-6) return;
      part.push_back(*point);
    }
  };
  walk(start, 1, outer);
  walk(start - 1, -1, inner);
  std::vector<Seen> all;
  all.reserve(inner.size() + outer.size());
  all.assign(inner.rbegin(), inner.rend());
  for (const Seen& point : outer)
    if (all.empty() || point.place[1] > all.back().place[1] + 1e-6) all.push_back(point);
  if (all.size() < 2)
    throw contact::InputError(
        fmt::format("wheel.profile: no part of it near y = {:.4g} mm is visible along x; allowed: "
                    "a tread there that faces away from the axle; do: check rotation, shift and "
                    "mirror under [wheel_profile]",
                    wheel.points[wheel.start].y));
  std::vector<double> y, z, slope;
  for (auto* list : {&y, &z, &slope, &x_, &profile_y_}) list->reserve(all.size());
  for (const Seen& point : all) {
    y.push_back(point.place[1]);
    z.push_back(point.place[2]);
    slope.push_back(point.slope);
    x_.push_back(point.place[0]);
    profile_y_.push_back(point.profile_y);
  }
  curve_ = contact::HeightCurve(std::move(y), std::move(z), std::move(slope));
}

OutlinePoint Silhouette::at(double y) const {
  OutlinePoint point;
  point.x = value_over_y(curve_.knots(), x_, y);
  point.y = y;
  point.z = curve_.at(y).value;
  point.profile_y = value_over_y(curve_.knots(), profile_y_, y);
  const Vector3 arm{point.x - axle_.point[0], y - axle_.point[1], point.z - axle_.point[2]};
  const Vector3 across = contact::cross(arm, axle_.direction);
  point.radius = std::sqrt(contact::dot(across, across));
  return point;
}

}  // namespace rollfem::track

// SPDX-License-Identifier: LGPL-2.1-or-later
// The locus along which a wheel and a rail that change along their way are closest: at every y the
// least gap over x.
#include "contact/base/errors.hpp"
#include "track/placement/along_way.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rollfem::track {

using contact::Vector3;

namespace {

/// Most and least between the points of the locus, and between the places at which all of x is
/// looked at, mm.
constexpr double locus_step = 0.1, least_step = 0.02, look_step = 1.0;
/// Places closer than this are one, mm.
constexpr double rounding = 1e-6;

/// Over a stretch without points, the wall between two heads, the gap is wide: it opens on one side
/// and closes on the other.
void bridge(std::vector<LocusPoint>& points, const LocusPoint& next) {
  if (points.empty() || next.y - points.back().y < 1.5 * locus_step) return;
  constexpr double wide = 20.0;  // mm
  const LocusPoint last = points.back();
  const double width = next.y - last.y;
  for (const double part : {1.0 / 3.0, 2.0 / 3.0}) {
    LocusPoint point = part < 0.5 ? last : next;
    point.y = last.y + part * width;
    point.rail_z = point.wheel_z + wide;
    point.rail_slope = (part < 0.5 ? 1.0 : -1.0) * wide / width;
    point.wheel_slope = 0.0;
    points.push_back(point);
  }
}

/// The wheel's surface there.
SlopedHeight wheel_at(const contact::PatchGeometry& bodies, double x, double y) {
  const double z = bodies.wheel_height(x, y);
  if (!std::isfinite(z)) return {z};
  const contact::AxlePlace at = bodies.axle_place({x, y, z});
  const contact::RadiusAround radius = bodies.radius_around(at);
  const Vector3& axle = bodies.axle().direction;
  const Vector3 around = contact::cross(at.across, axle);  // the way in which the angle grows
  const auto normal = [&](std::size_t d) {
    return at.across[d] / at.radius - radius.by_axial * axle[d] -
           radius.by_angle * around[d] / (at.radius * at.radius);
  };
  return {z, -normal(0) / normal(2), -normal(1) / normal(2)};
}

}  // namespace

/// The gap over x at one y, level frame.
struct BodiesAlongWay::GapAlong {
  const BodiesAlongWay& along_way;
  const Level& level;
  double y;

  double at(double x) const { return level.bodies.distance(x, y); }
  double slope(double x) const {
    const SlopedHeight wheel = wheel_at(level.bodies, x, y), rail = along_way.rail_at(level, x, y);
    return std::isfinite(wheel.z - rail.z) ? wheel.along - rail.along : contact::infinity;
  }

  /// The lowest place between two x, by the secant method on the slope; it may be where a head
  /// begins or ends. `bend`: about the change of the slope.
  std::optional<double> lowest(double lower, double start, double upper, double bend) const {
    constexpr double close = 1e-8;  // mm
    double x = start, before = start, slope_before = contact::infinity;
    for (int round = 0; round < 60; ++round) {
      const double here = slope(x);
      if (std::isinf(here)) {
        if (std::abs(x - before) < close) break;
        (x < before ? lower : upper) = x;
        x = 0.5 * (x + before);
        continue;
      }
      if (x != before && (here - slope_before) * (x - before) > 0.0)
        bend = (here - slope_before) / (x - before);
      (here > 0.0 ? upper : lower) = before = x;
      slope_before = here;
      const double next = x - here / bend;
      if (std::abs(next - x) < close) return next;
      if (upper - lower < close) return x;
      x = next > lower && next < upper ? next : 0.5 * (lower + upper);
    }
    return std::isinf(slope_before) ? std::nullopt : std::optional(before);
  }

  /// Rows at which the gap is a local minimum among them.
  std::vector<std::size_t> low_rows() const {
    std::vector<double> value;
    for (const double x : level.rows) value.push_back(at(x));
    std::vector<std::size_t> low;
    for (std::size_t k = 1; k + 1 < value.size(); ++k)
      if (std::isfinite(value[k]) && value[k] < value[k - 1] && value[k] <= value[k + 1])
        low.push_back(k);
    return low;
  }

  /// Radius of the circle that opens as much at `wide` to both sides of x.
  double relative_radius(double x, double wide, double most) const {
    const double opening = 0.5 * (at(x - wide) + at(x + wide)) - at(x);
    if (!std::isfinite(opening)) return along_way.rolling_radius_;
    return 2.0 * opening * most > wide * wide + opening * opening
               ? 0.5 * (wide * wide / opening + opening)
               : most;
  }
};

/// The point at y where the gap is least among the lowest places near these rows. `before`: the
/// point beside it, if any.
std::optional<LocusPoint> BodiesAlongWay::point_at(const Level& level, double y,
                                                   const std::vector<std::size_t>& near,
                                                   const LocusPoint* before) const {
  const GapAlong gap{*this, level, y};
  std::optional<double> best;
  for (const std::size_t k : near) {
    const double lower = level.rows[k - 1], upper = level.rows[k + 1];
    const bool beside = before != nullptr && before->x > lower && before->x < upper;
    const auto x = gap.lowest(lower, beside ? before->x : level.rows[k], upper,
                              1.0 / (beside ? before->relative_radius : rolling_radius_));
    if (x && (!best || gap.at(*x) < gap.at(*best))) best = x;
  }
  if (!best) return {};
  const SlopedHeight rail = rail_at(level, *best, y), wheel = wheel_at(level.bodies, *best, y);
  LocusPoint point;
  point.x = *best;
  point.y = level.frame.origin[1] + y;
  point.rail_z = level.frame.origin[2] - rail.z;
  point.wheel_z = level.frame.origin[2] - wheel.z;
  point.along = -rail.along;
  point.rail_slope = -rail.across;
  point.wheel_slope = -wheel.across;
  constexpr double depth = 0.1, most_times = 50.0;
  point.relative_radius = gap.relative_radius(point.x, std::sqrt(2.0 * rolling_radius_ * depth),
                                              most_times * rolling_radius_);
  if (!std::isfinite(point.rail_slope + point.wheel_slope + point.along)) return {};
  return point;
}

namespace {

/// Places between two y, with those at which a section begins another piece, so that the curves
/// through the points are as accurate as the sections.
std::vector<double> places_between(double from, double to, const std::vector<double>& pieces) {
  std::vector<double> places{from};
  const auto go_to = [&](double y) {
    const double start = places.back();
    const int steps = static_cast<int>(std::ceil((y - start) / locus_step));
    for (int k = 1; k <= steps; ++k) places.push_back(start + (y - start) * k / steps);
  };
  for (const double y : pieces)
    if (y > places.back() + least_step && y < to - rounding) go_to(y);
  go_to(to);
  return places;
}

}  // namespace

std::vector<LocusPoint> BodiesAlongWay::locus() const {
  const Level level = this->level();
  const double from = std::max(level.first, level.bodies.wheel().first());
  const double to = std::min(level.last, level.bodies.wheel().last());
  std::vector<LocusPoint> points;
  std::vector<std::size_t> near, ahead;
  double looked = -contact::infinity;
  for (const double y :
       from < to - rounding ? places_between(from, to, level.pieces) : std::vector<double>{}) {
    if (y > looked) {
      near = std::isinf(looked) ? GapAlong{*this, level, y}.low_rows() : ahead;
      looked = std::min(std::max(looked, y) + look_step, to);
      ahead = GapAlong{*this, level, looked}.low_rows();
      for (const std::size_t row : ahead)
        if (std::find(near.begin(), near.end(), row) == near.end()) near.push_back(row);
    }
    if (const auto point = point_at(level, y, near, points.empty() ? nullptr : &points.back())) {
      bridge(points, *point);
      points.push_back(*point);
    }
  }
  if (points.size() < 2)
    throw contact::SolveError("the wheel is not above the rail anywhere near this position");
  return points;
}

}  // namespace rollfem::track

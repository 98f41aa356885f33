// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/patch/ridge.hpp"

#include "base/errors.hpp"
#include "base/pi.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;

namespace {

/// Samples across, mm: patches of wheels on rails are 2 to 40 mm wide.
constexpr double sample_distance = 0.1;
/// Largest slope of the surface relative to the plane of the patch.
constexpr double steepest = 1.0;
/// On the way to a near miss the gap must fall by this fraction of the approach: less is the
/// roughness of a profile.
constexpr double least_fall = 1e-3;
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

namespace {

/// Places along x at which bodies that change along the way are looked at, mm.
constexpr double farthest_along = 40.0, step_along = 1.0;
constexpr int rough_steps = 4;
double x_along(int k) {
  return k * step_along;
}
constexpr int last_along = static_cast<int>(farthest_along / step_along);
/// The ridge is low up to this height above its lowest point, mm: beyond any approach.
constexpr double low_ridge = 0.5;

/// The rough place of the least distance at y, and the curvature of the parabola that is as wide
/// some hundredths of a millimetre above it.
RidgePoint rough_point(const contact::PatchGeometry& patch, double y) {
  RidgePoint point{0.0, infinity, 0.0};
  for (int k = -last_along; k <= last_along; k += rough_steps)
    if (const double here = patch.distance(x_along(k), y); here < point.distance)
      point = {x_along(k), here, 0.0};
  return point;
}

/// The same for bodies that change along the way, where neighbours along x may be lower.
RidgePoint varying_ridge_point(const contact::PatchGeometry& patch, double y) {
  RidgePoint point = rough_point(patch, y);
  for (double step = 0.5 * rough_steps * step_along; step > 1e-3 && std::isfinite(point.distance);
       step *= 0.5)
    for (const double x : {point.x - step, point.x + step})
      if (const double here = patch.distance(x, y); here < point.distance) point = {x, here, 0.0};
  constexpr double wide = 3.0;  // mm, about the half length of a patch
  const double beside =
      0.5 * (patch.distance(point.x - wide, y) + patch.distance(point.x + wide, y));
  // A flat has none, and a box by its curvature would have no end.
  constexpr double least = 1e-5;  // 1/mm
  point.curvature = std::max(least, (beside - point.distance) / (wide * wide));
  if (!std::isfinite(point.curvature)) point.distance = infinity;
  return point;
}

}  // namespace

RidgePoint ridge_point(const contact::PatchGeometry& patch, double y) {
  if (patch.varies()) return varying_ridge_point(patch, y);
  constexpr double step = 0.5;  // mm
  RidgePoint point;
  // A parabola through three points is exact to (step / radius)^2; yaw moves its vertex.
  const int rounds = patch.axle().direction[0] == 0.0 ? 1 : 3;
  for (int round = 0; round < rounds; ++round) {
    const double before = patch.distance(point.x - step, y);
    const double here = patch.distance(point.x, y);
    const double after = patch.distance(point.x + step, y);
    if (!std::isfinite(before + here + after)) return {point.x, infinity, 0.0};
    point.curvature = 0.5 * (before - 2.0 * here + after) / (step * step);
    point.distance = here;
    if (rounds == 1 || !(point.curvature > 0.0)) break;
    const double slope = 0.5 * (after - before) / step;
    const double move = -0.5 * slope / point.curvature;
    point.x += move;
    point.distance = here - point.curvature * move * move;
  }
  return point;
}

Ridge::Ridge(const contact::PatchGeometry& patch) {
  const auto& limits = patch.limits();
  const double lower = std::max({patch.rail().first(), patch.wheel().first(), limits[0]});
  const double upper = std::min({patch.rail().last(), patch.wheel().last(), limits[1]});
  const auto walk = [&](double direction) {
    std::vector<double> y;
    for (int k = direction > 0.0 ? 0 : 1; y.size() < 10000; ++k) {
      const double at = std::clamp(direction * k * sample_distance, lower, upper);
      if (std::abs(patch.rail().at(at).slope) > steepest) break;
      if (!y.empty() && at == y.back()) break;
      y.push_back(at);
    }
    return y;
  };
  y_ = walk(-1.0);
  std::reverse(y_.begin(), y_.end());
  const std::vector<double> up = walk(1.0);
  for (const double at : up)
    if (y_.empty() || at > y_.back()) y_.push_back(at);
  for (const double y : y_) {
    points_.push_back(ridge_point(patch, y));
    angle_.push_back(std::atan(patch.rail().at(y).slope));
  }
  if (!std::isfinite(least_distance()))
    throw contact::SolveError(
        "wheel and rail do not face each other in the plane of this contact: its reference point "
        "is where one of them ends or is steeper than 45 degrees against the plane; allowed: "
        "contacts on surfaces that go on to both sides; do: check the profiles and radii, or move "
        "the wheel");
  if (patch.varies()) look_along(patch);
}

void Ridge::look_along(const contact::PatchGeometry& patch) {
  const double limit = least_distance() + low_ridge;
  along_.resize(y_.size());
  for (std::size_t k = 0; k < y_.size(); ++k) {
    if (!(points_[k].distance < limit)) continue;
    for (int i = -last_along; i <= last_along; ++i)
      along_[k].push_back(patch.distance(x_along(i), y_[k]));
  }
}

double Ridge::least_distance() const {
  double least = infinity;
  for (const RidgePoint& point : points_) least = std::min(least, point.distance);
  return least;
}

Overlap Ridge::overlap(double level) const {
  Overlap found;
  for (std::size_t k = 0; k < y_.size(); ++k) {
    if (!(points_[k].distance < level)) continue;
    RidgeRegion region{y_[k], y_[k], infinity, -infinity, angle_[k], points_[k].distance};
    if (k > 0) region.y_lower = y_[k - 1];
    for (; k < y_.size() && points_[k].distance < level; ++k) {
      const RidgePoint& point = points_[k];
      const double half = std::sqrt((level - point.distance) / std::max(point.curvature, 1e-12));
      region.x_lower = std::min(region.x_lower, point.x - half);
      region.x_upper = std::max(region.x_upper, point.x + half);
      if (k < along_.size())
        for (std::size_t i = 0; i < along_[k].size(); ++i)
          if (along_[k][i] < level) {
            const double x = x_along(static_cast<int>(i) - last_along);
            region.x_lower = std::min(region.x_lower, x - step_along);
            region.x_upper = std::max(region.x_upper, x + step_along);
          }
      region.y_upper = y_[k];
      if (point.distance < region.distance) {
        region.distance = point.distance;
        region.angle = angle_[k];
      }
    }
    if (k < y_.size()) region.y_upper = y_[k];
    Box& box = found.box;
    if (found.regions.empty())
      box = {region.x_lower, region.x_upper, region.y_lower, region.y_upper};
    else
      found.gaps += std::max(0.0, region.y_lower - box.y_upper);
    box.x_lower = std::min(box.x_lower, region.x_lower);
    box.x_upper = std::max(box.x_upper, region.x_upper);
    box.y_upper = region.y_upper;
    found.regions.push_back(region);
  }
  return found;
}

double displacement_beside(double x, double y, const ContactGrid& grid, const Field& pressure,
                           double modulus) {
  double sum = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (const double p = pressure[grid.index(i, j)]; p > 0.0)
        sum += p / std::hypot(x - grid.x(i), y - grid.y(j));
  return sum * grid.element_area() / (contact::pi * modulus);
}

Box with_near_misses(const Box& patch, const Ridge& ridge, double approach, const ContactGrid& grid,
                     const Field& pressure, double modulus) {
  Box box = patch;
  double widest = -infinity;  // gap passed on the way from the patch
  const auto look_at = [&](double y, const RidgePoint& point) {
    const double overlap = approach - point.distance;
    const double gap = overlap > 0.0
                           ? displacement_beside(point.x, y, grid, pressure, modulus) - overlap
                           : -overlap;
    widest = std::max(widest, gap);
    if (!(overlap > 0.0) || gap > widest - least_fall * approach) return;
    // Half the length of Hertz's patch at this approach.
    const double half = std::sqrt(0.5 * overlap / std::max(point.curvature, 1e-12));
    box = {std::min(box.x_lower, point.x - half), std::max(box.x_upper, point.x + half),
           std::min(box.y_lower, y), std::max(box.y_upper, y)};
  };
  const auto& places = ridge.places();
  const auto& points = ridge.points();
  for (std::size_t k = places.size(); k-- > 0;)
    if (places[k] < patch.y_lower) look_at(places[k], points[k]);
  widest = -infinity;
  for (std::size_t k = 0; k < places.size(); ++k)
    if (places[k] > patch.y_upper) look_at(places[k], points[k]);
  return box;
}

}  // namespace rollfem::halfspace

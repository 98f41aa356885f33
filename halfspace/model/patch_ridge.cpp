#include "halfspace/model/patch_ridge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollfem::halfspace {

namespace {

/// Samples across, mm: patches of wheels on rails are 2 to 40 mm wide.
constexpr double sample_distance = 0.1;
/// Steeper than this against the plane of the patch, nothing belongs to it.
constexpr double steepest = 1.0;
/// Patches whose normals differ by more are patches of their own.
constexpr double largest_angle = 0.35;  // rad
/// Regions of overlap that nearly meet are one contact: the gap beside the width of the wider one.
/// Those farther off are scenes of their own (meshes/contact_search), which must not count twice.
constexpr double nearly_meeting = 0.25;

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

RidgePoint ridge_point(const contact::PatchGeometry& patch, double y) {
  constexpr double step = 0.5;  // mm
  RidgePoint point;
  // One parabola through three places is exact to (step / radius)^2; yaw moves its vertex.
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
  const double lower = std::max(patch.rail().first(), patch.wheel().first());
  const double upper = std::min(patch.rail().last(), patch.wheel().last());
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
  foot_ = static_cast<std::size_t>(
      std::min_element(y_.begin(), y_.end(),
                       [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      y_.begin());
  const auto downhill = [&](std::size_t k) {
    return points_[k].distance < points_[foot_].distance;
  };
  for (bool moved = true; moved;) {
    moved = false;
    if (foot_ + 1 < y_.size() && downhill(foot_ + 1)) {
      ++foot_;
      moved = true;
    } else if (foot_ > 0 && downhill(foot_ - 1)) {
      --foot_;
      moved = true;
    }
  }
  // The contact point may lie between two regions of one contact: the deeper one counts.
  constexpr double just_below = 1e-6;  // mm
  const auto joined = contact_regions(points_[foot_].distance + just_below);
  if (joined.empty()) return;
  for (std::size_t k = 0; k < y_.size(); ++k)
    if (y_[k] >= joined.front().y_lower && y_[k] <= joined.back().y_upper && downhill(k)) foot_ = k;
}

std::vector<RidgeRegion> Ridge::regions(double level) const {
  std::vector<RidgeRegion> found;
  for (std::size_t k = 0; k < y_.size(); ++k) {
    if (!(points_[k].distance < level)) continue;
    RidgeRegion region{y_[k], y_[k], infinity, -infinity, angle_[k], points_[k].distance};
    if (k > 0) region.y_lower = y_[k - 1];
    for (; k < y_.size() && points_[k].distance < level; ++k) {
      const RidgePoint& point = points_[k];
      const double half = std::sqrt((level - point.distance) / std::max(point.curvature, 1e-12));
      region.x_lower = std::min(region.x_lower, point.x - half);
      region.x_upper = std::max(region.x_upper, point.x + half);
      region.y_upper = y_[k];
      if (point.distance < region.distance) {
        region.distance = point.distance;
        region.angle = angle_[k];
      }
    }
    if (k < y_.size()) region.y_upper = y_[k];
    found.push_back(region);
  }
  return found;
}

std::vector<RidgeRegion> Ridge::contact_regions(double level) const {
  const std::vector<RidgeRegion> all = regions(level);
  const double y = y_[foot_];
  const auto at = std::find_if(all.begin(), all.end(), [&](const RidgeRegion& region) {
    return region.y_lower <= y && y <= region.y_upper;
  });
  if (at == all.end()) return {};
  const auto joined = [](const RidgeRegion& a, const RidgeRegion& b) {
    const double between = b.y_lower - a.y_upper;
    const double wider = std::max(a.y_upper - a.y_lower, b.y_upper - b.y_lower);
    return between <= nearly_meeting * wider && std::abs(a.angle - b.angle) < largest_angle;
  };
  auto first = at;
  auto last = at;
  while (first != all.begin() && joined(*(first - 1), *first)) --first;
  while (last + 1 != all.end() && joined(*last, *(last + 1))) ++last;
  return {first, last + 1};
}

}  // namespace rollfem::halfspace

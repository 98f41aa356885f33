#include "meshes/gmsh/patch_groups.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::meshes {

namespace {

/// Humps with a valley shallower than this between them are one (mm): roughness of a profile.
constexpr double least_valley = 2e-3;
/// Patches whose distance is less than this part of their widths are one potential contact.
constexpr double near_touch = 0.1;

void join(PatchGroup& group, const PatchGroup& next) {
  if (next.stretch.deepest.gap < group.stretch.deepest.gap) {
    group.stretch.deepest = next.stretch.deepest;
    group.stretch.rolling_radius = next.stretch.rolling_radius;
  }
  group.stretch.limits[1] = next.stretch.limits[1];
  group.minima.insert(group.minima.end(), next.minima.begin(), next.minima.end());
}

std::vector<Stretch> stretches_of(const std::vector<PatchGroup>& groups) {
  std::vector<Stretch> stretches;
  for (const PatchGroup& group : groups) stretches.push_back(group.stretch);
  return stretches;
}

bool are_one(const VerticalGap& gap, const Stretch& a, const Stretch& b, double sinking,
             double merge_angle) {
  if (!(approach_of(a, sinking) > 0.0) || !(approach_of(b, sinking) > 0.0)) return false;
  if (std::abs(a.deepest.angle() - b.deepest.angle()) > merge_angle) return false;
  const auto left = reach_of(gap, a, sinking), right = reach_of(gap, b, sinking);
  const double widths = left[1] - left[0] + right[1] - right[0];
  return right[0] - left[1] < near_touch * widths;
}

}  // namespace

std::vector<PatchGroup> separate_groups(const VerticalGap& gap) {
  std::vector<PatchGroup> groups;
  for (const GapMinimum& minimum : gap.minima()) {
    PatchGroup group;
    group.stretch.deepest = minimum;
    group.stretch.rolling_radius = gap.wheel().at(minimum.y).radius;
    group.stretch.limits = {gap.first(), gap.last()};
    group.minima = {minimum};
    if (!groups.empty()) {
      PatchGroup& last = groups.back();
      const auto ridge = gap.largest_between(last.stretch.deepest.y, minimum.y);
      if (ridge[0] - std::max(last.stretch.deepest.gap, minimum.gap) < least_valley) {
        join(last, group);
        continue;
      }
      last.stretch.limits[1] = group.stretch.limits[0] = ridge[1];
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

std::array<double, 2> reach_of(const VerticalGap& gap, const Stretch& stretch, double sinking) {
  return gap.below(sinking, stretch.deepest.y, stretch.limits[0], stretch.limits[1]);
}

double reference_place(const VerticalGap& gap, const Stretch& stretch, double sinking) {
  if (!(approach_of(stretch, sinking) > 0.0)) return stretch.deepest.y;
  const auto reach = reach_of(gap, stretch, sinking);
  // The overlap of depth d is as long as sqrt(d), which makes d^2.5 along y.
  constexpr int cells = 400;
  const double dy = (reach[1] - reach[0]) / cells;
  double weights = 0.0, moments = 0.0;
  for (int k = 0; k < cells; ++k) {
    const double y = reach[0] + (k + 0.5) * dy;
    const double depth = sinking - gap.at(y).value;
    if (!(depth > 0.0)) continue;
    const double weight = depth * depth * std::sqrt(depth);
    weights += weight;
    moments += weight * y;
  }
  return weights > 0.0 ? moments / weights : stretch.deepest.y;
}

double merge_groups(const VerticalGap& gap, std::vector<PatchGroup>& groups, double merge_angle,
                    const SinkingOf& sinking_of) {
  double sinking = sinking_of(stretches_of(groups));
  for (std::size_t k = 0; k + 1 < groups.size();) {
    if (!are_one(gap, groups[k].stretch, groups[k + 1].stretch, sinking, merge_angle)) {
      ++k;
      continue;
    }
    join(groups[k], groups[k + 1]);
    groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    sinking = sinking_of(stretches_of(groups));
    k = 0;
  }
  return sinking;
}

}  // namespace rollfem::meshes

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/search/patch_groups.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::track {

namespace {

/// Humps separated by a valley shallower than this (mm) are merged: roughness of a profile.
constexpr double least_valley = 2e-3;
/// The estimate of the approach is accurate to about 6 %, less accurate for several patches.
constexpr double beyond_estimate = 1.5;
constexpr double beyond_estimate_at_least = 0.01;  // mm

/// Capacity for the humps of a wheel and a rail, which costs no more than for one.
constexpr std::size_t usual_groups = 8;

void join(Stretch& group, const Stretch& next) {
  group.next_gap =
      std::min({group.next_gap, next.next_gap, std::max(group.deepest.gap, next.deepest.gap)});
  if (next.deepest.gap < group.deepest.gap) {
    group.deepest = next.deepest;
    group.rolling_radius = next.rolling_radius;
  }
  group.limits[1] = next.limits[1];
  group.minima.insert(group.minima.end(), next.minima.begin(), next.minima.end());
}

/// Range of the angles of all minima of two groups, rad.
double angles_of_both(const Stretch& a, const Stretch& b) {
  double least = contact::infinity, largest = -least;
  for (const Stretch* group : {&a, &b})
    for (const GapMinimum& minimum : group->minima) {
      least = std::min(least, minimum.angle());
      largest = std::max(largest, minimum.angle());
    }
  return largest - least;
}

/// Whether one grid may hold both. Bodies that change along the way touch at places with other x,
/// between which there is no common surface: only where no wall stands between them.
bool may_join(const VerticalGap& gap, const Stretch& a, const Stretch& b) {
  constexpr double wall = 0.3;  // mm above the lower one, more than any approach
  return !gap.bodies() || gap.largest_between(a.minima.back().y, b.minima.front().y)[0] <
                              std::min(a.deepest.gap, b.deepest.gap) + wall;
}

/// Merges neighbours with the most similar angles first, until no two are within `merge_angle`.
void join_neighbours(const VerticalGap& gap, std::vector<Stretch>& groups, double merge_angle) {
  while (groups.size() > 1) {
    std::size_t best = 0;
    double least = contact::infinity;
    for (std::size_t k = 0; k + 1 < groups.size(); ++k)
      if (const double range = angles_of_both(groups[k], groups[k + 1]);
          range < least && may_join(gap, groups[k], groups[k + 1]))
        least = range, best = k;
    if (least > merge_angle) return;
    join(groups[best], groups[best + 1]);
    groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(best) + 1);
  }
}

/// The ridge between neighbours separates them; the outer sides of the first and the last have
/// none.
void set_limits(const VerticalGap& gap, std::vector<Stretch>& groups) {
  for (std::size_t k = 0; k < groups.size(); ++k) {
    groups[k].limits[0] = k > 0 ? groups[k - 1].limits[1] : gap.first();
    groups[k].limits[1] =
        k + 1 < groups.size()
            ? gap.largest_between(groups[k].minima.back().y, groups[k + 1].minima.front().y)[1]
            : gap.last();
  }
}

/// A contact that does not touch at this sinking (mm) may do so under the load: the sinking is an
/// estimate.
bool within_reach_of_load(const GapMinimum& minimum, double least_gap, double sinking) {
  const double approach = sinking - least_gap;
  return minimum.gap - least_gap <
         std::max(beyond_estimate * approach, approach + beyond_estimate_at_least);
}

/// Every minimum with the stretch between the adjacent ridges; humps with almost no valley between
/// them are merged.
std::vector<Stretch> separate_groups(const VerticalGap& gap) {
  std::vector<Stretch> groups;
  groups.reserve(usual_groups);
  for (const GapMinimum& minimum : gap.minima()) {
    Stretch group;
    group.deepest = minimum;
    group.rolling_radius = gap.wheel().at(minimum.y).relative_radius;
    group.limits = {gap.first(), gap.last()};
    group.minima = {minimum};
    if (!groups.empty()) {
      Stretch& last = groups.back();
      const auto ridge = gap.largest_between(last.deepest.y, minimum.y);
      if (ridge[0] - std::max(last.deepest.gap, minimum.gap) < least_valley) {
        join(last, group);
        continue;
      }
      last.limits[1] = group.limits[0] = ridge[1];
    }
    groups.push_back(std::move(group));
  }
  for (Stretch& group : groups) group.next_gap = contact::infinity;
  return groups;
}

}  // namespace

Contacts group_minima(const VerticalGap& gap, double merge_angle, const SinkingOf& sinking_of) {
  const std::vector<Stretch> all = separate_groups(gap);
  const double least = deepest_of(all).deepest.gap;
  Contacts contacts{all, sinking_of(all), all};
  // Separate patches are stiffer than together: the sinking grows from round to round, and with it
  // the set of patches that the load may reach.
  std::size_t reached = 0;
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<Stretch> groups;
    groups.reserve(all.size());
    for (const Stretch& group : all)
      if (within_reach_of_load(group.deepest, least, contacts.sinking)) groups.push_back(group);
    if (groups.size() == reached) break;
    reached = groups.size();
    join_neighbours(gap, groups, merge_angle);
    set_limits(gap, groups);
    // A single hump has already been checked.
    const bool known = round == 0 && all.size() == 1;
    contacts.groups = std::move(groups);
    if (!known) contacts.sinking = sinking_of(contacts.groups);
  }
  return contacts;
}

std::array<double, 2> reach_of(const VerticalGap& gap, const Stretch& stretch, double sinking) {
  return gap.span_below(sinking, stretch.deepest.y, stretch.limits[0], stretch.limits[1]);
}

Reference reference_of(const VerticalGap& gap, const Stretch& stretch, double sinking) {
  const Reference lowest{stretch.deepest.y, stretch.deepest.slope};
  if (!(approach_of(stretch, sinking) > 0.0)) return lowest;
  const auto reach = reach_of(gap, stretch, sinking);
  // The length of an overlap of depth d is proportional to sqrt(d), hence d^2.5 along y.
  constexpr int cells = 800;
  const double dy = (reach[1] - reach[0]) / cells;
  double weights = 0.0, places = 0.0, slopes = 0.0, angles = 0.0, squares = 0.0;
  for (int k = 0; k < cells; ++k) {
    const double y = reach[0] + (k + 0.5) * dy;
    const auto [here, slope] = gap.with_surface(y);
    const double depth = sinking - here.value;
    if (!(depth > 0.0)) continue;
    const double weight = depth * depth * std::sqrt(depth);
    weights += weight;
    places += weight * y;
    slopes += weight * slope;
    angles += weight * std::atan(slope);
    squares += weight * std::pow(std::atan(slope), 2);
  }
  if (!(weights > 0.0)) return lowest;
  const double variance = squares / weights - std::pow(angles / weights, 2);
  return {places / weights, slopes / weights, std::sqrt(std::max(0.0, variance))};
}

}  // namespace rollfem::track

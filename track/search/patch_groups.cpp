// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/search/patch_groups.hpp"

#include "base/errors.hpp"
#include "base/pi.hpp"
#include "base/root.hpp"
#include "halfspace/elasticity/influence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace rollfem::track {

namespace {

using contact::pi;

/// Overlap with the extent of the patch, as a fraction of the approach. 0.5 would be exact for a
/// circular patch (Hertz: a^2 = R approach); Kik and Piotrowski use 0.55. With every row on its own
/// normal and the deflection of the whole patch, this value is closest to CONTACT's approaches.
constexpr double overlap_fraction = 0.57;

/// Rows of elements across a stretch at a sinking.
struct Rows {
  static constexpr std::size_t cells = 120;
  std::array<double, cells> place{};     ///< mm along the common surface
  std::array<double, cells> width{};     ///< mm along it
  std::array<double, cells> half{};      ///< mm, half length of the patch; 0: no overlap
  std::array<double, cells> approach{};  ///< mm, of the bodies along the local normal
  double vertical = 0.0;                 ///< integral of pi/2 half^2 over y, mm^3
};

/// `way`: vertical sinking at the deepest point of the stretch, mm. Every row takes its own normal.
Rows rows_of(const VerticalGap& gap, const Stretch& stretch, double way) {
  const double overlap = overlap_fraction * way;
  const double least = stretch.deepest.gap;
  // All humps of the stretch below the limit count, with or without gaps between them, so that no
  // value jumps where they meet.
  const auto [lower, upper] =
      gap.span_below(least + overlap, stretch.deepest.y, stretch.limits[0], stretch.limits[1]);
  const double dy = (upper - lower) / static_cast<double>(Rows::cells);
  Rows rows;
  double place = 0.0;
  for (std::size_t k = 0; k < Rows::cells; ++k) {
    const double y = lower + (static_cast<double>(k) + 0.5) * dy;
    const auto [here, slope] = gap.with_surface(y);
    const double stretched = std::sqrt(1.0 + slope * slope);
    const double depth = std::max(0.0, overlap - (here.value - least));
    const double half_square = 2.0 * stretch.rolling_radius * depth;
    rows.place[k] = place + 0.5 * dy * stretched;
    place += dy * stretched;
    rows.width[k] = dy * stretched;
    rows.half[k] = std::sqrt(half_square);
    rows.approach[k] = (way - (here.value - least)) / stretched;
    rows.vertical += 0.5 * pi * half_square * dy;
  }
  return rows;
}

/// Ratio of approach to deflection under semi-elliptic rows of unit pressure over half length, both
/// averaged over the patch with the eighth power of the overlap as weight. At the deepest point
/// alone the ratio would jump where another hump becomes the deepest.
double approach_per_deflection(const Rows& rows, std::size_t every) {
  double approach = 0.0, deflection = 0.0;
  for (std::size_t j = every / 2; j < rows.place.size(); j += every) {
    const double half = rows.half[j];
    if (!(half > 0.0)) continue;
    const double weight = std::pow(half, 16);
    double sum = 0.0;
    for (std::size_t k = 0; k < rows.place.size(); ++k) {
      if (!(rows.half[k] > 0.0)) continue;
      // A quarter of the width avoids the logarithmic singularity of the row itself.
      const double s = std::max(std::abs(rows.place[k] - rows.place[j]), 0.25 * rows.width[k]);
      sum += rows.half[k] * halfspace::row_deflection(s / rows.half[k]) * rows.width[k];
    }
    approach += weight * rows.approach[j];
    deflection += weight * sum;
  }
  return deflection > 0.0 ? approach / deflection : 0.0;
}

/// Approach that carries the force, and the local exponent of its power law.
struct PowerLaw {
  double approach = 0.05;  ///< mm
  double exponent = 1.5;   ///< Hertz's
};

/// The approach by the secant method between logarithms of approach and force, which are linear for
/// a power law; empty where it does not converge.
template <class Carried>
std::optional<PowerLaw> power_law_root(const Carried& carried, const PowerLaw& start, double least,
                                       double vertical, double tolerance) {
  constexpr int most_steps = 20;
  auto [approach, exponent] = start;
  double last_logarithm = 0.0, last_force = 0.0;
  for (int step = 0; step < most_steps; ++step) {
    const double force = carried(least + approach);
    if (!(force > 0.0)) return {};
    const double logarithm = std::log(approach);
    if (step > 0 && logarithm != last_logarithm)
      exponent = std::log(force / last_force) / (logarithm - last_logarithm);
    if (!(exponent > 0.3 && exponent < 6.0)) return {};
    last_logarithm = logarithm;
    last_force = force;
    const double next = approach * std::pow(vertical / force, 1.0 / exponent);
    if (!std::isfinite(next)) return {};
    if (std::abs(next - approach) <= tolerance) return PowerLaw{next, exponent};
    approach = next;
  }
  return {};
}

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

const Stretch& deepest_of(const std::vector<Stretch>& stretches) {
  return *std::min_element(
      stretches.begin(), stretches.end(),
      [](const Stretch& a, const Stretch& b) { return a.deepest.gap < b.deepest.gap; });
}

double approach_of(const Stretch& stretch, double sinking) {
  return (sinking - stretch.deepest.gap) * stretch.deepest.cosine();
}

double estimate_force(const VerticalGap& gap, const Stretch& stretch, double approach,
                      double modulus, std::size_t every) {
  if (!(approach > 0.0)) return 0.0;
  const double cosine = stretch.deepest.cosine();
  const Rows rows = rows_of(gap, stretch, approach / cosine);
  return pi * modulus * approach_per_deflection(rows, every) * rows.vertical / cosine;
}

double estimate_sinking(const VerticalGap& gap, const std::vector<Stretch>& stretches,
                        double vertical, double modulus) {
  const double least = deepest_of(stretches).deepest.gap;
  const auto carried_by = [&](double sinking, std::size_t every) {
    double sum = 0.0;
    for (const Stretch& stretch : stretches)
      sum += stretch.deepest.cosine() *
             estimate_force(gap, stretch, approach_of(stretch, sinking), modulus, every);
    return sum;
  };
  const auto carried = [&](double sinking) { return carried_by(sinking, every_third_row); };
  const auto roughly = [&](double sinking) { return carried_by(sinking, 15); };
  constexpr double rough = 1e-4, tolerance = 1e-12;  // mm
  const auto start = power_law_root(roughly, {}, least, vertical, rough);
  if (const auto found =
          power_law_root(carried, start.value_or(PowerLaw{}), least, vertical, tolerance))
    return least + found->approach;
  const auto excess = [&](double approach) { return carried(least + approach) - vertical; };
  constexpr double first_step = 0.01, deepest = 1e7;  // mm
  const auto found = contact::root_from(excess, 0.0, -vertical, first_step, deepest, tolerance,
                                        "estimate of the sinking");
  if (!found)
    throw contact::SolveError(fmt::format(
        "no sinking of the wheel carries {:g} N vertically; allowed: loads that the surfaces can "
        "carry; do: check the load, the materials and the units of the profiles",
        vertical));
  return least + *found;
}

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

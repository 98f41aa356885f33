// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/base/errors.hpp"
#include "contact/base/pi.hpp"
#include "contact/base/root.hpp"
#include "halfspace/elasticity/influence.hpp"
#include "track/search/patch_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
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

}  // namespace rollfem::track

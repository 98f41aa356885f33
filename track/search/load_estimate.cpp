// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/search/load_estimate.hpp"

#include "contact/base/pi.hpp"
#include "contact/base/root.hpp"
#include "halfspace/elasticity/row_deflection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace rollfem::track {

namespace {

using contact::pi;
/// Of the approach, overlap that has the extent of the patch. A half would be exact for a circular
/// patch (Hertz: a^2 = R approach); Kik and Piotrowski have 0.55. With every row on its own normal
/// and the deflection of the whole patch this one is nearest to CONTACT's approaches.
constexpr double overlap_fraction = 0.57;

/// Rows of elements across a stretch at a sinking.
struct Rows {
  static constexpr std::size_t cells = 120;
  std::array<double, cells> place{};     ///< mm along the common surface
  std::array<double, cells> width{};     ///< mm along it
  std::array<double, cells> half{};      ///< mm, half length of the patch; 0: nothing overlaps
  std::array<double, cells> approach{};  ///< mm, of the bodies along the local normal
  double vertical = 0.0;                 ///< integral of pi/2 half^2 over y, mm^3
};

/// `way`: vertical, of the deepest place of the stretch, mm. Every row takes its own normal.
Rows rows_of(const VerticalGap& gap, const Stretch& stretch, double way) {
  const double overlap = overlap_fraction * way;
  const double least = stretch.deepest.gap;
  // All humps of the stretch that are below the limit count, valleys between them or not, so that
  // nothing jumps where they meet.
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

/// Approach over deflection under semi-elliptic rows of unit pressure over half length, the mean of
/// both over the patch with the eighth power of the overlap. At the deepest place alone it would
/// jump where another hump becomes the deepest.
double approach_per_deflection(const Rows& rows, std::size_t every) {
  double approach = 0.0, deflection = 0.0;
  for (std::size_t j = every / 2; j < rows.place.size(); j += every) {
    const double half = rows.half[j];
    if (!(half > 0.0)) continue;
    const double weight = std::pow(half, 16);
    double sum = 0.0;
    for (std::size_t k = 0; k < rows.place.size(); ++k) {
      if (!(rows.half[k] > 0.0)) continue;
      // A quarter of the width keeps the row itself off the logarithm.
      const double s = std::max(std::abs(rows.place[k] - rows.place[j]), 0.25 * rows.width[k]);
      sum += rows.half[k] * halfspace::row_deflection(s / rows.half[k]) * rows.width[k];
    }
    approach += weight * rows.approach[j];
    deflection += weight * sum;
  }
  return deflection > 0.0 ? approach / deflection : 0.0;
}

/// Of the rows, those that approach and deflection are the means of: good to 1e-3 of the force
/// where they are few.
constexpr std::size_t every_third = 3, few_rows = 15;

/// Where a power law of approach and force is looked for.
struct PowerLaw {
  double approach = 0.05;  ///< mm
  double exponent = 1.5;   ///< Hertz's
};

/// The approach by the secant method between logarithms of approach and force, which a power law
/// of both makes straight; nothing where that does not converge.
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

double estimate_force(const VerticalGap& gap, const Stretch& stretch, double approach,
                      double modulus, std::size_t every) {
  if (!(approach > 0.0)) return 0.0;
  const double cosine = std::cos(stretch.deepest.angle());
  const Rows rows = rows_of(gap, stretch, approach / cosine);
  return pi * modulus * approach_per_deflection(rows, every) * rows.vertical / cosine;
}

}  // namespace

double approach_of(const Stretch& stretch, double sinking) {
  return (sinking - stretch.deepest.gap) * std::cos(stretch.deepest.angle());
}

double estimate_force(const VerticalGap& gap, const Stretch& stretch, double approach,
                      double modulus) {
  return estimate_force(gap, stretch, approach, modulus, every_third);
}

double estimate_sinking(const VerticalGap& gap, const std::vector<Stretch>& stretches,
                        double vertical, double modulus) {
  double least = std::numeric_limits<double>::infinity();
  for (const Stretch& stretch : stretches) least = std::min(least, stretch.deepest.gap);
  const auto carried_by = [&](double sinking, std::size_t every) {
    double sum = 0.0;
    for (const Stretch& stretch : stretches)
      sum += std::cos(stretch.deepest.angle()) *
             estimate_force(gap, stretch, approach_of(stretch, sinking), modulus, every);
    return sum;
  };
  const auto carried = [&](double sinking) { return carried_by(sinking, every_third); };
  const auto roughly = [&](double sinking) { return carried_by(sinking, few_rows); };
  constexpr double rough = 1e-4, tolerance = 1e-12;  // mm
  const auto start = power_law_root(roughly, {}, least, vertical, rough);
  if (const auto found =
          power_law_root(carried, start.value_or(PowerLaw{}), least, vertical, tolerance))
    return least + found->approach;
  double lower = 0.0, upper = 0.01;
  const auto excess = [&](double approach) { return carried(least + approach) - vertical; };
  for (int step = 0; step < 30 && excess(upper) < 0.0; ++step) {
    lower = upper;
    upper *= 2.0;
  }
  return least +
         contact::bracketed_root(excess, lower, upper, tolerance, "estimate of the sinking");
}

}  // namespace rollfem::track

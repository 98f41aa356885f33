// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces of many creepages on many ellipses: errors against a fine grid, and milliseconds per
// point.
#include "halfspace/closed_forms/kalker.hpp"
#include "halfspace/model/rolling_ellipse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <random>
#include <vector>

namespace {

using namespace rollfem;
using halfspace::EllipseAccuracy;
using halfspace::EllipseForces;
using halfspace::ScaledCreepage;

constexpr double nu = 0.28;

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Creepages whose linear forces are `size` times the bound, in the proportions `way` of xi, eta
/// and phi.
ScaledCreepage creepage_of(double ratio, double size, const std::array<double, 3>& way) {
  const double a = std::sqrt(ratio);
  const auto c = halfspace::kalker_coefficients(a, 1.0 / a, nu);
  return {size * way[0] / c.c11, size * way[1] / c.c22,
          size * way[2] / std::max(std::abs(c.c23), c.c33)};
}

/// Seven creepages on an ellipse from a fifth of the bound to eight times, in random directions;
/// each component is 0 with a probability of 0.3.
std::vector<ScaledCreepage> sample_of(double ratio, std::mt19937& random) {
  std::vector<ScaledCreepage> creepages;
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int k = 0; k < 7; ++k) {
    std::array<double, 3> way{};
    double size = 0.0;
    for (double& x : way) {
      x = 2.0 * uniform() - 1.0;
      if (uniform() < 0.3) x = 0.0;
      size += std::abs(x);
    }
    if (size == 0.0) way[static_cast<std::size_t>(k % 3)] = size = 1.0;
    creepages.push_back(creepage_of(ratio, 0.2 * std::pow(40.0, k / 6.0) / size, way));
  }
  return creepages;
}

/// A part of a table: every combination of eight steps of each creepage, in boustrophedon order, so
/// that neighbours follow each other.
std::vector<ScaledCreepage> table_of(double ratio) {
  std::vector<ScaledCreepage> points;
  const auto step = [](int k) { return 0.05 * (std::pow(1.9, k) - 1.0); };
  constexpr int n = 8;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const int eta = i % 2 == 0 ? j : n - 1 - j;
        const int phi = (i * n + j) % 2 == 0 ? k : n - 1 - k;
        points.push_back(creepage_of(ratio, 1.0, {step(i), step(eta), step(phi)}));
      }
  return points;
}

/// Forces at samples of all ellipses, each creepage from a cold start.
std::vector<EllipseForces> forces_of(const std::vector<double>& ratios,
                                     const EllipseAccuracy& accuracy) {
  std::vector<EllipseForces> all;
  std::mt19937 random(7);
  for (const double ratio : ratios)
    for (const ScaledCreepage& creepage : sample_of(ratio, random))
      all.push_back(halfspace::roll_ellipse({ratio, nu}, {creepage}, accuracy)[0]);
  return all;
}

void compare(const std::vector<double>& ratios, int reference) {
  const double begin = cpu_seconds();
  const std::vector<EllipseForces> all = forces_of(ratios, {});
  const double seconds = cpu_seconds() - begin;
  const std::vector<EllipseForces> fine = forces_of(ratios, {0.0, reference});
  int good = 0, within_bars = 0;
  double worst_force = 0.0, worst_moment = 0.0;
  std::array<int, 3> on_grid{};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto& [limit, bar, across, rise] = all[k];
    const auto& exact = fine[k].limit;
    const double force =
        std::hypot(limit.longitudinal - exact.longitudinal, limit.lateral - exact.lateral);
    const double moment = std::abs(limit.spin_moment - exact.spin_moment);
    worst_force = std::max(worst_force, force);
    worst_moment = std::max(worst_moment, moment);
    if (force <= 0.002 && moment <= 0.01) ++good;
    // Rounding in a vanishing component is not an error.
    if (force <= std::hypot(bar.longitudinal, bar.lateral) + 1e-4 &&
        moment <= std::abs(bar.spin_moment) + 1e-4)
      ++within_bars;
    ++on_grid[across == 20 ? 0 : across == 40 ? 1 : 2];
  }
  fmt::print(
      "{} points, each from a cold start: {:.1f} CPU ms per point; {} within 0.2 % of mu F_n and 1 "
      "% of "
      "mu F_n c (against {} across), largest {:.2f} and {:.2f} %; {} within their bars; on 20, 40, "
      "80 across: {}, {}, {}\n",
      all.size(), 1e3 * seconds / static_cast<double>(all.size()), good, reference,
      100.0 * worst_force, 100.0 * worst_moment, within_bars, on_grid[0], on_grid[1], on_grid[2]);
}

}  // namespace

int main(int count, char** words) {
  const int reference = count > 1 ? std::atoi(words[1]) : 160;
  for (const double ratio : {0.2, 1.0, 5.0}) {
    const std::vector<ScaledCreepage> points = table_of(ratio);
    const double begin = cpu_seconds();
    std::vector<EllipseForces> all;
    for (std::size_t k = 0; k < points.size(); k += 64)  // as in tables
      for (const EllipseForces& one :
           halfspace::roll_ellipse({ratio, nu}, {points.begin() + k, points.begin() + k + 64}))
        all.push_back(one);
    const double seconds = cpu_seconds() - begin;
    const auto finer =
        std::count_if(all.begin(), all.end(), [](const auto& p) { return p.elements_across > 20; });
    fmt::print(
        "table of {} points at a/b = {:g}: {:.1f} CPU ms per point, {} on finer grids than 20\n",
        points.size(), ratio, 1e3 * seconds / static_cast<double>(points.size()), finer);
  }
  compare({0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0}, reference);
  return 0;
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Error bars of tables: random points on random ellipses, solved as in a table, against the limit
// of grids four times finer.
#include "halfspace/closed_forms/kalker.hpp"
#include "halfspace/model/rolling_ellipse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <random>
#include <vector>

namespace {

using namespace rollfem;
using halfspace::EllipseForces;
using halfspace::ScaledCreepage;

/// An ellipse with creepages.
struct Sample {
  halfspace::EllipseShape shape;
  std::vector<ScaledCreepage> creepages;
};

std::vector<EllipseForces> forces_of(const std::vector<Sample>& samples,
                                     const halfspace::EllipseAccuracy& accuracy) {
  std::vector<EllipseForces> all;
  for (const Sample& sample : samples)
    for (const EllipseForces& one :
         halfspace::roll_ellipse(sample.shape, sample.creepages, accuracy))
      all.push_back(one);
  return all;
}

constexpr double nu = 0.28;

/// Creepages as in a table: even up to 1, in equal ratios beyond.
double creepage_at(double t) {
  const double size = std::abs(t);
  return std::copysign(size <= 1.0 ? size : std::exp(size - 1.0), t);
}

struct Off {
  double force, moment, force_left, moment_left;
};

void tell(const char* what, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return 100.0 * values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  fmt::print("{}: 50, 90, 95, 99, 100 of 100 points: {:.3f} {:.3f} {:.3f} {:.3f} {:.3f} %\n", what,
             at(0.5), at(0.9), at(0.95), at(0.99), at(1.0));
}

/// Errors of points solved up to a correction, and how well the correction covers them.
void judge(const std::vector<Sample>& samples, const std::vector<EllipseForces>& exact,
           double largest_correction) {
  const std::clock_t begin = std::clock();
  const std::vector<EllipseForces> found = forces_of(samples, {largest_correction});
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  std::vector<Off> all;
  std::vector<double> force, moment;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto &f = found[k].limit, &e = exact[k].limit, &left = found[k].correction;
    all.push_back({std::hypot(f.longitudinal - e.longitudinal, f.lateral - e.lateral),
                   std::abs(f.spin_moment - e.spin_moment),
                   std::hypot(left.longitudinal, left.lateral), std::abs(left.spin_moment)});
    force.push_back(all.back().force);
    moment.push_back(all.back().moment);
  }
  fmt::print(
      "{} points against the limit of 80 and 160 across, corrections up to {:g} %: {:.1f} CPU "
      "ms a point\n",
      found.size(), 100.0 * largest_correction, 1e3 * seconds / static_cast<double>(found.size()));
  tell("force, over mu F_n", force);
  tell("moment, over mu F_n c", moment);
  for (const double floor : {0.0, 0.001, 0.002, 0.003, 0.004}) {
    const auto held = [&](auto off, auto left) {
      const auto n = std::count_if(
          all.begin(), all.end(), [&](const Off& o) { return o.*off <= std::max(floor, o.*left); });
      return 100.0 * static_cast<double>(n) / static_cast<double>(all.size());
    };
    fmt::print("bars of at least {:.1f} %: force held in {:.1f} of 100, moment in {:.1f}\n",
               100.0 * floor, held(&Off::force, &Off::force_left),
               held(&Off::moment, &Off::moment_left));
  }
}

}  // namespace

int main(int count, char** words) {
  const int shapes_asked = count > 1 ? std::atoi(words[1]) : 40, each = 10;
  std::mt19937 random(count > 2 ? static_cast<unsigned>(std::atoi(words[2])) : 1U);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  std::vector<Sample> samples;
  for (int s = 0; s < shapes_asked; ++s) {
    const double ratio = std::exp(uniform(std::log(0.1), std::log(10.0))), a = std::sqrt(ratio);
    const auto c = halfspace::kalker_coefficients(a, 1.0 / a, nu);
    samples.push_back({{ratio, nu}, {}});
    for (int k = 0; k < each; ++k)
      samples.back().creepages.push_back(
          {creepage_at(uniform(-2.1, 2.1)) * 3.0 / c.c11,
           creepage_at(uniform(-2.1, 2.1)) * 3.0 / c.c22,
           creepage_at(uniform(-2.6, 2.6)) / std::hypot(c.c23, c.c33)});
  }
  const std::vector<EllipseForces> exact = forces_of(samples, {0.0, 160});
  for (const double correction : {0.003, 0.0015, 0.001}) judge(samples, exact, correction);
  return 0;
}

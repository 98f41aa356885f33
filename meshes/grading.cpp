// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meshes/grading.hpp"

#include "base/count.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::meshes {

std::vector<double> outward_steps(double first, double fine, double extent, double growth) {
  const int equal =
      std::max(1, contact::count_of(std::ceil(fine / first - 1e-9),
                                    "cells of a mesh (fem.cell_size, fem.fine_extent)"));
  std::vector<double> steps(equal, first);
  const double rest = extent - equal * first;
  if (rest < 0.5 * first) return steps;
  std::vector<double> growing;
  double sum = 0.0;
  for (double step = first * growth; sum < rest; step *= growth) {
    // A last step that would shrink by half is dropped and the others are stretched.
    if (!growing.empty() && sum + 0.5 * step > rest) break;
    growing.push_back(step);
    sum += step;
  }
  for (const double step : growing) steps.push_back(step * rest / sum);
  return steps;
}

std::vector<double> points_both_ways(const std::vector<double>& outward) {
  std::vector<double> points{0.0};
  for (const double step : outward) points.push_back(points.back() + step);
  std::vector<double> all;
  for (auto it = points.rbegin(); it + 1 != points.rend(); ++it) all.push_back(-*it);
  all.insert(all.end(), points.begin(), points.end());
  return all;
}

}  // namespace rollfem::meshes

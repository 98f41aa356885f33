// SPDX-License-Identifier: LGPL-2.1-or-later
// How often error bars hold and how large they are: random scenes (random_scenes.hpp) solved on a
// grid and on one four times finer.
#pragma once

#include "result/quantities.hpp"

#include "tests/support/half_space_models.hpp"
#include "tests/support/random_scenes.hpp"
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace rollfem::testing {

/// One number of one load point.
struct BarSample {
  double error = 0.0;     ///< |value - fine value|
  double bar = 0.0;       ///< of the value
  double fine_bar = 0.0;  ///< of the fine value
};

/// By name of the quantity.
using BarSamples = std::map<std::string, std::vector<BarSample>>;

inline double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Printed statistics of a quantity.
struct BarRow {
  std::size_t count = 0;
  double covered = 0.0;            ///< part of the numbers
  double bar_over_error = 0.0;     ///< median
  double fine_bar_over_bar = 0.0;  ///< median

  explicit BarRow(const std::vector<BarSample>& samples) : count(samples.size()) {
    std::vector<double> ratios, fine;
    std::size_t holds = 0;
    for (const BarSample& sample : samples) {
      if (sample.error <= sample.bar) ++holds;
      ratios.push_back(sample.bar / sample.error);
      fine.push_back(sample.fine_bar / sample.bar);
    }
    covered = count == 0 ? 1.0 : static_cast<double>(holds) / static_cast<double>(count);
    bar_over_error = median_of(ratios);
    fine_bar_over_bar = median_of(fine);
  }
};

/// Largest stresses and stresses at six points below the surface, of both bodies.
inline contact::Scene with_stresses(contact::Scene scene, const RandomScene& random) {
  scene.output.stress_maxima = true;
  const double smaller = 0.5 * std::min(random.length, random.width);
  for (const bool wheel : {true, false})
    for (const double depth : {0.2, 0.5, 1.0}) {
      contact::SubsurfaceRequest request;
      request.wheel = wheel;
      const double z = depth * smaller;
      request.from = {0.1 * random.length, -0.15 * random.width, wheel ? z : -z};
      scene.subsurface.push_back(request);
    }
  return scene;
}

/// The largest error of the components at all points, which the bar must cover.
inline double stress_error(const contact::PointResult& point, const contact::PointResult& fine) {
  double largest = 0.0;
  for (std::size_t r = 0; r < point.subsurface.size(); ++r)
    for (std::size_t c = 0; c < 6; ++c)
      largest = std::max(
          largest, std::abs(point.subsurface[r].stress[0][c] - fine.subsurface[r].stress[0][c]));
  return largest;
}

inline void add_samples(const contact::PointResult& point, const contact::PointResult& fine,
                        double friction, BarSamples& samples) {
  const auto bar = [](const contact::PointResult& of, const std::string& name) {
    const auto found = of.error_estimate.find(name);
    return found == of.error_estimate.end() ? 0.0 : found->second;
  };
  // Skips rounding errors, as of a given force or one that vanishes by symmetry.
  constexpr double rounding = 1e-6;
  for (const contact::Quantity& quantity : contact::quantities()) {
    if (point.error_estimate.count(quantity.name) == 0) continue;
    const double error = std::abs(*quantity.value(point) - *quantity.value(fine));
    const double whole =
        std::max(contact::whole_of(quantity, point, friction), std::abs(*quantity.value(point)));
    if (error <= rounding * whole) continue;
    samples[quantity.name].push_back({error, bar(point, quantity.name), bar(fine, quantity.name)});
  }
  for (std::size_t m = 0; m < point.stress_maxima.size(); ++m) {
    const std::string name =
        "max_" + point.stress_maxima[m].measure + "_" + point.stress_maxima[m].body;
    if (point.error_estimate.count(name) == 0) continue;
    samples["max_" + point.stress_maxima[m].measure].push_back(
        {std::abs(point.stress_maxima[m].value - fine.stress_maxima[m].value), bar(point, name),
         bar(fine, name)});
  }
  if (!point.subsurface.empty())
    samples["subsurface_stress"].push_back({stress_error(point, fine),
                                            bar(point, "subsurface_stress"),
                                            bar(fine, "subsurface_stress")});
}

/// A scene on square cells of that size, mm, and of a quarter of it; throws what the model throws.
inline void add_on_cells(contact::Scene scene, double cell, BarSamples& samples) {
  const auto run = [&](double size) {
    scene.contact_grid.cell_size = {{size, size}};
    return rollfem::testing::half_space_models().run("halfspace", scene, {});
  };
  const contact::ModelResult coarse = run(cell);
  const contact::ModelResult fine = run(0.25 * cell);
  for (std::size_t k = 0; k < coarse.points.size(); ++k)
    add_samples(coarse.points[k], fine.points[k], scene.friction_coefficient(), samples);
}

/// A random scene on `across` elements and on four times as many; throws what the models throw.
inline void add_scene(const RandomScene& random, int across, bool stresses, BarSamples& samples) {
  const auto run = [&](int elements) {
    const contact::Scene scene = random.across(elements);
    return rollfem::testing::half_space_models().run(
        "halfspace", stresses ? with_stresses(scene, random) : scene, {});
  };
  const contact::ModelResult coarse = run(across);
  const contact::ModelResult fine = run(4 * across);
  for (std::size_t k = 0; k < coarse.points.size(); ++k)
    if (!coarse.points[k].error_estimate.empty())
      add_samples(coarse.points[k], fine.points[k], random.scene.friction_coefficient(), samples);
}

}  // namespace rollfem::testing

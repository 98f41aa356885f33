// SPDX-License-Identifier: LGPL-2.1-or-later
// A lateral sweep of a wheelset: the totals of each wheel's patches at each position.
#pragma once

#include "result/write/output.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::result {

/// Where along its way a wheel is, a number for each position of the case.
struct WayScalar {
  const char *name, *unit, *description;
  std::vector<double> contact::Wheelset::*list;
  double at(const contact::Case& input, int position) const {
    return (input.wheelset.*list).at(static_cast<std::size_t>(position) - 1);
  }
};
/// Those that the case gives, because bodies or friction change along the way.
std::vector<WayScalar> ways_of(const contact::Case& input);

/// A wheel at one position and load point, with the sums over its patches.
struct WheelAt {
  const contact::ModelResult* main = nullptr;  ///< the most loaded patch
  std::size_t point = 0;
  int patches = 0;
  double vertical_force = 0.0;       ///< N
  double longitudinal_force = 0.0;   ///< N, on the wheel
  double lateral_force_track = 0.0;  ///< N, on the wheel along y of the track: to the right
  double area = 0.0;                 ///< mm^2
  double max_pressure = 0.0;         ///< MPa, the largest of its patches
};

/// `main` is null if the model has no such patch. `point` counts from 0.
WheelAt wheel_at(const RunRecord& run, const std::string& model, bool left, int position,
                 std::size_t point);

/// Rolling radius of the right wheel minus that of the left one at the most loaded patches, mm.
std::optional<double> loaded_radius_difference(const WheelAt& left, const WheelAt& right);

/// Names of the models, in the order of the results.
std::vector<std::string> model_names(const RunRecord& run);

/// One line per position for one model at its first load point: radii, conicity, angles, pressures
/// and lateral forces of both wheels. Empty if the run has no lateral sweep.
std::string wheelset_table(const RunRecord& run, const std::string& model);

}  // namespace rollfem::result

// SPDX-License-Identifier: LGPL-2.1-or-later
// What a run over positions says as a whole: the totals of each wheel's patches at each position,
// the wheelset over its lateral shift, and how deep a wheel dips on its way.
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

/// Where a wheel on its way along the track is lowest under its load, and how sharply it turns.
struct WheelDip {
  std::string model, wheel;
  double track_position = 0.0, loaded_height = 0.0, dip_angle = 0.0;

  static constexpr contact::Listed listed = contact::Listed::as_table;
  static constexpr auto members() {
    using contact::member;
    using D = WheelDip;
    return std::tuple(member("model", &D::model), member("wheel", &D::wheel, "", "left or right"),
                      member("track_position", &D::track_position, "mm", "where it is lowest"),
                      member("loaded_height", &D::loaded_height, "mm", "there, down"),
                      member("dip_angle", &D::dip_angle, "rad",
                             "steepest fall before it and steepest rise after it, together"));
  }
};
/// By model and wheel; without a wheel that is lowest at an end of its way.
std::vector<WheelDip> wheel_dips(const RunRecord& run);

/// Rolling radius of the right wheel minus that of the left one at the most loaded patches, mm.
std::optional<double> loaded_radius_difference(const WheelAt& left, const WheelAt& right);

/// Names of the models, in the order of the results.
std::vector<std::string> model_names(const RunRecord& run);

/// One line per position for one model at its first load point: radii, conicity, angles, pressures
/// and lateral forces of both wheels. Empty if the run has no lateral sweep.
std::string wheelset_table(const RunRecord& run, const std::string& model);

}  // namespace rollfem::result

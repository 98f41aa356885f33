// SPDX-License-Identifier: LGPL-2.1-or-later
// The output of `rollfem stress`: stresses at the requested places, the largest stresses, and the
// points of the shakedown map, as tables for spreadsheets, scripts and the screen.
#pragma once

#include "contact/result/result.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::postprocess {

/// Stress and displacement at the places of one request in one body.
struct StressSet {
  std::string name;  ///< point_1, line_1, plane_1, surface_1, depth_centre, depth_most_loaded
  contact::SubsurfaceField field;
  double moved = 0.0;  ///< mm, largest distance by which a place was moved onto the surface
};

/// Stresses of one model at one load point.
struct StressOfModel {
  contact::ModelResult result;  ///< all load points; only their scalars are used
  std::size_t point = 0;
  std::vector<StressSet> sets;
  std::vector<contact::StressMaximum> maxima;
};

struct StressReport {
  std::string source;  ///< results.h5
  std::string title;
  std::optional<double> yield_shear_stress;  ///< k, MPa
  bool point_named = false;  ///< false: the default, the last one, which the table mentions
  std::vector<StressOfModel> models;
};

/// The largest value of every measure in a body, with its place. Ignores places nearer to z = 0
/// than `least_depth`, but not on it; measures below the surface ignore all above `below`. Where
/// all places lie there, the largest shear is that on the surface.
std::vector<contact::StressMaximum> largest_stresses(
    const std::string& body, const std::vector<std::array<double, 3>>& places,
    const std::vector<std::array<double, 6>>& stress, double least_depth = 0.0, double below = 0.0);

/// Force of the tangential tractions over normal force, T/Fz: the abscissa of the shakedown map.
double tangential_coefficient(const contact::PointResult& point);

/// Text of stress.csv: one row per model, set and place; columns as in subsurface.csv.
std::string stress_csv(const StressReport& report);
/// Text of stress.json, which has no rows of stress.csv: largest values of the bodies and of every
/// set with their places, shakedown points and boundaries of the map. Layout: docs/subsurface.md.
std::string stress_json(const StressReport& report);
/// Table for the terminal.
std::string stress_table(const StressReport& report);

}  // namespace rollfem::postprocess

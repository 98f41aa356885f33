// SPDX-License-Identifier: LGPL-2.1-or-later
// A run written to a folder, whole or not at all: summary.json, results.h5, CSV, ParaView files.
// Layout and meaning of every field: docs/results.md.
#pragma once

#include "contact/result/result.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::postprocess {

/// Who made the result, where and when.
struct Provenance {
  std::string version;
  std::string commit;
  std::string host;
  std::string started;  ///< ISO 8601, UTC
  std::string command;
  int processes = 1;
  /// Of comparisons and studies: how figures call the models, by name.
  std::map<std::string, std::string> labels = {};
};

/// Wheel and rail as they stand on the track at one position, for drawings: y to the right and z
/// down, mm.
struct PlacedPair {
  bool left = true;
  int position = 1;
  std::vector<std::array<double, 2>> rail;
  std::vector<std::array<double, 2>> wheel;
};

/// A wheelset that is shifted sideways, as its rigid wheels touch their rails there.
struct RigidWheelset {
  double lateral_shift = 0.0;                      ///< mm, to the right
  double roll = 0.0;                               ///< rad
  double radius_left = 0.0, radius_right = 0.0;    ///< mm, rolling radii
  double angle_left = 0.0, angle_right = 0.0;      ///< rad, contact angles
  double y_wheel_left = 0.0, y_wheel_right = 0.0;  ///< mm, of the wheel's profile
  /// Equivalent conicity at the amplitude of the shift (track/motion/wheelset_motion.hpp), and the
  /// length of the wave in mm.
  std::optional<double> conicity_harmonic = {}, conicity_wave = {}, wave_length = {};
  double radius_difference() const { return radius_right - radius_left; }  ///< mm
};

struct RunRecord {
  contact::Case input;
  Provenance provenance;
  std::vector<contact::ModelResult> models;
  std::vector<PlacedPair> pairs;  ///< with profiles: of every wheel and position
  /// Of every position of a row of lateral shifts, nothing where rigid wheels do not stand on the
  /// rails; empty without such a row.
  std::vector<std::optional<RigidWheelset>> wheelset = {};
  /// From the middle to the largest of these shifts, in small steps.
  std::vector<RigidWheelset> rigid_row = {};
};

/// Writes everything but figures and report. Files are made in a folder beside `directory` and
/// moved in when all are complete; on failure (disk full, no permission) nothing is left behind and
/// contact::InputError says what happened. An earlier result in `directory` is replaced, files that
/// are not of rollfem's making stay. A number that is not finite throws std::logic_error.
void write_results(const std::string& directory, const RunRecord& run);

/// Runs the plotting program on what rollfem has written: a result folder, or that of a comparison,
/// a study or a table; stress.json; the table NAME.csv of a profile or a wheelset, whose figure is
/// NAME.svg. Returns one line on failure, empty on success; a longer text of the program goes to
/// report.log in the folder; results stay whatever happens here. `script_directory` is the Python
/// package rollfem_figures or the folder that holds it. Python is that of the environment variable
/// ROLLFEM_PYTHON, of the virtual environment that holds the package, /usr/bin/python3, or python3
/// on PATH, whichever comes first; it takes no module from the current folder.
std::string make_report(const std::string& path, const std::string& script_directory);

}  // namespace rollfem::postprocess

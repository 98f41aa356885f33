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

/// A position of a wheelset that is shifted sideways, as rigid bodies touch there.
struct WheelsetGeometry {
  double radius_difference = 0.0;  ///< mm, right less left rolling radius
  /// Equivalent conicity at the amplitude of the shift (meshes/track/conicity.hpp).
  std::optional<double> conicity_harmonic, conicity_wave;
};

struct RunRecord {
  contact::Case input;
  Provenance provenance;
  std::vector<contact::ModelResult> models;
  std::vector<PlacedPair> pairs;  ///< with profiles: of every wheel and position
  /// Of every position, where both wheels are computed at several; else empty.
  std::vector<WheelsetGeometry> wheelset = {};
};

/// Throws contact::InputError when write_results could not write to `directory`: a file, a folder
/// that holds other things than an earlier result, no permission. Leaves nothing behind; call it
/// before the models run.
void check_directory(const std::string& directory);

/// Writes everything but figures and report. Files are made in a folder beside `directory` and
/// moved in when all are complete; on failure (disk full, no permission) nothing is left behind and
/// contact::InputError says what happened. An earlier result in `directory` is replaced, files that
/// are not of rollfem's making stay. A number that is not finite throws std::logic_error.
void write_results(const std::string& directory, const RunRecord& run);

/// Runs the plotting program on a written folder: figures/*.svg and report.html. Returns one
/// line on failure, empty on success; a longer text of the program goes to report.log in the
/// folder; results stay whatever happens here. `script_directory` is the Python package
/// rollfem_figures or the folder that holds it. Python is that of the environment variable
/// ROLLFEM_PYTHON, else /usr/bin/python3, else python3 on PATH; it takes no module from the current
/// folder.
std::string make_report(const std::string& directory, const std::string& script_directory);

/// Draws the table of a profile (app/profile.hpp) as a figure beside it, NAME.csv as NAME.svg;
/// `pair`: the table of a wheel on its rail (app/scenes.hpp). Otherwise as make_report.
std::string draw_profile(const std::string& csv_file, const std::string& script_directory,
                         bool pair = false);

/// Draws the table of `rollfem wheelset` as a figure beside it; otherwise as make_report.
std::string draw_wheelset(const std::string& csv_file, const std::string& script_directory);

/// Draws what `rollfem stress` wrote to a folder (stress.csv, stress.json) to its figures/;
/// otherwise as make_report.
std::string draw_stress(const std::string& directory, const std::string& script_directory);

}  // namespace rollfem::postprocess

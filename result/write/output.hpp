// SPDX-License-Identifier: LGPL-2.1-or-later
// A run written to a folder, completely or not at all: summary.json, results.h5, CSV, ParaView
// files. Layout and meaning of every field: docs/results.md.
#pragma once

#include "result/result.hpp"
#include "result/rigid_wheelset.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::result {

/// Program, version, machine and time of a result.
struct Provenance {
  std::string version, commit, host, started, command;
  int processes = 1;
  /// Labels of the models in figures, by name, for comparisons and studies.
  std::map<std::string, std::string> labels = {};

  static constexpr auto members() {
    using contact::member, contact::member_within;
    using P = Provenance;
    return std::tuple(member("version", &P::version), member("commit", &P::commit),
                      member("host", &P::host), member("started", &P::started, "", "ISO 8601, UTC"),
                      member("command", &P::command), member("processes", &P::processes, "-"),
                      member_within("labels", &P::labels));
  }
};

/// Wheel and rail in position on the track, for drawings.
struct PlacedPair {
  bool left = true;
  int position = 1;
  std::vector<std::array<double, 2>> rail, wheel;
  std::string side() const { return contact::side_word(left); }
  std::string key() const { return side() + '_' + std::to_string(position); }

  static constexpr contact::Listed listed = contact::Listed::by_first;
  static constexpr auto members() {
    using contact::member, contact::member_within;
    using P = PlacedPair;
    return std::tuple(member("key", &P::key), member_within("left", &P::left),
                      member("wheel", &P::side), member("position", &P::position, "-"),
                      member("rail", &P::rail, "mm", "y to the right, z down"),
                      member("wheel", &P::wheel, "mm", "y to the right, z down"));
  }
};

using contact::RigidWheelset;

/// A model without a result for a case, and why.
struct MissingModel {
  std::string model, reason;
  bool failed = false;  ///< it tried; else it cannot take the case
};

struct RunRecord {
  contact::Case input;
  Provenance provenance;
  std::vector<contact::ModelResult> models;
  /// One sentence on results that miss the accuracy and what would help; otherwise empty.
  std::string verdict = {};
  std::vector<PlacedPair> pairs;  ///< with profiles: for every wheel and position
  /// One entry for every position of a lateral sweep, without value if the rigid wheels do not
  /// stand on the rails; empty without a sweep.
  std::vector<std::optional<RigidWheelset>> wheelset = {};
  /// Shifts from the middle to the largest of the sweep, in small steps.
  std::vector<RigidWheelset> rigid_row = {};
};

/// Text of summary.json: scalars, error estimates and times. The record must pass check_record.
std::string summary_json(const RunRecord& run);

/// Incremented when names or meanings in results.h5 change; readers of an earlier version must
/// refuse the file.
inline constexpr int hdf5_format_version = 3;
/// Incremented when something is added; readers of the version may ignore it.
inline constexpr int hdf5_format_minor = 5;

/// The bytes of results.h5: grid, fields per load point, scalars and provenance, self-describing
/// (units, signs and descriptions are attributes and comments). The file is created in memory, so
/// that HDF5 cannot fail half-way on a full disk and the bytes are written like those of other
/// files. The record must have passed check_record.
std::string results_hdf5(const RunRecord& run);

/// Writes everything except figures and report. Files are written to a folder beside `directory`
/// and moved in when all are complete; on failure (disk full, no permission) nothing is left behind
/// and contact::InputError states the reason. An earlier result in `directory` is replaced; foreign
/// files stay. A number that is not finite throws std::logic_error.
void write_results(const std::string& directory, const RunRecord& run);

}  // namespace rollfem::result

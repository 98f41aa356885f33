// SPDX-License-Identifier: LGPL-2.1-or-later
// Reads results.h5 back into the record of a run, for commands on stored results (rollfem stress).
// Layout: docs/results.md.
#pragma once

#include "contact/result/result.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rollfem::postprocess {

/// A model of a stored result, without its fields.
struct StoredModel {
  std::string key;   ///< its group: "halfspace", with profiles "halfspace_left_3_1"
  std::string name;  ///< "halfspace"
  std::optional<contact::ContactPlace> place;  ///< with profiles
  int points = 0;
  std::vector<std::size_t> points_with_bodies;  ///< load points, from 0, that store wheel and rail
};

class ResultsFile {
 public:
  /// Opens a result folder or its results.h5. Throws contact::InputError with file and advice if it
  /// is missing, not from rollfem, of another format version, truncated or damaged (detected by the
  /// checksum before HDF5 opens it).
  explicit ResultsFile(const std::string& path);

  const std::string& path() const { return path_; }
  /// The case, without what its keys name in lists of words and what its files hold.
  const contact::Case& input() const { return input_; }
  /// Models in the order of the run.
  const std::vector<StoredModel>& models() const { return models_; }

  /// The record of a model: grid, load points with scalars, fields, error estimates and stress
  /// maxima, nodes and cells of the bodies. Empty: values of the bodies, subsurface.
  contact::ModelResult read(const StoredModel& model) const;
  /// Adds displacement and stress of the bodies at one of `model.points_with_bodies`.
  void read_bodies(const StoredModel& model, std::size_t point, contact::ModelResult& result) const;

 private:
  std::string path_;
  contact::Case input_;
  std::vector<StoredModel> models_;
};

}  // namespace rollfem::postprocess

// SPDX-License-Identifier: LGPL-2.1-or-later
// Reads results.h5 back into the record it was written from, for commands that continue from
// stored results (rollfem stress). Layout: docs/results.md.
#pragma once

#include "contact/result/result.hpp"

#include <string>
#include <vector>

namespace rollfem::postprocess {

/// A model of a stored result, without its fields.
struct StoredModel {
  std::string key;      ///< its group: "halfspace", with profiles "halfspace_left_3_1"
  std::string name;     ///< "halfspace"
  bool placed = false;  ///< with profiles; then:
  bool left = true;
  int position = 1;
  int patch = 1;
  int points = 0;
  std::vector<std::size_t> points_with_bodies;  ///< load points, from 0, with wheel and rail
};

class ResultsFile {
 public:
  /// A result folder or its results.h5. Throws contact::InputError that names the file and says
  /// what to do: none there, not of rollfem, of another format version, cut short, damaged
  /// (told by its checksum, before HDF5 opens it).
  explicit ResultsFile(const std::string& path);

  const std::string& path() const { return path_; }
  /// False: of an earlier version, without a checksum, so that damage may go unnoticed.
  bool sealed() const { return sealed_; }
  /// Folder that holds the file.
  std::string directory() const;
  /// Title, file, text, friction coefficient, radii and materials of the case; nothing else of it.
  const contact::Case& input() const { return input_; }
  /// In the order of the run.
  const std::vector<StoredModel>& models() const { return models_; }

  /// The record of a model: grid, load points with scalars, fields, error estimates and stress
  /// maxima, nodes and cells of the bodies. Left empty: values of the bodies, subsurface, seconds;
  /// of the place all but what StoredModel has.
  contact::ModelResult read(const StoredModel& model) const;
  /// Adds displacement and stress of the bodies at one of `model.points_with_bodies`.
  void read_bodies(const StoredModel& model, std::size_t point, contact::ModelResult& result) const;

 private:
  std::string path_;
  bool sealed_ = false;
  contact::Case input_;
  std::vector<StoredModel> models_;
};

}  // namespace rollfem::postprocess

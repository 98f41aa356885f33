// Reads results.h5 back: what results_hdf5.cpp wrote, as the record it was written from. For
// commands that go on from stored results (rollfem stress). Layout: docs/results.md.
#pragma once

#include "contact/result.hpp"

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
  bool bodies = false;  ///< nodes and stress of wheel and rail are stored
};

class ResultsFile {
 public:
  /// A result folder or its results.h5. Throws contact::InputError that names the file and says
  /// what to do: none there, not of rollfem, of another format version, cut short, damaged.
  explicit ResultsFile(const std::string& path);

  const std::string& path() const { return path_; }
  /// Folder that holds the file.
  std::string directory() const;
  /// Title, file, text, friction coefficient, radii and materials of the case; nothing else of it.
  const contact::Case& input() const { return input_; }
  /// In the order of the run.
  const std::vector<StoredModel>& models() const { return models_; }

  /// The record of a model: grid, load points with scalars, fields, error estimates and stress
  /// maxima, bodies. Left empty: subsurface, seconds; of the place all but what StoredModel has.
  contact::ModelResult read(const StoredModel& model) const;

 private:
  std::string path_;
  contact::Case input_;
  std::vector<StoredModel> models_;
};

}  // namespace rollfem::postprocess

// A run written to a folder, whole or not at all: summary.json, results.h5, CSV, ParaView files.
// Layout and meaning of every field: docs/results.md.
#pragma once

#include <string>
#include <vector>

#include "contact/result.hpp"

namespace rollfem::postprocess {

/// Who made the result, where and when.
struct Provenance {
  std::string version;
  std::string commit;
  std::string host;
  std::string started;  ///< ISO 8601, UTC
  std::string command;
  int processes = 1;
};

struct RunRecord {
  contact::Case input;
  Provenance provenance;
  std::vector<contact::ModelResult> models;
};

/// Writes everything but figures and report. Files are made in a folder beside `directory` and
/// moved in when all are complete; on failure (disk full, no permission) nothing is left behind and
/// contact::InputError says what happened.
void write_results(const std::string& directory, const RunRecord& run);

/// Runs the plotting program on a written folder: figures/*.svg and report.html. Returns what it
/// printed on failure, empty on success; results stay whatever happens here.
std::string make_report(const std::string& directory, const std::string& script_directory);

}  // namespace rollfem::postprocess

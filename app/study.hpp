// The command `study`: one case on ever finer grids, cells, degrees or domains; of a case with
// profiles every patch, whose loads and creepages are found once and held.
#pragma once

#include <string>
#include <vector>

namespace rollfem::app {

struct StudyRequest {
  std::string case_file;
  std::vector<std::string> models;  ///< empty: halfspace; "all": every model that can take it
  std::vector<std::string> vary;    ///< grid, cell, degree, domain; empty: as the model has it
  bool together = false;            ///< refine all of `vary` at once, not one at a time
  int levels = 0;                   ///< 0: 5 grids, 3 cells or domains
  /// exact, finest, extrapolated, QUANTITY=VALUE, with several patches PLACE.QUANTITY=VALUE
  std::vector<std::string> references;
  std::string directory;  ///< empty: results/<case>_study
  bool quiet = false;
  bool resume = false;  ///< take up the levels of a study that did not end
  bool report = true;
  std::string command;
  int argc = 0;
  char** argv = nullptr;
};

/// Writes DIR/study.json, .csv and .html; with profiles every patch has its series. Throws
/// contact::InputError before anything is computed, contact::SolveError at the end when a level
/// failed.
void study(const StudyRequest& request);

}  // namespace rollfem::app

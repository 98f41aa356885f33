// The command `compare`: several models on one or several cases, laid beside each other.
#pragma once

#include <string>
#include <vector>

namespace rollfem::app {

struct CompareRequest {
  std::vector<std::string> case_files;
  std::vector<std::string> models;  ///< empty: hertz, fastsim, strip, halfspace, fem
  std::string reference;            ///< model; empty: halfspace, else fem, else the first
  std::string directory;            ///< empty: results/compare_<case>, results/compare for several
  bool quiet = false;
  bool resume = false;  ///< keep the cases that are done and take up one that is not
  bool report = true;
  std::string command;
  int argc = 0;
  char** argv = nullptr;
};

/// Every case in DIR/<case> as `run` leaves it, then DIR/compare.json, .csv and .html. A model that
/// cannot take a case is left out with a sentence; one that fails does not stop the others. Throws
/// contact::InputError before anything is computed, contact::SolveError at the end when a model
/// failed.
void compare(const CompareRequest& request);

}  // namespace rollfem::app

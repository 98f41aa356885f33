// The command `run`: the models of a case one after the other, then results and report.
#pragma once

#include <string>
#include <vector>

namespace rollfem::app {

struct RunRequest {
  std::string case_file;
  std::vector<std::string> models;  ///< empty: those of the case file
  std::string directory;            ///< empty: results/<case file without .toml>
  bool quiet = false;
  bool resume = false;  ///< take up the load points of a run that did not end
  bool report = true;   ///< draw figures and report.html, which takes some seconds
  std::string command;  ///< the whole call, for provenance
  int argc = 0;         ///< of main, for MPI
  char** argv = nullptr;
};

/// Names of the models that can be asked for.
std::vector<std::string> known_models();

/// Throws contact::InputError or contact::SolveError; nothing is written then.
void run(const RunRequest& request);

}  // namespace rollfem::app

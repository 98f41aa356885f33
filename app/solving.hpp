// What the commands that compute share: the models of a case on all its scenes, MPI for as long as
// they run, where finished load points are kept, and results written whole.
#pragma once

#include "app/fem_library.hpp"
#include "contact/base/progress.hpp"
#include "contact/case/case.hpp"
#include "contact/result/result.hpp"
#include "postprocess/write/checkpoint_folder.hpp"
#include "postprocess/write/output.hpp"

#include <memory>
#include <string>
#include <vector>

namespace rollfem::app {

/// MPI for as long as the models run.
class FemSession {
 public:
  /// `asked_by`: what asked for the model, for the message of a build without it.
  FemSession(const std::string& asked_by, int argc, char** argv);
  ~FemSession();
  FemSession(const FemSession&) = delete;
  FemSession& operator=(const FemSession&) = delete;

  const fem::Entry& entry() const { return entry_; }

 private:
  const fem::Entry& entry_;
};

/// A model that has no result for a case, and why in one sentence.
struct Missing {
  std::string model;
  std::string reason;
  bool failed = false;  ///< it tried; else the case is none that it can take
};

struct Solved {
  std::vector<contact::ModelResult> results;
  std::vector<postprocess::PlacedPair> pairs;
  std::vector<Missing> missing;  ///< with Solving::go_on
};

struct Solving {
  const FemSession* session = nullptr;  ///< for the model fem
  contact::Progress progress;
  contact::Checkpoint* checkpoint = nullptr;  ///< may be null
  bool first = true;  ///< the first process of a parallel run: it alone runs what is not parallel
  bool together = true;  ///< this is the only process
  /// A model that cannot take the case, or fails, is listed and the others go on; otherwise what it
  /// throws ends the call.
  bool go_on = false;
};

/// Runs the models of `input.models` on every scene of the case. Throws contact::InputError and
/// contact::SolveError, which name model and patch. A failure of one of several processes is
/// thrown whatever `go_on` says: the others may be inside a collective call.
Solved solve(const contact::Case& input, const Solving& how);

/// One model on one scene, or on a case with radii: what `solve` does for each. With the model fem
/// every process calls it, the others on the first alone. Throws as `solve` does.
contact::ModelResult solve_scene(const std::string& model, const contact::Case& scene,
                                 const std::vector<std::string>& notes, const Solving& how);

/// Where finished load points of a result in `directory` are kept; says what is there already.
std::unique_ptr<postprocess::CheckpointFolder> open_checkpoint(const std::string& directory,
                                                               const contact::Case& input,
                                                               bool resume, bool quiet);

/// Of results that are computed now by `processes`.
postprocess::Provenance provenance_of(const std::string& command, int processes);

/// Writes a result folder; Ctrl-C waits until it is whole.
void write_whole(const std::string& directory, const postprocess::RunRecord& record);

/// Draws figures and page of a written folder; a warning says why when it is false.
bool report_drawn(const std::string& directory);

/// results/<name of the case file>, unless the user names another.
std::string result_directory(const std::string& case_file, const std::string& named);

}  // namespace rollfem::app

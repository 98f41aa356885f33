// SPDX-License-Identifier: LGPL-2.1-or-later
// The frame of the computing commands: which processes take part, MPI while models run, progress
// and quiet, what is kept for --resume, and what happens to all of these on failure.
#pragma once

#include "app/frame/progress_display.hpp"
#include "contact/base/share.hpp"
#include "contact/solve/model.hpp"
#include "models/fem/fem_library.hpp"
#include "models/solving/solving.hpp"
#include "postprocess/files/checkpoint_folder.hpp"
#include "postprocess/files/folder_owner.hpp"
#include "postprocess/write/output.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rollfem::app {

/// What run, compare and study are asked alike.
struct ComputingRequest {
  std::vector<std::string> models;   ///< as named by the call; empty: the command's own
  std::vector<std::string> changes;  ///< of keys, by --set
  std::string directory;             ///< empty: a folder of results/
  bool quiet = false;
  bool resume = false;   ///< take up what a call that did not end has finished
  contact::Share share;  ///< --part: what of the work is done; it is kept, and no result written
  int merge = 0;         ///< --merge: so many parts are put together
  bool report = true;    ///< draw figures and page, which takes some seconds
  std::string command;   ///< the whole call, for provenance
  int argc = 0;          ///< of main, for MPI
  char** argv = nullptr;
};

class CommandFrame {
 public:
  /// `models`: those that will run.
  CommandFrame(const ComputingRequest& request, const contact::ModelRegistry& known,
               std::vector<std::string> models);
  CommandFrame(const CommandFrame&) = delete;
  CommandFrame& operator=(const CommandFrame&) = delete;
  ~CommandFrame();

  /// The process that checks, writes and speaks.
  bool first() const { return first_; }
  /// Another process of a run without parallel models.
  bool idle() const { return !first_ && !parallel_; }
  const contact::Progress& progress() const { return progress_; }
  /// A line on stderr, from the first process unless quiet.
  void say(const std::string& line);
  /// Before other output: takes an unfinished line of progress away.
  void clear_line() { display_.clear(); }
  /// Of what is computed now.
  postprocess::Provenance provenance() const;

  /// Nobody else makes this result until the command ends. Throws contact::InputError when somebody
  /// does. Nothing on other processes than the first.
  void own(const std::filesystem::path& directory);
  /// Where finished work of a result in `directory` is kept; says what is there already. nullptr on
  /// other processes than the first.
  postprocess::CheckpointFolder* keep_in(const std::filesystem::path& directory,
                                         const contact::Case& input);
  /// This call does a part of the work, which is done and kept now, and writes no result.
  bool ends_part();
  /// All is written: what was kept goes.
  void forget_kept();

  /// Calls `body` with MPI started where a model needs it. When it throws, `kept` ("load points")
  /// are told of, and the session is left as it is: finalising MPI would wait for processes that
  /// may not have failed. `asked_by`: what named the models.
  void compute(const std::string& asked_by, const std::string& kept,
               const std::function<void(const modelling::Solving&)>& body);

 private:
  void take_up_parts(const std::filesystem::path& directory, const contact::Case& input);
  std::string program() const;
  void tell_of_kept(const std::string& kept) const;
  void prepare_farewell() const;

  const ComputingRequest& request_;
  const contact::ModelRegistry& known_;
  std::vector<std::string> models_;
  bool first_ = true;
  bool parallel_ = false;
  int processes_ = 1;
  ProgressDisplay display_;
  contact::Progress progress_;
  std::unique_ptr<modelling::ParallelSession> session_;
  std::vector<std::unique_ptr<postprocess::FolderOwner>> owned_;
  std::unique_ptr<postprocess::CheckpointFolder> kept_;
};

/// Writes a result folder; Ctrl-C waits until it is whole.
void store_results(const std::string& directory, const postprocess::RunRecord& record);

/// Throws contact::InputError when another of run, compare and study has written to `directory`;
/// `own` is the file that this one would write.
void refuse_other_result(const std::filesystem::path& directory, const std::string& own);

/// Warnings about values of the case that look like slips of units, also with -q.
void warn_of_doubts(const contact::Case& input);

/// Draws figures and page of a written folder; a warning says why when it is false.
bool report_drawn(const std::string& directory);

}  // namespace rollfem::app

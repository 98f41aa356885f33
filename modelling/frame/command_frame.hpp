// SPDX-License-Identifier: LGPL-2.1-or-later
// The frame of the computing commands: participating processes, MPI while models run, progress and
// quiet, work stored for --resume, and the handling of failures.
#pragma once

#include "contact/solve/run_part.hpp"
#include "modelling/fem/fem_library.hpp"
#include "modelling/frame/progress_display.hpp"
#include "modelling/solving/solving.hpp"
#include "result/files/checkpoint_folder.hpp"
#include "result/files/result_folder.hpp"
#include "result/write/output.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rollfem::modelling {

/// What a command that computes was asked for.
struct Computing {
  const contact::ModelRegistry& known;
  std::string command;  ///< the whole call, for provenance
  bool quiet = false;
  bool resume = false;     ///< continue an interrupted run
  contact::RunPart own{};  ///< --part: part of the work to do and store, without a result
  int merge = 0;           ///< --merge: number of parts to put together
};

class CommandFrame {
 public:
  /// `models`: the models that will run.
  CommandFrame(const Computing& request, std::vector<std::string> models);
  CommandFrame(const CommandFrame&) = delete;
  CommandFrame& operator=(const CommandFrame&) = delete;
  ~CommandFrame();

  /// Whether this is the process that checks, writes and prints.
  bool first() const { return first_; }
  /// Whether this process has nothing to do: not the first one of a run without parallel models.
  bool idle() const { return !first_ && !parallel_; }
  const contact::Progress& progress() const { return progress_; }
  /// Prints a line on stderr, from the first process unless quiet.
  void say(const std::string& line);
  /// Erases an unfinished progress line, before other output.
  void clear_line() { display_.clear(); }
  /// Provenance of the current computation.
  result::Provenance provenance() const;

  /// Locks the result folder until the command ends. Throws contact::InputError if another process
  /// holds it. Does nothing on processes other than the first.
  void own(const std::filesystem::path& directory);
  /// The store of finished work for a result in `directory`; reports existing contents. nullptr on
  /// processes other than the first.
  result::CheckpointFolder* keep_in(const std::filesystem::path& directory,
                                    const contact::Case& input);
  /// Whether this call only does a part of the work; marks that part as done.
  bool ends_part();
  /// Deletes the stored work after the result is written.
  void forget_kept();

  /// Calls `body`, with MPI started if a model needs it. If it throws, this reports the stored work
  /// (`kept`: "load points"). `asked_by`: the option or key that names the models.
  void compute(const std::string& asked_by, const std::string& kept,
               const std::function<void(const Solving&)>& body);

 private:
  void merge_parts(const std::filesystem::path& directory, const contact::Case& input);
  std::string program() const;
  void print_kept(const std::string& kept) const;
  void set_interrupt_message() const;

  const Computing& request_;
  std::vector<std::string> models_;
  bool first_ = true;
  bool parallel_ = false;
  int processes_ = 1;
  ProgressDisplay display_;
  contact::Progress progress_;
  std::vector<std::unique_ptr<result::FolderOwner>> owned_;
  std::unique_ptr<result::CheckpointFolder> kept_;
};

/// Writes a result folder; delays Ctrl-C until it is complete.
void store_results(const std::string& directory, const result::RunRecord& record);

/// Throws contact::InputError if another one of run, compare and study has written to `directory`;
/// `own` is this command's own file.
void refuse_other_result(const std::filesystem::path& directory, const std::string& own);

}  // namespace rollfem::modelling

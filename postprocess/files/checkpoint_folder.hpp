// SPDX-License-Identifier: LGPL-2.1-or-later
// Finished load points on disk, in DIR.unfinished beside the future results. Every record appears
// whole or not at all; the folder is removed when the results are written.
#pragma once

#include "contact/base/checkpoint.hpp"
#include "contact/case/case.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace rollfem::postprocess {

class CheckpointFolder : public contact::Checkpoint {
 public:
  /// Records found are given out only with `resume`; otherwise an earlier folder is set aside when
  /// the first new record is kept. `program`: version and commit, which records are bound to, as
  /// they are to the case. `warn` gets at most one line when records cannot be written (the run
  /// goes on without). Nobody else may be at work on the result (FolderOwner). Throws
  /// contact::InputError when the folder holds other things, and with `resume` when it is of
  /// another case or program.
  CheckpointFolder(const std::string& result_directory, const contact::Case& input,
                   const std::string& program, bool resume,
                   std::function<void(const std::string&)> warn);
  CheckpointFolder(const CheckpointFolder&) = delete;
  CheckpointFolder& operator=(const CheckpointFolder&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  /// Where the records of an earlier run are that this one does not take up, until it is done.
  std::filesystem::path set_aside() const;
  /// Records of an earlier run that are there, taken up or not.
  int found() const { return found_; }
  /// Calls `told` whenever one more record is on the disk; how many those are.
  void tell(std::function<void()> told) { told_ = std::move(told); }
  int kept() const { return written_ + (resume_ ? found_ : 0); }
  /// Whether a later run finds something.
  bool holds_records() const;
  /// Records that another call has left are found here as well, and go with these.
  void take_up_also(std::unique_ptr<CheckpointFolder> other);
  /// Keeps an empty record of that name and all that is held back.
  void mark(const std::string& name);
  /// Whether the folder of a result holds a record of that name, whatever it is of.
  static bool is_marked(const std::string& result_directory, const std::string& name);
  /// Records whose names begin so are needed no more.
  void drop(const std::string& begin);
  /// The results are written: the folder goes.
  void remove();

  std::optional<std::string> find(const std::string& name) override;
  /// Work of the first half second is held back: runs that are over by then leave the disk alone.
  void keep(const std::string& name, const std::string& record) override;

 private:
  void look_at(const contact::Case& input);
  void begin();
  void write(const std::string& name, const std::string& record);

  std::filesystem::path folder_;
  std::vector<std::unique_ptr<CheckpointFolder>> others_;
  std::string about_;  ///< what the folder is bound to, as text
  bool resume_ = false;
  std::function<void(const std::string&)> warn_;
  int found_ = 0;
  int written_ = 0;  ///< records of this run
  std::function<void()> told_;
  bool begun_ = false;   ///< the folder is ours
  bool failed_ = false;  ///< nothing more is written
  std::vector<std::pair<std::string, std::string>> held_back_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Removes the records beside a result that stands: a kill came when it was written and they had
/// not gone yet.
void remove_records(const std::string& result_directory);

}  // namespace rollfem::postprocess

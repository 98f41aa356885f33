// SPDX-License-Identifier: LGPL-2.1-or-later
// Finished load points on disk, in DIR.unfinished beside the future results. Every record appears
// completely or not at all; the folder is removed after the results are written.
#pragma once

#include "base/checkpoint.hpp"
#include "case/case.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace rollfem::result {

/// Checksum of the text of a case and of all files that it reads: what was computed under another
/// one is stale.
std::string checksum_of_case(const contact::Case& input);

class CheckpointFolder : public contact::Checkpoint {
 public:
  /// Existing records are used only with `resume`; otherwise an earlier folder is set aside when
  /// the first new record is stored. Records are bound to the case and to `program` (version and
  /// commit). `warn` receives at most one line if records cannot be written (the run continues
  /// without them). The caller must own the result (FolderOwner). Throws contact::InputError if the
  /// folder holds other files, and with `resume` if it belongs to another case or program.
  CheckpointFolder(const std::string& result_directory, const contact::Case& input,
                   const std::string& program, bool resume,
                   std::function<void(const std::string&)> warn);
  CheckpointFolder(const CheckpointFolder&) = delete;
  CheckpointFolder& operator=(const CheckpointFolder&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  /// Folder of an earlier run's records that this run does not use; kept until it is done.
  std::filesystem::path set_aside() const;
  /// Number of existing records of an earlier run, used or not.
  int found() const { return found_; }
  /// Calls `stored` whenever another record is on the disk.
  void when_stored(std::function<void()> stored) { stored_ = std::move(stored); }
  int kept() const { return written_ + (resume_ ? found_ : 0); }
  /// Whether this run has solved or found nothing.
  bool untouched() const { return kept() == 0 && held_back_.empty(); }
  /// Whether a later run will find records.
  bool holds_records() const;
  /// Also finds the records of another call's folder, and removes them together with its own.
  void also_find_in(std::unique_ptr<CheckpointFolder> other);
  /// Stores an empty record of that name and all pending records. Returns false if the disk does
  /// not take them all.
  bool mark(const std::string& name);
  /// Whether the folder of a result holds a record of that name, whatever case it belongs to.
  static bool is_marked(const std::string& result_directory, const std::string& name);
  /// Deletes records whose names begin with `begin`.
  void drop(const std::string& begin);
  /// Removes the folder after the results are written.
  void remove();

  std::optional<std::string> find(const std::string& name) override;
  void refuse(const std::string& name) override;
  /// Stores a record. Work of the first half second stays in memory, so that short runs do not
  /// touch the disk.
  void keep(const std::string& name, const std::string& record) override;

 private:
  void look_at(const contact::Case& input);
  std::filesystem::path file_of(const std::string& name) const;
  bool has(const std::string& name) const;
  std::string place_of(const std::string& name) const;
  void begin();
  void write(const std::string& name, const std::string& record);

  std::mutex mutex_;  ///< of keep() and drop(): load points are solved side by side
  std::filesystem::path folder_;
  std::vector<std::unique_ptr<CheckpointFolder>> others_;
  std::string about_;  ///< program and case that the folder is bound to, as text
  bool resume_ = false;
  std::function<void(const std::string&)> warn_;
  int found_ = 0;
  int written_ = 0;  ///< number of records written by this run
  std::function<void()> stored_;
  bool begun_ = false;   ///< the folder is ours
  bool failed_ = false;  ///< writing has stopped after an error
  std::vector<std::pair<std::string, std::string>> held_back_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Removes leftover records beside a complete result, after a kill between writing it and removing
/// them.
void remove_records(const std::string& result_directory);

}  // namespace rollfem::result

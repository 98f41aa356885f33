// SPDX-License-Identifier: LGPL-2.1-or-later
// A result folder that appears completely or not at all: files are written to a folder beside it,
// flushed to disk and moved in together. An earlier result stays intact until then.
#pragma once

#include "result/files/files_together.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rollfem::result {

class ResultFolder {
 public:
  /// Creates DIR.partial-PID and removes those of killed processes. Throws contact::InputError if
  /// `directory` cannot hold a result: a file, a folder with other files, the current folder, or
  /// not writable.
  explicit ResultFolder(const std::string& directory);
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;
  /// Removes everything created unless it was committed.
  ~ResultFolder();

  /// Writes one file, `name` relative to the folder. Throws contact::InputError (disk full, ...).
  void write(const std::string& name, std::string_view content);

  /// Moves the files in. Foreign files in an earlier result stay in the folder.
  void commit();

 private:
  std::filesystem::path target_;
  MadeFolders parents_;
  std::filesystem::path partial_;
  int lock_ = -1;  ///< file descriptor; shows other runs that this one is alive
  bool committed_ = false;
};

/// Throws contact::InputError if no result could be written to `directory`: a file, a folder with
/// files other than an earlier result, no permission. Leaves nothing behind; call it before the
/// models run.
void check_directory(const std::string& directory);

/// The folder as an absolute path without links and trailing slash. Throws contact::InputError if
/// it has no name or cannot be resolved.
std::filesystem::path resolved_folder(const std::string& directory);

/// Name of this machine; "unknown" without one.
std::string host_name();
/// The time now: UTC, ISO 8601.
std::string utc_now();

/// Ensures that only one process at a time produces a result: it owns the folder from before the
/// first solution until everything is written.
class FolderOwner {
 public:
  /// Takes DIR.lock beside the folder, for `command` (shown to others). The lock belongs to the
  /// operating system and ends with its process in any case; the file left by a killed process is
  /// reused. Throws contact::InputError with process, host, start and command of another owner, or
  /// if the file cannot be created.
  FolderOwner(const std::string& directory, const std::string& command);
  FolderOwner(const FolderOwner&) = delete;
  FolderOwner& operator=(const FolderOwner&) = delete;
  ~FolderOwner();

  /// Removed with the owner: the file, then folders created for it, if empty.
  std::vector<std::filesystem::path> made() const;

 private:
  bool lock();

  std::filesystem::path file_;
  MadeFolders parents_;
  int lock_ = -1;
};

}  // namespace rollfem::result

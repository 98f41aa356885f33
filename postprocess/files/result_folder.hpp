// SPDX-License-Identifier: LGPL-2.1-or-later
// A result folder that appears whole or not at all: files are written to a folder beside it,
// flushed to disk and moved in together. An earlier result stays intact until then.
#pragma once

#include "postprocess/files/files_together.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace rollfem::postprocess {

class ResultFolder {
 public:
  /// Makes DIR.partial-PID and removes those of processes that were killed. Throws
  /// contact::InputError when `directory` is not a place for a result: a file, a folder with other
  /// things in it, the current folder, not writable.
  explicit ResultFolder(const std::string& directory);
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;
  /// Removes all that was made unless it was committed.
  ~ResultFolder();

  /// Writes one file, `name` relative to the folder. Throws contact::InputError (disk full, ...).
  void write(const std::string& name, std::string_view content);

  /// Moves the files in. Files that someone else put into an earlier result stay in the folder.
  void commit();

 private:
  std::filesystem::path target_;
  MadeFolders parents_;
  std::filesystem::path partial_;
  int lock_ = -1;  ///< file descriptor, tells other runs that this one is alive
  bool committed_ = false;
};

/// Throws contact::InputError when no result could be written to `directory`: a file, a folder
/// that holds other things than an earlier result, no permission. Leaves nothing behind; call it
/// before the models run.
void check_directory(const std::string& directory);

/// The folder as an absolute path without links and trailing slash. Throws contact::InputError when
/// it has no name or cannot be looked for.
std::filesystem::path resolved_folder(const std::string& directory);

}  // namespace rollfem::postprocess

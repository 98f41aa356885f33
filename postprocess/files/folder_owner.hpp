// SPDX-License-Identifier: LGPL-2.1-or-later
// Ensures that only one process at a time produces a result: it owns the folder from before the
// first solution until everything is written.
#pragma once

#include "postprocess/files/files_together.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rollfem::postprocess {

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

}  // namespace rollfem::postprocess

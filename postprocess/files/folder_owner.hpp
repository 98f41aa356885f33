// SPDX-License-Identifier: LGPL-2.1-or-later
// Ensures that only one process at a time produces a result: it owns the folder from
// before the first model runs until everything is written.
#pragma once

#include "postprocess/files/files_together.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rollfem::postprocess {

class FolderOwner {
 public:
  /// Takes DIR.lock beside the folder, for `command` (shown to others). The lock is that of the
  /// operating system and ends with its process, however that ends; a file that a killed process
  /// left is taken over. Throws contact::InputError that names process, host, start and command of
  /// the owner when there is one, or when the file cannot be made.
  FolderOwner(const std::string& directory, const std::string& command);
  FolderOwner(const FolderOwner&) = delete;
  FolderOwner& operator=(const FolderOwner&) = delete;
  ~FolderOwner();

  /// What goes with the owner: the file, then folders that were made for it, if they are empty.
  std::vector<std::filesystem::path> made() const;

 private:
  bool lock();

  std::filesystem::path file_;
  MadeFolders parents_;
  int lock_ = -1;
};

}  // namespace rollfem::postprocess

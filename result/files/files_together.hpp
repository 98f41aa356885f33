// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that appear completely or not at all, in a folder that may hold other files: first written
// and flushed under temporary names, then renamed.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace rollfem::result {

/// Creates a folder with missing parents.
class MadeFolders {
 public:
  /// Throws contact::InputError if the folder cannot be created; then none of them remains.
  explicit MadeFolders(const std::filesystem::path& folder);
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;
  /// Removes the created folders that are empty, unless they are kept.
  ~MadeFolders();
  void keep() { made_.clear(); }
  /// Innermost first.
  const std::vector<std::filesystem::path>& list() const { return made_; }

 private:
  std::vector<std::filesystem::path> made_;
};

class FilesTogether {
 public:
  /// Creates the folder if it is missing. Throws contact::InputError if that fails.
  explicit FilesTogether(const std::filesystem::path& folder);
  FilesTogether(const FilesTogether&) = delete;
  FilesTogether& operator=(const FilesTogether&) = delete;
  /// Removes everything created unless it was committed.
  ~FilesTogether();

  /// Throws contact::InputError (disk full, ...).
  void write(const std::string& name, std::string_view content);
  void commit();

 private:
  std::filesystem::path part_of(const std::string& name) const;

  std::filesystem::path folder_;
  MadeFolders made_;
  std::vector<std::string> names_;  ///< written, not yet renamed
};

/// Writes files in this way; contents by name.
void write_together(const std::filesystem::path& folder,
                    const std::map<std::string, std::string>& contents);
/// Replaces a single file in this way.
void replace_file(const std::filesystem::path& path, std::string_view content);

/// Writes and flushes one new file. Throws contact::InputError with file and reason; then nothing
/// remains of it.
void write_file(const std::filesystem::path& path, std::string_view content);

/// Flushes changed names in a folder to the disk. Best effort: some file systems do not support it.
void flush_folder(const std::filesystem::path& folder);

/// "cannot create the folder results/a: No space left on device; nothing was written; do: ...".
/// Throws contact::InputError.
[[noreturn]] void fail_to(const std::string& doing, const std::filesystem::path& path, int error);

/// Content of a file; empty if it cannot be read or is not a regular file.
std::string contents_of(const std::filesystem::path& file);

/// The entries of a folder as they are now; none, and the error, if it cannot be read.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                            std::error_code& error);
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder);

}  // namespace rollfem::result

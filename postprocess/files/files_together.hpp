// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that appear whole or not at all, in a folder that may hold other files: written and flushed
// under other names first, then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rollfem::postprocess {

/// A folder with its parents, made where they were missing.
class MadeFolders {
 public:
  /// Throws contact::InputError when it cannot be made; then none of them is left.
  explicit MadeFolders(const std::filesystem::path& folder);
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;
  /// Removes those that were made, as far as they are empty, unless they are kept.
  ~MadeFolders();
  void keep() { made_.clear(); }
  /// Innermost first.
  const std::vector<std::filesystem::path>& list() const { return made_; }

 private:
  std::vector<std::filesystem::path> made_;
};

class FilesTogether {
 public:
  /// Makes the folder where it is missing. Throws contact::InputError when it cannot be made.
  explicit FilesTogether(const std::filesystem::path& folder);
  FilesTogether(const FilesTogether&) = delete;
  FilesTogether& operator=(const FilesTogether&) = delete;
  /// Removes all that was made unless it was committed.
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

/// One such file.
void replace_file(const std::filesystem::path& path, std::string_view content);

/// Writes and flushes one new file. Throws contact::InputError naming file and reason; then nothing
/// is left of it.
void write_file(const std::filesystem::path& path, std::string_view content);

/// Puts what has happened to the names in a folder on the disk. Best effort: some file systems
/// cannot.
void flush_folder(const std::filesystem::path& folder);

/// "cannot make the folder results/a: No space left on device; nothing was written; do: ...".
/// Throws contact::InputError.
[[noreturn]] void fail_to(const std::string& doing, const std::filesystem::path& path, int error);

/// The whole file; empty where it cannot be read.
std::string contents_of(const std::filesystem::path& file);

}  // namespace rollfem::postprocess

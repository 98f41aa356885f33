// Writes several files all or none, into a folder that may hold other files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rollfem::app {

/// Written under other names first, then renamed. Other files of the folder are left alone.
class FilesTogether {
 public:
  /// Makes the folder where it is missing. `command` begins the messages. Throws
  /// contact::InputError when it cannot be made.
  FilesTogether(std::string command, std::filesystem::path folder);
  FilesTogether(const FilesTogether&) = delete;
  FilesTogether& operator=(const FilesTogether&) = delete;
  /// Removes all that was made unless it was committed.
  ~FilesTogether();

  /// Throws contact::InputError (disk full, ...).
  void write(const std::string& name, std::string_view content);
  void commit();

 private:
  void remove_made();

  std::string command_;
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> made_;  ///< folders that were not there, innermost first
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> files_;
  bool done_ = false;
};

}  // namespace rollfem::app

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/files/files_together.hpp"

#include "base/errors.hpp"
#include "base/text_fields.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace rollfem::result {
namespace {

/// Makes a write beyond the limit of file size fail with EFBIG instead of ending the program; other
/// threads keep their signals.
class HoldFileSizeSignal {
 public:
  HoldFileSizeSignal() {
    sigemptyset(&signal_);
    sigaddset(&signal_, SIGXFSZ);
    pthread_sigmask(SIG_BLOCK, &signal_, &before_);
  }
  ~HoldFileSizeSignal() {
    const timespec at_once{};
    sigtimedwait(&signal_, nullptr, &at_once);  // removes the one that is pending
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  HoldFileSizeSignal(const HoldFileSizeSignal&) = delete;
  HoldFileSizeSignal& operator=(const HoldFileSizeSignal&) = delete;

 private:
  sigset_t signal_{}, before_{};
};

/// Returns 0 or the error number.
int write_all(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(file) == 0 ? 0 : errno;
}

}  // namespace

void fail_to(const std::string& doing, const fs::path& path, int error) {
  const bool full = error == ENOSPC || error == EDQUOT, large = error == EFBIG;
  const std::string text = fmt::format("cannot {} {}: {}; nothing was written; do: {}", doing,
                                       path.string(), std::strerror(error),
                                       full    ? "free some space or choose another disk with -o"
                                       : large ? "raise the limit of file size (ulimit -f)"
                                               : "choose another folder with -o");
  if (full || large || error == EIO) throw contact::OutputError(text);
  throw contact::FileError(text);
}

void write_file(const fs::path& path, std::string_view content) {
  const HoldFileSizeSignal guard;
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) fail_to("write", path, errno);
  int error = write_all(file, content);
  if (::close(file) != 0 && error == 0) error = errno;
  if (error == 0) return;
  ::unlink(path.c_str());
  fail_to("write", path, error);
}

void flush_folder(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
}

MadeFolders::MadeFolders(const fs::path& folder) {
  std::error_code error;
  for (fs::path p = fs::absolute(folder).lexically_normal();
       !fs::exists(p, error) && p.has_relative_path(); p = p.parent_path())
    made_.push_back(p);
  fs::create_directories(folder, error);
  if (!error && fs::is_directory(folder, error)) return;
  const int reason = error ? error.value() : ENOTDIR;
  for (const fs::path& p : made_) fs::remove(p, error);
  fail_to("create the folder", folder, reason);
}

MadeFolders::~MadeFolders() {
  std::error_code ignored;
  for (const fs::path& p : made_) fs::remove(p, ignored);
}

FilesTogether::FilesTogether(const fs::path& folder)
    : folder_(folder.empty() ? "." : folder), made_(folder_) {}

FilesTogether::~FilesTogether() {
  std::error_code ignored;
  for (const std::string& name : names_) fs::remove(part_of(name), ignored);
}

/// A unique name, because two threads or processes may write the same file.
fs::path FilesTogether::part_of(const std::string& name) const {
  return folder_ / fmt::format("{}.{}.part", name, ::gettid());
}

void FilesTogether::write(const std::string& name, std::string_view content) {
  ::unlink(part_of(name).c_str());
  write_file(part_of(name), content);
  names_.push_back(name);
}

void FilesTogether::commit() {
  for (const std::string& name : names_)
    if (::rename(part_of(name).c_str(), (folder_ / name).c_str()) != 0)
      fail_to("write", folder_ / name, errno);
  flush_folder(folder_);
  names_.clear();
  made_.keep();
}

void write_together(const fs::path& folder, const std::map<std::string, std::string>& contents) {
  FilesTogether files(folder);
  for (const auto& [name, content] : contents) files.write(name, content);
  files.commit();
}

void replace_file(const fs::path& path, std::string_view content) {
  FilesTogether files(path.parent_path());
  files.write(path.filename().string(), content);
  files.commit();
}

std::string contents_of(const fs::path& file) {
  constexpr std::size_t largest_file = 20'000'000'000;
  try {
    return contact::text_of_file(file.string(), file.string(), largest_file);
  } catch (const contact::FileError&) {
    return {};
  }
}

std::vector<fs::path> files_in(const fs::path& folder, std::error_code& error) {
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    files.push_back(entry->path());
  return files;
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::error_code ignored;
  return files_in(folder, ignored);
}

}  // namespace rollfem::result

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/base/errors.hpp"
#include "postprocess/files/result_folder.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace fs = std::filesystem;

namespace rollfem::postprocess {
namespace {

const std::string owner_head = "rollfem is writing the result beside this file.\n";

std::string owner_text(const std::string& command) {
  char host[256] = {};
  if (::gethostname(host, sizeof host - 1) != 0) std::strcpy(host, "unknown");
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  char start[32];
  std::strftime(start, sizeof start, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return fmt::format("{}process {} on {}, started {}: {}\n", owner_head, ::getpid(), host, start,
                     command);
}

/// The owner's description of itself; empty if not yet written.
std::string owner_of(const fs::path& file) {
  for (int attempt = 0; attempt < 10; ++attempt) {
    const std::string text = contents_of(file);
    if (text.size() > owner_head.size() && text.back() == '\n')
      return text.substr(owner_head.size(), text.size() - owner_head.size() - 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return "an unknown process";
}

}  // namespace

/// Returns false if the locked file no longer has this name, because its owner has removed it in
/// the meantime.
bool FolderOwner::lock() {
  lock_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (lock_ < 0) fail_to("write", file_, errno);
  // On a file system without locks, EWOULDBLOCK never occurs and no process is refused.
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(lock_);
    lock_ = -1;
    throw contact::InputError(fmt::format(
        "another run is writing this result: {}; do: wait for it, or name another folder with -o",
        owner_of(file_)));
  }
  struct stat here {
  }, there{};
  if (::fstat(lock_, &here) == 0 && ::stat(file_.c_str(), &there) == 0 &&
      here.st_ino == there.st_ino && here.st_dev == there.st_dev)
    return true;
  ::close(lock_);
  lock_ = -1;
  return false;
}

FolderOwner::FolderOwner(const std::string& directory, const std::string& command)
    : file_(resolved_folder(directory).string() + ".lock"), parents_(file_.parent_path()) {
  try {
    while (!lock()) continue;
    const std::string before = contents_of(file_), text = owner_text(command);
    if (!before.empty() && before.rfind(owner_head, 0) != 0)
      throw contact::InputError(
          fmt::format("{} is in the way: rollfem needs this name for its lock, but did not write "
                      "the file; do: move it, or name another folder with -o",
                      file_.string()));
    if (::ftruncate(lock_, 0) != 0 ||
        ::write(lock_, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
      // Other processes are still refused, but without the owner's name.
    }
  } catch (...) {
    if (lock_ >= 0) ::close(lock_);
    throw;
  }
}

std::vector<fs::path> FolderOwner::made() const {
  std::vector<fs::path> all{file_};
  all.insert(all.end(), parents_.list().begin(), parents_.list().end());
  return all;
}

FolderOwner::~FolderOwner() {
  ::unlink(file_.c_str());  // while it is locked, so that waiting processes notice
  ::close(lock_);
}

}  // namespace rollfem::postprocess

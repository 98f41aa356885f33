// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/files/result_folder.hpp"

#include "base/errors.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <set>
#include <stdexcept>
#include <sys/file.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace fs = std::filesystem;

namespace rollfem::result {
namespace {

using contact::FileError;

bool is_result_folder(const fs::path& folder) {
  const auto summary = nlohmann::json::parse(contents_of(folder / "summary.json"), nullptr, false);
  return summary.is_object() && summary.contains("format") && summary.contains("models");
}

}  // namespace

fs::path resolved_folder(const std::string& directory) {
  if (directory.empty()) throw FileError("the output folder has an empty name; give one with -o");
  std::error_code error;
  fs::path path = fs::weakly_canonical(fs::absolute(directory), error);
  if (error) fail_to("find", directory, error.value());
  if (!path.has_filename()) path = path.parent_path();
  return path;
}

namespace {

void check_target(const fs::path& target) {
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (status.type() == fs::file_type::not_found) return;
  if (error) fail_to("look at", target, error.value());
  if (!fs::is_directory(status))
    throw FileError(fmt::format(
        "{} is a file, not a folder; do: give the result another name with -o", target.string()));
  const bool root = !target.has_relative_path();
  if (root || fs::equivalent(target, fs::current_path(error), error))
    throw FileError(
        fmt::format("{} is the {} folder, and a result replaces its folder as a whole; do: give a "
                    "folder below it with -o",
                    target.string(), root ? "root" : "current"));
  const bool empty = fs::is_empty(target, error);
  if (error) fail_to("read", target, error.value());
  if (!empty && !is_result_folder(target))
    throw FileError(
        fmt::format("{} holds files that are not an earlier result of rollfem (no matching "
                    "summary.json) and would be lost; do: choose a new or empty folder with -o",
                    target.string()));
}

fs::path checked_target(const std::string& directory) {
  const fs::path target = resolved_folder(directory);
  check_target(target);
  return target;
}

/// Whether rollfem writes a file of this name, relative to the folder: it then belongs to one
/// result. ResultFolder::write accepts no other names, so that none is missing here.
bool is_of_result(const fs::path& name) {
  static const std::set<std::string> files{
      "summary.json",   "results.h5",   "creep_curve.csv",    "contacts.csv", "patches.csv",
      "path_x.csv",     "path_y.csv",   "case.toml",          "report.html",  "report.log",
      "subsurface.csv", "wheelset.csv", "wheelset_rigid.csv", "pass_work.csv"};
  static const std::set<std::string> in_fields{".vtu", ".vtp", ".pvd"};
  if (name.parent_path() == "fields") return in_fields.count(name.extension().string()) > 0;
  if (name.parent_path() == "figures") return name.extension() == ".svg";
  return name.parent_path().empty() && files.count(name.string()) > 0;
}

/// Moves foreign files from an earlier result to the new one, one folder at a time.
void carry_over(const fs::path& old_folder, const fs::path& new_folder, const fs::path& below,
                bool& all_saved) {
  std::error_code error;
  const std::vector<fs::path> files = files_in(old_folder / below, error);
  if (error) all_saved = false;
  for (const fs::path& old : files) {
    const fs::path name = below / old.filename();
    const bool folder = fs::is_directory(fs::symlink_status(old, error));
    if (folder && (name == "fields" || name == "figures")) {
      carry_over(old_folder, new_folder, name, all_saved);
    } else if (!is_of_result(name) && !fs::exists(new_folder / name, error)) {
      fs::create_directories((new_folder / name).parent_path(), error);
      fs::rename(old, new_folder / name, error);
      if (error) all_saved = false;
    }
  }
}

/// Removes the remains of runs killed while writing this result: DIR.partial-PID of dead processes.
/// Each run locks its own folder, which also shows live processes on other machines if the file
/// system shares locks.
void remove_stale_partials(const fs::path& target) {
  const std::string prefix = target.filename().string() + ".partial-";
  std::error_code error;
  for (const fs::path& folder : files_in(target.parent_path())) {
    const std::string name = folder.filename().string();
    if (name.compare(0, prefix.size(), prefix) != 0 || !fs::is_directory(folder, error)) continue;
    char* rest = nullptr;
    const long process = std::strtol(name.c_str() + prefix.size(), &rest, 10);
    if (process <= 0 || (*rest != '\0' && *rest != '-')) continue;
    if (::kill(static_cast<pid_t>(process), 0) == 0 || errno != ESRCH) continue;
    const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) continue;
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) fs::remove_all(folder, error);
    ::close(file);
  }
}

const std::string owner_head = "rollfem is writing the result beside this file.\n";

std::string owner_text(const std::string& command) {
  return fmt::format("{}process {} on {}, started {}: {}\n", owner_head, ::getpid(), host_name(),
                     utc_now(), command);
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

[[noreturn]] void refuse_lock(const fs::path& file) {
  throw contact::InputError(
      fmt::format("{} is in the way: rollfem needs this name for its lock, but did not write "
                  "the file; do: move it, or name another folder with -o",
                  file.string()));
}

}  // namespace

std::string host_name() {
  char name[256] = {};
  return ::gethostname(name, sizeof name - 1) == 0 ? name : "unknown";
}

std::string utc_now() {
  return fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr)));
}

ResultFolder::ResultFolder(const std::string& directory)
    : target_(checked_target(directory)), parents_(target_.parent_path()) {
  remove_stale_partials(target_);
  const std::string stem = fmt::format("{}.partial-{}", target_.string(), ::getpid());
  for (int attempt = 0; attempt < 100; ++attempt) {
    partial_ = attempt == 0 ? stem : fmt::format("{}-{}", stem, attempt);
    if (::mkdir(partial_.c_str(), 0777) == 0) {
      lock_ = ::open(partial_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (lock_ >= 0) ::flock(lock_, LOCK_EX | LOCK_NB);
      return;
    }
    if (errno != EEXIST) break;
  }
  fail_to("create the folder", partial_, errno);
}

ResultFolder::~ResultFolder() {
  if (lock_ >= 0) ::close(lock_);
  if (committed_) return;
  std::error_code error;
  fs::remove_all(partial_, error);
}

void ResultFolder::write(const std::string& name, std::string_view content) {
  if (!is_of_result(name))
    throw std::logic_error(name + " is not declared as a file of results (is_of_result)");
  const fs::path path = partial_ / name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) fail_to("create the folder", path.parent_path(), error.value());
  write_file(path, content);
}

void ResultFolder::commit() {
  check_target(target_);  // files may have appeared there while the models ran
  std::error_code error;
  for (const fs::path& entry : files_in(partial_))
    if (fs::is_directory(entry)) flush_folder(entry);
  flush_folder(partial_);

  // The rename replaces an empty folder only; another thread may have filled it by now.
  if (::rename(partial_.c_str(), target_.c_str()) == 0) {
    committed_ = true;
  } else if (errno != ENOTEMPTY && errno != EEXIST) {
    fail_to("move the result to", target_, errno);
  } else {
    fs::path old_folder =
        partial_;  // after the exchange the old result has the name of the partial one
    if (::renameat2(AT_FDCWD, partial_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) != 0) {
      if (errno != EINVAL && errno != ENOSYS) fail_to("replace the result in", target_, errno);
      old_folder = fmt::format("{}.old-{}", target_.string(), ::getpid());
      if (::rename(target_.c_str(), old_folder.c_str()) != 0)
        fail_to("replace the result in", target_, errno);
      if (::rename(partial_.c_str(), target_.c_str()) != 0) {
        const int reason = errno;
        ::rename(old_folder.c_str(), target_.c_str());
        fail_to("move the result to", target_, reason);
      }
    }
    committed_ = true;
    bool all_saved = true;
    carry_over(old_folder, target_, {}, all_saved);
    if (all_saved) fs::remove_all(old_folder, error);
  }
  parents_.keep();
  flush_folder(target_.parent_path());
}

void check_directory(const std::string& directory) {
  const ResultFolder trial(directory);
}

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
  if (::fstat(lock_, &here) == 0 && !S_ISREG(here.st_mode)) refuse_lock(file_);
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
    if (!before.empty() && before.rfind(owner_head, 0) != 0) refuse_lock(file_);
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

}  // namespace rollfem::result

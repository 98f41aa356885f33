// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/files/checkpoint_folder.hpp"

#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"
#include "result/files/files_together.hpp"
#include "result/files/result_folder.hpp"
#include "result/files/seal.hpp"
#include "result/quantities.hpp"
#include "result/record.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace rollfem::result {
namespace {

using contact::InputError;

/// Version of the folder and its records; raise it when result/record.cpp changes.
constexpr int format = 8;

/// Less work than this is not worth disk access.
constexpr auto grace = std::chrono::milliseconds(500);

const char* const about_name = "about.txt";
const std::string about_head = "Load points of an unfinished run of rollfem.";
const char* const record_suffix = ".point";
const char* const part_suffix = ".part";

bool is_record(const fs::path& name) {
  return name.extension() == record_suffix;
}

bool is_of_checkpoint(const fs::path& name) {
  return name == about_name || is_record(name) || name.extension() == part_suffix;
}

/// Checksum of the list of quantities, because a record holds them in this order.
unsigned long long checksum_of_quantities() {
  unsigned long long hash = contact::checksum({});
  for (const contact::Quantity& quantity : contact::quantities())
    hash = contact::checksum(quantity.name, hash);
  return hash;
}

/// Value of the line "name: value".
std::string line_of(const std::string& text, const std::string& name) {
  const std::size_t begin = text.find(name + ": ");
  if (begin == std::string::npos) return {};
  const std::size_t value = begin + name.size() + 2;
  return text.substr(value, text.find('\n', value) - value);
}

fs::path folder_of_records(const std::string& result_directory) {
  return resolved_folder(result_directory).string() + ".unfinished";
}

/// Removes our files. The file that identifies the records goes last, so that the rest remains
/// identifiable if the process is killed in between.
void empty(const fs::path& folder, std::error_code& error) {
  for (const fs::path& file : files_in(folder, error))
    if (const fs::path name = file.filename();
        !error && is_of_checkpoint(name) && name != about_name)
      fs::remove(file, error);
  if (!error) fs::remove(folder / about_name, error);
}

/// Whether rollfem made this folder; what a link leads to belongs to somebody else.
bool is_ours(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(fs::symlink_status(folder, error)) &&
         contents_of(folder / about_name).rfind(about_head, 0) == 0;
}

void remove_folder(const fs::path& folder) {
  if (!is_ours(folder)) return;
  std::error_code error;
  empty(folder, error);
  fs::remove(folder, error);  // stays if it contains other files
}

}  // namespace

std::string checksum_of_case(const contact::Case& input) {
  unsigned long long hash = contact::checksum(input.text);
  for (const std::string& file : contact::files_read_by(input))
    hash = contact::checksum(contents_of(file), hash);
  return fmt::format("{:016x}", hash);
}

CheckpointFolder::CheckpointFolder(const std::string& result_directory, const contact::Case& input,
                                   const std::string& program, bool resume,
                                   std::function<void(const std::string&)> warn)
    : resume_(resume), warn_(std::move(warn)) {
  folder_ = folder_of_records(result_directory);
  about_ = fmt::format(
      "{} The same command with --resume continues from "
      "them; without it they are replaced. The folder may be deleted.\nformat: {} "
      "{:016x}\nprogram: {}\ncase: {}\n",
      about_head, format, checksum_of_quantities(), program, checksum_of_case(input));
  look_at(input);
}

void CheckpointFolder::look_at(const contact::Case& input) {
  std::error_code error;
  if (fs::is_symlink(folder_) || fs::is_symlink(set_aside()))
    throw InputError(fmt::format(
        "{0} or {0}.earlier is a symbolic link, and rollfem needs these names for unfinished runs; "
        "do: move the link, or name another folder with -o",
        folder_.string()));
  if (!fs::exists(folder_, error)) return;
  const bool ours = is_ours(folder_);
  for (const fs::path& file : files_in(folder_, error)) {
    const fs::path name = file.filename();
    // Of a run that was killed before it had written `about_name` only parts are left.
    if (!is_of_checkpoint(name) || (!ours && name.extension() != part_suffix))
      throw InputError(
          fmt::format("{} is the folder for unfinished runs, but holds {}, which rollfem did not "
                      "write; do: move it, or name another folder with -o",
                      folder_.string(), name.string()));
    if (is_record(name)) ++found_;
  }
  if (error)
    throw InputError(fmt::format("cannot read {}: {}; do: name another folder with -o",
                                 folder_.string(), error.message()));
  if (!resume_ || found_ == 0) return;
  const std::string about = contents_of(folder_ / about_name);
  const auto refuse = [&](const std::string& other) {
    throw InputError(fmt::format(
        "--resume: {} holds load points {}; do: run without --resume to start again (they are then "
        "replaced)",
        folder_.string(), other));
  };
  if (line_of(about, "format") != line_of(about_, "format") ||
      line_of(about, "program") != line_of(about_, "program"))
    refuse(fmt::format("from another version of the program ({}; this is {})",
                       line_of(about, "program"), line_of(about_, "program")));
  if (line_of(about, "case") != line_of(about_, "case"))
    refuse(fmt::format("from another case: {} (or a file that it names) has changed since",
                       input.file));
  begun_ = true;
}

/// Where a record belongs: program and case, and its own name (scene, model, level, load point).
std::string CheckpointFolder::place_of(const std::string& name) const {
  return about_ + name + '\n';
}

bool CheckpointFolder::holds_records() const {
  const auto files = files_in(folder_);
  return begun_ && std::any_of(files.begin(), files.end(), is_record);
}

std::optional<std::string> CheckpointFolder::find(const std::string& name) {
  if (!has(name)) {
    for (const auto& other : others_)
      if (std::optional<std::string> record = other->find(name)) return record;
    return {};
  }
  std::optional<std::string> record = opened_record(place_of(name), contents_of(file_of(name)));
  if (!record) refuse(name);
  return record;
}

void CheckpointFolder::refuse(const std::string& name) {
  if (!has(name)) {
    for (const auto& other : others_) other->refuse(name);
    return;
  }
  warn_(
      fmt::format("{} is damaged, or belongs to another load point or case; its load "
                  "point is computed again",
                  file_of(name).string()));
}

fs::path CheckpointFolder::file_of(const std::string& name) const {
  return folder_ / (name + record_suffix);
}

/// Whether an earlier run has left a record of this name.
bool CheckpointFolder::has(const std::string& name) const {
  std::error_code error;
  return resume_ && found_ > 0 && fs::exists(file_of(name), error);
}

fs::path CheckpointFolder::set_aside() const {
  return folder_.string() + ".earlier";
}

/// Creates the folder; the folder of an earlier run is set aside until this run is done.
void CheckpointFolder::begin() {
  if (found_ > 0) {
    remove_folder(set_aside());
    fs::rename(folder_, set_aside());
  }
  fs::create_directories(folder_);
  std::error_code error;
  empty(folder_, error);
  if (error) throw fs::filesystem_error("cannot empty", folder_, error);
  replace_file(folder_ / about_name, about_);
  flush_folder(folder_.parent_path());
  found_ = 0;
  begun_ = true;
}

void CheckpointFolder::write(const std::string& name, const std::string& record) {
  if (!begun_) begin();
  replace_file(file_of(name), sealed_record(place_of(name), record));
  ++written_;
  if (stored_) stored_();
}

void CheckpointFolder::keep(const std::string& name, const std::string& record) {
  const std::lock_guard<std::mutex> one_at_a_time(mutex_);
  if (failed_) return;
  held_back_.emplace_back(name, record);
  if (std::chrono::steady_clock::now() - start_ < grace) return;
  try {
    for (const auto& [held_name, held_record] : held_back_) write(held_name, held_record);
    held_back_.clear();
  } catch (const std::exception& problem) {
    failed_ = true;
    held_back_.clear();
    warn_(fmt::format("finished load points are no longer stored; the run continues without: {}",
                      problem.what()));
  }
}

void CheckpointFolder::drop(const std::string& begin) {
  const std::lock_guard<std::mutex> one_at_a_time(mutex_);
  const auto fits = [&](const std::string& name) { return name.rfind(begin, 0) == 0; };
  held_back_.erase(std::remove_if(held_back_.begin(), held_back_.end(),
                                  [&](const auto& held) { return fits(held.first); }),
                   held_back_.end());
  if (!begun_) return;
  std::error_code ignored;
  for (const fs::path& file : files_in(folder_))
    if (is_record(file) && fits(file.filename().string())) fs::remove(file, ignored);
}

void CheckpointFolder::also_find_in(std::unique_ptr<CheckpointFolder> other) {
  others_.push_back(std::move(other));
}

bool CheckpointFolder::mark(const std::string& name) {
  start_ -= grace;
  keep(name, {});
  return !failed_;
}

bool CheckpointFolder::is_marked(const std::string& result_directory, const std::string& name) {
  std::error_code error;
  return fs::exists(folder_of_records(result_directory) / (name + record_suffix), error);
}

void CheckpointFolder::remove() {
  for (const auto& other : others_) other->remove();
  held_back_.clear();
  failed_ = true;
  remove_folder(folder_);
  remove_folder(set_aside());
}

void remove_records(const std::string& result_directory) {
  remove_folder(folder_of_records(result_directory));
}

}  // namespace rollfem::result

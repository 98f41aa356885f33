#include "app/files_together.hpp"

#include "contact/base/errors.hpp"
#include "postprocess/files/result_folder.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <unistd.h>

namespace fs = std::filesystem;

namespace rollfem::app {

FilesTogether::FilesTogether(std::string command, fs::path folder)
    : command_(std::move(command)), folder_(std::move(folder)) {
  for (fs::path p = fs::absolute(folder_).lexically_normal(); !fs::exists(p) && p.has_filename();
       p = p.parent_path())
    made_.push_back(p);
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error || !fs::is_directory(folder_)) {
    remove_made();
    throw contact::InputError(
        fmt::format("{}: the folder {} cannot be created: {}; do: name another with -o", command_,
                    folder_.string(), error ? error.message() : "it is a file"));
  }
}

FilesTogether::~FilesTogether() {
  if (done_) return;
  std::error_code ignored;
  for (const auto& [partial, name] : files_) fs::remove(partial, ignored);
  remove_made();
}

void FilesTogether::write(const std::string& name, std::string_view content) {
  const fs::path partial = folder_ / fmt::format("{}.partial-{}", name, getpid());
  postprocess::write_file(partial, content);
  files_.emplace_back(partial, folder_ / name);
}

void FilesTogether::commit() {
  for (const auto& [partial, name] : files_) {
    if (std::rename(partial.c_str(), name.c_str()) == 0) continue;
    throw contact::InputError(
        fmt::format("{}: {} cannot be written: {}; do: name another folder with -o", command_,
                    name.string(), std::strerror(errno)));
  }
  done_ = true;
}

void FilesTogether::remove_made() {
  std::error_code ignored;
  for (const fs::path& p : made_) fs::remove(p, ignored);
}

}  // namespace rollfem::app

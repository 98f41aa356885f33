// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/write/report.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <spawn.h>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace fs = std::filesystem;

namespace rollfem::result {
namespace {

/// A path becomes absolute, because Python starts in another folder. Scripts in a virtual
/// environment (lib/python3.x/site-packages or share/rollfem) get its Python, which has the
/// packages that pip installed with rollfem.
std::string find_python(const fs::path& scripts) {
  if (const char* chosen = std::getenv("ROLLFEM_PYTHON"); chosen && *chosen)
    return std::strchr(chosen, '/') != nullptr ? fs::absolute(chosen).string() : chosen;
  fs::path prefix = scripts.parent_path().parent_path();
  if (scripts.filename() == "site-packages") prefix = prefix.parent_path();
  if (fs::exists(prefix / "pyvenv.cfg")) return (prefix / "bin" / "python3").string();
  return ::access("/usr/bin/python3", X_OK) == 0 ? "/usr/bin/python3" : "python3";
}

/// The folder from which the package runs, given the package or its parent folder.
fs::path package_parent(const fs::path& scripts) {
  fs::path path = fs::absolute(scripts);
  if (fs::exists(path / "rollfem" / "__main__.py")) return path;
  const fs::path package = path.has_filename() ? path : path.parent_path();
  if (package.filename() == "rollfem" && fs::exists(package / "__main__.py"))
    return package.parent_path();
  return {};
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> out;
  out.reserve(texts.size() + 1);
  for (std::string& text : texts) out.push_back(text.data());
  out.push_back(nullptr);
  return out;
}

std::string read_to_end(int pipe) {
  std::string text;
  char buffer[4096];
  for (;;) {
    const ssize_t count = ::read(pipe, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer, static_cast<std::size_t>(count));
  }
}

std::string cannot_run(const std::string& python, int error) {
  return fmt::format(
      "cannot run {}: {}; do: install python3 python3-numpy python3-h5py or name "
      "another Python in ROLLFEM_PYTHON",
      python, std::strerror(error));
}

/// Runs a program in a folder; returns its output on failure, empty on success.
std::string run(std::vector<std::string> call, std::vector<std::string> environment,
                const std::string& folder) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return fmt::format("no pipe: {}", std::strerror(errno));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, call[0].c_str(), &actions, nullptr,
                                   pointers(call).data(), pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (error != 0) {
    ::close(ends[0]);
    return cannot_run(call[0], error);
  }
  std::string printed = read_to_end(ends[0]);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  if (!printed.empty()) return printed;
  return WIFSIGNALED(status) ? fmt::format("{} was killed by signal {}", call[0], WTERMSIG(status))
                             : fmt::format("{} failed without a message", call[0]);
}

/// Writes a traceback to a file and returns its last line, which names the error.
std::string one_line(const fs::path& directory, std::string printed) {
  while (!printed.empty() && printed.back() == '\n') printed.pop_back();
  const std::size_t last = printed.rfind('\n');
  if (last == std::string::npos) return printed;
  const fs::path log = directory / "report.log";
  std::ofstream file(log, std::ios::binary);
  file << printed << '\n';
  file.close();
  return printed.substr(last + 1) + (file ? fmt::format(" (full text in {})", log.string()) : "");
}

/// The environment of this process, with PYTHONPATH reduced to `first` and absolute paths; relative
/// and empty ones refer to the user's folder.
std::vector<std::string> environment(const std::string& first = "") {
  const std::string name = "PYTHONPATH=";
  std::vector<std::string> all;
  std::string path = first;
  for (char** entry = environ; entry && *entry; ++entry) {
    const std::string text(*entry);
    if (text.compare(0, name.size(), name) != 0) {
      all.push_back(text);
      continue;
    }
    std::istringstream rest(text.substr(name.size()));
    for (std::string part; std::getline(rest, part, ':');)
      if (fs::path(part).is_absolute()) path += (path.empty() ? "" : ":") + part;
  }
  all.push_back(name + path);
  return all;
}

}  // namespace

std::string become_package(const std::vector<std::string>& words,
                           const std::string& script_directory) {
  const fs::path parent = package_parent(script_directory);
  if (parent.empty()) return fmt::format("no Python package rollfem in {}", script_directory);
  std::vector<std::string> call{find_python(parent), "-B", "-P", "-X", "utf8", "-m", "rollfem"};
  call.insert(call.end(), words.begin(), words.end());
  // -P keeps modules of the user's folder out.
  std::vector<std::string> variables = environment(parent.string());
  ::execvpe(call[0].c_str(), pointers(call).data(), pointers(variables).data());
  return cannot_run(call[0], errno);
}

std::string make_report(const std::string& path, const std::string& script_directory,
                        const std::vector<std::string>& overlays) {
  const fs::path parent = package_parent(script_directory);
  if (parent.empty()) return fmt::format("no Python package rollfem in {}", script_directory);
  const fs::path what = fs::absolute(path);
  // Python searches its starting folder for modules first. It starts in the package's folder,
  // because in the user's folder a numpy.py would run.
  std::vector<std::string> call{find_python(parent), "-B", "-X", "utf8", "-m", "rollfem"};
  call.push_back(what.string());
  for (const std::string& overlay : overlays) call.push_back(fs::absolute(overlay).string());
  const std::string printed = run(std::move(call), environment(), parent.string());
  return one_line(fs::is_regular_file(what) ? what.parent_path() : what, printed);
}

}  // namespace rollfem::result

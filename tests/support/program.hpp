// Runs the real program as a user does: arguments in; exit status, stdout and stderr out.
#pragma once

#include <gtest/gtest.h>

#include "support/places.hpp"
#include "support/temporary_folder.hpp"
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace rollfem::testing {

struct Outcome {
  int status = -1;  ///< exit status, 128 + signal when a signal ended it
  std::string out;
  std::string err;
};

/// Working folder of a test, empty at first and removed at the end.
class Folder : public TemporaryFolder {
 public:
  Folder() { std::filesystem::create_directory(work()); }

  /// Where the program is started; what it writes lands here.
  std::filesystem::path work() const { return path() / "work"; }
  /// Where its output is kept.
  std::filesystem::path output(const std::string& name) const { return path() / name; }

  /// Everything the program left, sorted, relative to the working folder.
  std::vector<std::string> made() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(work()))
      names.push_back(entry.path().lexically_relative(work()).string());
    std::sort(names.begin(), names.end());
    return names;
  }
};

inline bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Runs a command in the folder, stdin empty, with NAME=value added to the environment, and without
/// a cache unless that names one.
/// `interrupt_after` > 0 sends Ctrl-C's signal after that many milliseconds.
inline Outcome execute(const Folder& folder, std::vector<std::string> command,
                       std::vector<std::string> environment = {}, int interrupt_after = 0) {
  std::vector<char*> arguments;
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  const std::string out = folder.output("stdout").string();
  const std::string err = folder.output("stderr").string();
  const std::string work = folder.work().string();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) {
    setenv("ROLLFEM_CACHE", "", 1);  // the user's is not for tests
    for (std::string& setting : environment) putenv(setting.data());
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    if (chdir(work.c_str()) != 0 || dup2(open("/dev/null", O_RDONLY), 0) < 0 ||
        dup2(open(out.c_str(), flags, 0600), 1) < 0 || dup2(open(err.c_str(), flags, 0600), 2) < 0)
      _exit(126);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  if (interrupt_after > 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(interrupt_after));
    kill(child, SIGINT);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  Outcome outcome;
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = contents(out);
  outcome.err = contents(err);
  return outcome;
}

/// Runs rollfem.
inline Outcome call(const Folder& folder, const std::vector<std::string>& arguments,
                    const std::vector<std::string>& environment = {}, int interrupt_after = 0) {
  std::vector<std::string> command{ROLLFEM_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return execute(folder, command, environment, interrupt_after);
}

/// One line on stderr that starts with the program's name, nothing on stdout, exit status 2.
inline void expect_refused(const Outcome& outcome, const std::string& part) {
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.rfind("rollfem: ", 0), 0u) << outcome.err;
  EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("do: "), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

}  // namespace rollfem::testing

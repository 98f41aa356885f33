// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs the real program as a user does: arguments in; exit status, stdout and stderr out.
#pragma once

#include <nlohmann/json.hpp>

#include "support/places.hpp"
#include "support/temporary_folder.hpp"
#include "support/test.hpp"
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace rollfem::testing {

struct Outcome {
  int status = -1;  ///< exit status, 128 + signal when a signal ended it
  std::string out;
  std::string err;
};

/// The call of rollfem with these arguments, on several processes where that is asked for.
inline std::vector<std::string> command_of(const std::vector<std::string>& arguments,
                                           int processes = 1) {
  std::vector<std::string> command;
  if (processes > 1)
    command = {"mpirun", "--allow-run-as-root", "--oversubscribe", "-n", std::to_string(processes)};
  command.emplace_back(ROLLFEM_PROGRAM);
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

/// The arguments that several calls share, and more.
inline std::vector<std::string> joined(std::vector<std::string> shared,
                                       const std::vector<std::string>& more) {
  shared.insert(shared.end(), more.begin(), more.end());
  return shared;
}

/// Ends the test if a call has failed.
inline Outcome checked(Outcome outcome) {
  if (outcome.status != 0)
    throw std::runtime_error("status " + std::to_string(outcome.status) + ": " + outcome.err);
  return outcome;
}

/// One line on stderr that starts with the program's name, nothing on stdout, exit status 2.
inline void expect_refused(const Outcome& outcome, const std::string& part) {
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.rfind("rollfem: ", 0), 0u) << outcome.err;
  EXPECT_TRUE(says(outcome.err, part, "do: "));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

/// Working folder of a test, empty at first and removed at the end.
class Folder : public TemporaryFolder {
 public:
  Folder() { std::filesystem::create_directory(work()); }

  /// Where the program is started; what it writes lands here.
  std::filesystem::path work() const { return path() / "work"; }
  /// Content of the folder: a file's text, a JSON file, whether a file or folder exists.
  std::string text(const std::string& name) const { return contents(work() / name); }
  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(text(name)); }
  bool holds(const std::string& name) const { return std::filesystem::exists(work() / name); }

  /// Everything the program left, sorted, relative to the working folder.
  std::vector<std::string> made() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(work()))
      names.push_back(entry.path().lexically_relative(work()).string());
    std::sort(names.begin(), names.end());
    return names;
  }

  /// Runs a command in the folder, stdin empty, with NAME=value added to the environment, and
  /// without a cache unless that names one. `watch` is called every few milliseconds until it
  /// returns a signal, which is sent once; 0: not yet.
  Outcome execute(std::vector<std::string> command, std::vector<std::string> environment = {},
                  const std::function<int()>& watch = {}) const {
    static int calls = 0;  // one may be made while another is watched
    const std::string number = std::to_string(++calls);
    std::vector<char*> arguments;
    for (std::string& argument : command) arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    const std::string out = path("stdout_" + number), err = path("stderr_" + number);
    const std::string working = work().string();
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) {
      setenv("ROLLFEM_CACHE", "", 1);  // the user's is not for tests
      for (std::string& setting : environment) putenv(setting.data());
      const int flags = O_WRONLY | O_CREAT | O_TRUNC;
      if (chdir(working.c_str()) != 0 || dup2(open("/dev/null", O_RDONLY), 0) < 0 ||
          dup2(open(out.c_str(), flags, 0600), 1) < 0 ||
          dup2(open(err.c_str(), flags, 0600), 2) < 0)
        _exit(126);
      execvp(arguments[0], arguments.data());
      _exit(127);
    }
    int status = 0;
    for (int sent = watch ? 0 : -1; waitpid(child, &status, sent == 0 ? WNOHANG : 0) != child;) {
      if (sent != 0) continue;
      sent = watch();
      if (sent != 0) kill(child, sent);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contents(out),
            contents(err)};
  }

  /// Runs rollfem.
  Outcome call(const std::vector<std::string>& arguments,
               const std::vector<std::string>& environment = {},
               const std::function<int()>& watch = {}) const {
    return execute(command_of(arguments), environment, watch);
  }

  /// Runs rollfem, which must succeed.
  Outcome done(const std::vector<std::string>& arguments,
               const std::vector<std::string>& environment = {}) const {
    return checked(call(arguments, environment));
  }
};

inline bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The first load point of the first model of a result.
inline nlohmann::json point_of(const Folder& folder, const std::string& result) {
  return folder.json(result + "/summary.json")["models"][0]["points"][0];
}

/// A `watch` that sends Ctrl-C's signal after that many milliseconds.
inline std::function<int()> interrupt_after(int milliseconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds);
  return [end] { return std::chrono::steady_clock::now() < end ? 0 : SIGINT; };
}

/// A test that calls the program, in a folder of its own.
class ProgramTest : public ::testing::Test {
 protected:
  using Words = std::vector<std::string>;

  Outcome execute(const Words& command, const Words& environment = {}) const {
    return folder.execute(command, environment);
  }
  Outcome call(const Words& arguments, const Words& environment = {},
               const std::function<int()>& watch = {}) const {
    return folder.call(arguments, environment, watch);
  }
  Outcome done(const Words& arguments, const Words& environment = {}) const {
    return folder.done(arguments, environment);
  }
  /// The program refuses the call with a message that has this part.
  void refuses(const Words& arguments, const std::string& part) const {
    expect_refused(call(arguments), part);
  }

  const Folder folder;
};

}  // namespace rollfem::testing

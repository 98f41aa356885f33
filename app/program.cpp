// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/program.hpp"

#include "app/frame/commands.hpp"
#include "app/version_text.hpp"
#include "base/errors.hpp"
#include "base/text_fields.hpp"
#include "modelling/frame/interruption.hpp"
#include "modelling/program/provenance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <iostream>
#include <new>
#include <poll.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace rollfem::app {

namespace {

/// Whether the reader has closed the pipe (`rollfem run ... | head -1`), which is no failure.
bool reader_is_gone() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&output, 1, 0) > 0 && (output.revents & (POLLERR | POLLHUP)) != 0;
}

/// Keeps opened files from getting the number of an output that the caller has closed (`>&-`),
/// because printed text would go into them. A pipe without reader does not end a computation
/// either.
void guard_outputs() {
  for (int file = STDIN_FILENO; file <= STDERR_FILENO; ++file)
    if (::fcntl(file, F_GETFD) < 0 && errno == EBADF && ::open("/dev/null", O_RDWR) < 0) return;
  std::signal(SIGPIPE, SIG_IGN);
}

/// Checked here, because CLI11 only says that a command is missing.
void check_command(const CLI::App& program, const std::vector<std::string>& words) {
  std::vector<std::string> known;
  for (const CLI::App* command : program.get_subcommands(nullptr))
    known.push_back(command->get_name());
  const std::string allowed = "allowed: " + contact::listed(known) + "; do: rollfem --help";
  if (words.empty()) throw contact::InputError("no command given; " + allowed);
  known.emplace_back("help");
  const std::string& name = words.front();
  if (name.empty() || name.front() == '-') return;
  const auto is_named = [&](const CLI::App* command) { return command->check_name(name); };
  if (program.get_subcommands(is_named).empty())
    throw contact::InputError(fmt::format("{}: unknown command; {}{}", name,
                                          contact::did_you_mean(name, known), allowed));
}

/// Message for an unknown option, with the most similar one.
std::string unknown_option(const CLI::App& program, const std::string& given) {
  std::vector<std::string> options;
  std::vector<const CLI::App*> commands{&program};
  for (const CLI::App* command : program.get_subcommands()) commands.push_back(command);
  for (const CLI::App* command : commands)
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : option->get_lnames())
        if (std::find(options.begin(), options.end(), "--" + name) == options.end())
          options.push_back("--" + name);
  return fmt::format("{}: unknown option; {}allowed: {}", given,
                     contact::did_you_mean(given, options), contact::listed(options));
}

/// CLI11's message about a call; for an unknown option our own.
std::string what_is_wrong(const CLI::App& program, const CLI::ParseError& error) {
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    for (const std::string& word : program.remaining(true))
      if (word.size() > 2 && word.rfind("--", 0) == 0)
        return unknown_option(program, word.substr(0, word.find('=')));
  return error.what();
}

/// Translates `rollfem help` and `rollfem help run` to `rollfem --help` and `rollfem run --help`,
/// and `rollfem --schema` to a page of `rollfem docs`.
std::vector<std::string> arguments(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.push_back("--help");
  }
  if (words == std::vector<std::string>{"--schema"}) words = {"docs", "schema"};
  return words;
}

/// Processes of mpirun on one machine share its cores, unless each is bound to some of them.
void share_cores(Call& call) {
  const int allowed = contact::allowed_threads();
  const int together = modelling::processes().on_machine;
  if (together == 1 || std::getenv("OMP_NUM_THREADS") != nullptr) return;
  const int cores = std::min(static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN)),
                             contact::allowed_cores("/proc", "/sys/fs/cgroup"));
  call.threads.emplace(std::min(allowed, std::max(1, cores / together)));
}

int execute(int argc, char** argv, const contact::ModelRegistry& models) {
  Call call{models, fmt::format("{}", fmt::join(argv, argv + argc, " "))};
  CLI::App program("rollfem: rolling contact of wheel and rail by half-spaces and finite elements",
                   "rollfem");
  program.set_version_flag("--version", version_text, "version, features and libraries");
  program.require_subcommand(1);
  for (const auto add :
       {add_run, add_compare, add_study, add_bench, add_table, add_stress, add_mesh, add_profile,
        add_wheelset, add_check, add_new_case, add_convert, add_report, add_cache, add_docs})
    add(program, call);
  add_quiet_flags(program);
  add_threads_option(program, call);
  share_cores(call);
  std::vector<std::string> words = arguments(argc, argv);
  check_command(program, words);
  std::reverse(words.begin(), words.end());  // the order CLI11 expects
  try {
    program.parse(words);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);
    throw contact::InputError(fmt::format("{}; do: rollfem --help", what_is_wrong(program, error)));
  }
  std::cout.flush();
  if (!std::cout && !reader_is_gone())
    throw contact::OutputError(
        "standard output cannot be written; do: check whether its disk is full");
  return call.undrawn ? 1 : 0;
}

/// Process 0 reports the failure. The others wait for it to end them through mpirun, and report
/// themselves only if that does not happen.
[[noreturn]] void failed(int status, const std::string& what) {
  const modelling::Processes here = modelling::processes();
  if (!here.first()) std::this_thread::sleep_for(std::chrono::seconds(3));
  const std::string where = here.first() ? "" : fmt::format("process {}: ", here.rank);
  std::cerr << fmt::format("rollfem: {}{}\n", where, what);
  modelling::leave(status);
}

}  // namespace

int run_program(int argc, char** argv, const contact::ModelRegistry& models) {
  guard_outputs();
  modelling::handle_interruptions();
  try {
    return execute(argc, argv, models);
  } catch (const contact::OutputError& error) {
    failed(1, error.what());
  } catch (const contact::InputError& error) {
    failed(2, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    failed(2, fmt::format("{}: {}; do: correct the path", error.path1().string(),
                          error.code().message()));
  } catch (const contact::SolveError& error) {
    failed(1, error.what());
  } catch (const std::bad_alloc&) {
    failed(1, "out of memory; do: use fewer or larger elements, or more processes");
  } catch (const std::exception& error) {
    failed(1, fmt::format("internal error: {}", error.what()));
  }
}

}  // namespace rollfem::app

// SPDX-License-Identifier: LGPL-2.1-or-later
// The commands of the program. A command is one file that declares its options and does its work;
// here is what calls and options of several commands have in common.
#pragma once

#include "base/threads.hpp"
#include "case/case.hpp"
#include "contact/solve/model.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::app {

/// A call of the program.
struct Call {
  const contact::ModelRegistry& models;
  std::string command;  ///< the whole call, for provenance
  int argc = 0;         ///< of main, for MPI
  char** argv = nullptr;
  bool undrawn = false;                          ///< a report or figure that was wanted
  std::optional<contact::Threads> threads = {};  ///< those of --threads
};

/// The request of a command that writes a folder, most often on a case file.
struct CaseRequest {
  explicit CaseRequest(Call& made_by) : call(made_by) {}

  Call& call;
  std::string case_file;
  std::vector<std::string> changes;  ///< of keys, from --set
  std::string directory;             ///< empty: a folder of results/

  /// Throws contact::InputError.
  contact::Case read() const { return read(case_file); }
  contact::Case read(const std::string& file) const;
  /// `directory`, otherwise results/<name of the case file><ending>.
  std::filesystem::path folder(const std::string& ending) const;
};

/// Allows these words alone, for CLI::Option::check.
CLI::Validator one_of(const std::vector<std::string>& words);

/// Adds the repeatable option `--set KEY=VALUE`.
void add_set_option(CLI::App& command, std::vector<std::string>& changes);

/// Adds `--json`, which prints one JSON object and nothing else on standard output.
void add_json_flag(CLI::App& command, bool& json);

/// Adds `--model` under `names`; `rest` ends its help text, after the names of all models.
void add_model_option(CLI::App& command, const std::string& names, std::vector<std::string>& models,
                      const Call& call, const std::string& rest);

/// Adds `--threads N` to every command that computes.
void add_threads_option(CLI::App& program, Call& call);

/// Adds `--quiet` to every command without it, except those that print nothing but a file.
void add_quiet_flags(CLI::App& program);

/// An example and every model with its description, for the end of a help text.
std::string footer_with_models(const std::string& example, const contact::ModelRegistry& models);

/// One line each on stderr, even with -q.
void warn(const std::vector<std::string>& warnings);

/// Draws the figures of a written table or result. If that fails, warns with `failure` and the
/// reason and returns false.
bool draw(Call& call, const std::filesystem::path& written, const std::string& failure);

/// Draws the figure of a table and prints where both are.
void draw_and_tell(Call& call, const std::filesystem::path& table);

// Each adds a command; `call` must outlive parsing.
void add_run(CLI::App& program, Call& call);
void add_compare(CLI::App& program, Call& call);
void add_study(CLI::App& program, Call& call);
void add_bench(CLI::App& program, Call& call);
void add_table(CLI::App& program, Call& call);
void add_stress(CLI::App& program, Call& call);
void add_mesh(CLI::App& program, Call& call);
void add_profile(CLI::App& program, Call& call);
void add_wheelset(CLI::App& program, Call& call);
void add_check(CLI::App& program, Call& call);
void add_new_case(CLI::App& program, Call& call);
void add_convert(CLI::App& program, Call& call);
void add_report(CLI::App& program, Call& call);
void add_cache(CLI::App& program, Call& call);
void add_docs(CLI::App& program, Call& call);

}  // namespace rollfem::app

// SPDX-License-Identifier: LGPL-2.1-or-later
// The commands of the program. A command is one file that declares its options and does its work;
// here is what calls and options of several commands have in common.
#pragma once

#include "base/threads.hpp"
#include "case/case.hpp"
#include "contact/solve/model.hpp"
#include "modelling/frame/command_frame.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::app {

/// A call of the program.
struct Call {
  const contact::ModelRegistry& models;
  std::string command;                           ///< the whole call, for provenance
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

using modelling::CommandFrame;

/// Common part of the requests of run and table.
struct ComputingRequest : CaseRequest, modelling::Computing {
  explicit ComputingRequest(Call& made_by)
      : CaseRequest(made_by), Computing{made_by.models, made_by.command} {}
  bool report = true;  ///< draw figures and page, which takes some seconds
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

/// Adds the options that ComputingRequest holds, except those that divide the work.
void add_report_flags(CLI::App& command, ComputingRequest& request);

/// Adds the options that divide long work among calls (array jobs, machines).
void add_division(CLI::App& command, contact::RunPart& own, int& merge, const std::string& items);

/// An example and every model with its description, for the end of a help text.
std::string footer_with_models(const std::string& example, const contact::ModelRegistry& models);

/// One line each on stderr, even with -q.
void warn(const std::vector<std::string>& warnings);

/// Warns of values in the case that look like unit mistakes, even with -q.
void warn_of_doubts(const contact::Case& input);

/// Draws the figures of a written table or result. If that fails, warns with `failure` and the
/// reason and returns false.
bool draw(Call& call, const std::filesystem::path& written, const std::string& failure);

/// Draws the figure of a table and prints where both are.
void draw_and_print(Call& call, const std::filesystem::path& table);

/// Draws figures and report of a written folder if they are wanted. Warns if that fails.
bool report_drawn(const ComputingRequest& request, const std::filesystem::path& directory);

/// Prints where the results are and, if it was drawn, the report.
void print_where(const std::filesystem::path& directory, const char* page, bool drawn);

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

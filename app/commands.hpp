// SPDX-License-Identifier: LGPL-2.1-or-later
// The commands of the program: options, help, and the checks of a call before its execution.
#pragma once

#include "app/input/check.hpp"
#include "app/input/convert.hpp"
#include "app/input/mesh.hpp"
#include "app/input/profile.hpp"
#include "app/input/wheelset.hpp"
#include "app/results/compare.hpp"
#include "app/results/stress.hpp"
#include "app/results/table.hpp"
#include "app/run/bench.hpp"
#include "app/run/run.hpp"
#include "app/study/study.hpp"

#include <CLI/CLI.hpp>

#include <string>

namespace rollfem::app {

/// The parsed command line.
struct Call {
  const contact::ModelRegistry& models;
  RunRequest run = {};
  CompareRequest compare = {};
  StudyRequest study = {};
  BenchRequest bench = {};
  TableRequest table = {};
  MeshRequest mesh = {};
  StressCommand stress = {};
  ProfileRequest profile = {};
  ConvertRequest convert = {};
  WheelsetRequest wheelset = {};
  CheckRequest check = {};
  std::string new_case_file = {};
  std::string drawn_directory = {};
  std::string page = {};
  std::string cache_action = "list";
  bool undrawn = false;  ///< a report or figure that was wanted
};

/// Adds the repeatable option `--set KEY=VALUE`.
void add_set_option(CLI::App& command, std::vector<std::string>& changes);

/// Adds `--json`, which prints one JSON object and nothing else on standard output.
void add_json_flag(CLI::App& command, bool& json);

/// Adds `--quiet` to every command without it, except those that print nothing but a file.
void add_quiet_flags(CLI::App& program);

/// Each function adds its commands; `call` must outlive parsing.
void add_computing_commands(CLI::App& program, Call& call);  ///< run, compare, study, table, bench
void add_stress_command(CLI::App& program, Call& call);
void add_input_commands(
    CLI::App& program,
    Call& call);  ///< mesh, profile, wheelset, check, new-case, convert, report, cache, docs

}  // namespace rollfem::app

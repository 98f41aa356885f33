// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/commands.hpp"
#include "app/frame/parts.hpp"
#include "app/frame/screen.hpp"
#include "contact/base/errors.hpp"
#include "models/registry.hpp"
#include "models/solving/auto_model.hpp"
#include "models/study/study_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace rollfem::app {

namespace {

/// In `run --model hertz CASE` the list option swallows the case file; this moves it back.
void settle_run(RunRequest& request, const contact::ModelRegistry& models) {
  if (request.case_file.empty() && !request.models.empty() &&
      models.find(request.models.back()) == nullptr) {
    request.case_file = request.models.back();
    request.models.pop_back();
  }
  if (request.case_file.empty())
    throw contact::InputError("run: no case file is named; do: rollfem run CASE.toml");
  request.models = modelling::checked_names(models, request.models, "--model");
}

/// The same for several case files after the models.
void settle_compare(CompareRequest& request, const contact::ModelRegistry& models) {
  const auto is_file = [&](const std::string& name) {
    return models.find(name) == nullptr && std::filesystem::path(name).extension() == ".toml";
  };
  const auto first = std::find_if(request.models.begin(), request.models.end(), is_file);
  request.case_files.insert(request.case_files.end(), first, request.models.end());
  request.models.erase(first, request.models.end());
  if (request.case_files.empty())
    throw contact::InputError(
        "compare: no case file is named; do: rollfem compare CASE.toml [CASE.toml ...]");
  request.models = modelling::checked_names(models, request.models, "--model");
  modelling::refuse_choice(models, request.models, "compare");
  if (!request.reference.empty()) static_cast<void>(models.at(request.reference, "--reference"));
}

/// Like settle_run for `study --models all CASE`; "all" must stand alone.
void settle_study(StudyRequest& request, const contact::ModelRegistry& models) {
  for (std::vector<std::string>* list : {&request.models, &request.vary, &request.references})
    if (request.case_file.empty() && !list->empty() &&
        std::filesystem::path(list->back()).extension() == ".toml") {
      request.case_file = list->back();
      list->pop_back();
    }
  if (request.case_file.empty())
    throw contact::InputError("study: no case file is named; do: rollfem study CASE.toml");
  if (request.models == std::vector<std::string>{"all"}) return;
  request.models = modelling::checked_names(models, request.models, "--model");
  modelling::refuse_choice(models, request.models, "study");
}

/// "hertz, linear, ..."
std::string model_help(const contact::ModelRegistry& models) {
  return contact::listed(models.names());
}

/// Every model with its description, for the end of a help text.
std::string model_list(const contact::ModelRegistry& models) {
  std::string text = "\nmodels:\n";
  for (const contact::ModelInfo& model : models.all())
    text += fmt::format("  {:<20}{}{}\n", model.name, model.sentence,
                        model.built ? "" : " (not in this build)");
  return text;
}

/// "grid (of carter, fastsim), cell (of fem)"
std::string refinement_help(const contact::ModelRegistry& models) {
  std::vector<std::string> ways;
  for (const std::string& word : modelling::varied_words(models))
    ways.push_back(fmt::format("{} (of {})", word,
                               contact::listed(modelling::models_that_vary(models, word))));
  return contact::listed(ways);
}

/// Options common to run, compare and study.
template <class Request>
void add_report_flags(CLI::App& command, Request& request) {
  add_set_option(command, request.changes);
  command.add_flag("-q,--quiet", request.quiet, "print errors and warnings only");
  command.add_flag_callback(
      "--no-report", [&request] { request.report = false; },
      "write results only, no figures and no report");
}

/// Options that divide long work among calls (array jobs, machines).
template <class Request>
void add_division(CLI::App& command, Request& request, const std::string& items) {
  command.add_option_function<std::string>(
      "--part", [&request](const std::string& text) { request.share = app::parse_part(text); },
      "K/N: compute part K of N of the " + items +
          " and store it beside FOLDER; calls for other parts may run at the same time, on any "
          "machine that shares the folder");
  command
      .add_option("--merge", request.merge,
                  "N: write the result of the N parts computed with --part, or list the missing "
                  "ones; identical to the result of a single call")
      ->check(CLI::Range(2, 1000000));
}

void add_run(CLI::App& program, Call& call) {
  CLI::App* run = program.add_subcommand("run", "solve a case with one or more models");
  run->add_option("case", call.run.case_file, "case file (.toml)");
  run->add_option("-m,--model", call.run.models,
                  model_help(call.models) +
                      "; give several in a row or repeat the option (default: the models of the "
                      "case file, or auto)")
      ->delimiter(',');
  run->add_option("-o,--output", call.run.directory,
                  "folder for the results (default: results/<name of the case file>)");
  run->add_flag("--resume", call.run.resume,
                "continue an interrupted run from the load points kept in FOLDER.unfinished");
  add_division(*run, call.run, "positions of a wheelset");
  add_report_flags(*run, call.run);
  run->footer("example: rollfem run cases/thesis_a.toml --model halfspace -o /tmp/case_a\n" +
              model_list(call.models));
  run->callback([&call] {
    settle_run(call.run, call.models);
    app::run(call.run, call.models);
  });
}

void add_compare(CLI::App& program, Call& call) {
  CLI::App* compare =
      program.add_subcommand("compare", "solve cases with several models and compare the results");
  compare->add_option("case", call.compare.case_files, "case files (.toml), one or more");
  compare
      ->add_option("-m,--model", call.compare.models,
                   model_help(call.models) +
                       "; give several in a row or repeat the option; default: " +
                       contact::listed(call.models.names(&contact::ModelInfo::in_compare)) +
                       ", regardless of the models in the case files")
      ->delimiter(',');
  compare->add_option(
      "--reference", call.compare.reference,
      "reference model of the comparison; default: " + call.models.reference().name);
  compare->add_option("-o,--output", call.compare.directory,
                      "folder for the comparison (default: results/compare_<name of the case "
                      "file>, results/compare for several)");
  compare->add_flag("--resume", call.compare.resume,
                    "keep the cases that an earlier call finished and solve the others");
  add_report_flags(*compare, call.compare);
  compare->footer("example: rollfem compare cases/thesis_*.toml --reference halfspace\n" +
                  model_list(call.models));
  compare->callback([&call] {
    settle_compare(call.compare, call.models);
    app::compare(call.compare, call.models);
  });
}

void add_study(CLI::App& program, Call& call) {
  CLI::App* study = program.add_subcommand(
      "study", "solve a case on ever finer grids: errors, observed orders, cost");
  study->add_option("case", call.study.case_file, "case file (.toml)");
  study
      ->add_option("-m,--model,--models", call.study.models,
                   model_help(call.models) + ", or all; default: " + call.models.reference().name)
      ->delimiter(',');
  study
      ->add_option("--vary", call.study.vary,
                   "what to refine: " + refinement_help(call.models) +
                       "; give several in a row (default: the first one of each model)")
      ->delimiter(',');
  study->add_flag("--together", call.study.together,
                  "refine everything in --vary together (default: one at a time)");
  study->add_option("--levels", call.study.levels,
                    "number of levels, 2 to 8 (default: 5 grids, from a quarter of the case's "
                    "elements to four times as many; 3 cell sizes, from four times the case's to "
                    "the case's; 3 domains, from half to twice the case's)");
  study
      ->add_option("--reference", call.study.references,
                   "reference of the errors: exact (Hertz), finest, extrapolated, or numbers such "
                   "as max_pressure=578.967 traction_coefficient:4=0.3722 (with several patches "
                   "left_1_2.max_pressure=1010); default: exact where an exact "
                   "value exists, otherwise extrapolated")
      ->delimiter(',');
  study->add_option("-o,--output", call.study.directory,
                    "folder for the study (default: results/<name of the case file>_study)");
  study->add_flag("--resume", call.study.resume,
                  "continue an interrupted study from the levels kept in FOLDER.unfinished");
  add_division(*study, call.study, "levels");
  add_report_flags(*study, call.study);
  study->footer("example: rollfem study cases/thesis_a.toml --models all\n" +
                model_list(call.models));
  study->callback([&call] {
    settle_study(call.study, call.models);
    app::study(call.study, call.models);
  });
}

void add_bench(CLI::App& program, Call& call) {
  CLI::App* bench = program.add_subcommand(
      "bench",
      "measure error and run time of each model on this machine, in cases with known solutions");
  bench->add_option("--seconds", call.bench.seconds,
                    "time limit; runs expected to exceed it are skipped (default: 30)");
  bench->add_flag(
      "--quick", call.bench.quick,
      "one case on coarse grids, about a second; does not store the speed of the machine");
  add_json_flag(*bench, call.bench.json);
  bench->add_flag_callback(
      "-q,--quiet",
      [&call] {
        call.bench.quiet = true;
        silence();
      },
      "print errors and warnings only");
  bench->footer("example: rollfem bench");
  bench->callback([&call] { app::bench(call.bench, call.models); });
}

void add_table(CLI::App& program, Call& call) {
  CLI::App* table =
      program.add_subcommand("table",
                             "compute a table of creep forces over creepages, spin and "
                             "the ratio of the ellipse's axes or the "
                             "lateral shift of a wheelset");
  table
      ->add_option("case", call.table.case_file,
                   "case file (.toml); its section [table] defines the grid")
      ->required();
  table->add_option("-o,--output", call.table.directory,
                    "folder for the table (default: results/<name of the case file>_table)");
  table->add_flag("--resume", call.table.resume,
                  "resume an interrupted table from the points kept in FOLDER.unfinished");
  add_division(*table, call.table, "points");
  add_report_flags(*table, call.table);
  table->footer(
      "examples: rollfem table cases/thesis_a.toml --set table.points=[10,10,11]\n"
      "          rollfem table cases/s1002_uic60_left.toml --set table.lateral_shift=[-2,0,2]\n"
      "Contents of a table, and how Python and C read it: docs/tables.md");
  table->callback([&call] { app::table(call.table, call.models); });
}

}  // namespace

void add_set_option(CLI::App& command, std::vector<std::string>& changes) {
  command
      .add_option("--set", changes,
                  "change a key of the case file, e.g. friction.coefficient=0.3; repeat the option "
                  "for more keys")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
}

void add_json_flag(CLI::App& command, bool& json) {
  const bool has_folder = command.get_option_no_throw("--output") != nullptr;
  const std::string files = has_folder ? "; files are written only if -o names a folder" : "";
  command.add_flag_callback(
      "--json",
      [&json] {
        json = true;
        silence();
      },
      "print one JSON object and nothing else" + files);
}

void add_quiet_flags(CLI::App& program) {
  for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    const std::string& name = command->get_name();
    if (command->get_option_no_throw("--quiet") == nullptr && name != "docs" && name != "new-case")
      command->add_flag_callback("-q,--quiet", silence, "print errors and warnings only");
  }
}

void add_computing_commands(CLI::App& program, Call& call) {
  add_run(program, call);
  add_compare(program, call);
  add_study(program, call);
  add_bench(program, call);
  add_table(program, call);
}

}  // namespace rollfem::app

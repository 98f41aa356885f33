// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `run`: the models of a case one after the other, then results and report.
#include "app/frame/commands.hpp"
#include "app/input/wheelset.hpp"
#include "app/run/run_table.hpp"
#include "base/errors.hpp"
#include "modelling/frame/parts.hpp"
#include "modelling/registry.hpp"
#include "modelling/solving/auto_model.hpp"
#include "modelling/solving/case_scenes.hpp"
#include "modelling/solving/solving.hpp"
#include "result/files/result_folder.hpp"
#include "result/write/output.hpp"
#include "result/write/wheelset_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace rollfem::app {

namespace fs = std::filesystem;

namespace {

struct RunRequest : ComputingRequest {
  using ComputingRequest::ComputingRequest;
  std::vector<std::string> models;  ///< empty: those of the case file

  fs::path folder() const { return CaseRequest::folder(""); }
  contact::Case read() const {
    contact::Case input = CaseRequest::read();
    if (!models.empty()) input.models = models;
    return input;
  }
};

/// Checks for problems that would otherwise appear only after hours of computing: a folder that
/// cannot be created, a model that cannot take the case.
void check_before(const RunRequest& request, const contact::Case& input,
                  const modelling::Placed& placed) {
  result::check_directory(request.folder().string());
  for (const contact::Scene& scene : modelling::unbalanced_scenes(input, placed))
    for (const std::string& name : input.models) request.call.models.check(scene, name);
}

/// The model shown for each position: the one with most patches, because not every theory can take
/// all of them; among equals the reference model.
std::string model_to_print(const result::RunRecord& record, const contact::ModelRegistry& models) {
  const auto patches = [&](const std::string& name) {
    return std::count_if(record.models.begin(), record.models.end(),
                         [&](const contact::ModelResult& model) { return model.name == name; });
  };
  std::string most = models.reference().name;
  for (const std::string& name : result::model_names(record))
    if (patches(name) > patches(most)) most = name;
  return most;
}

/// Tells early that `rollfem stress` will lack data.
void print_what_is_not_stored(const result::RunRecord& record,
                              const contact::ModelRegistry& models) {
  const auto keeps = [&](const contact::ModelResult& model) {
    return models.at(model.name).keeps_bodies && model.points_with_bodies().empty();
  };
  const auto found = std::find_if(record.models.begin(), record.models.end(), keeps);
  if (found == record.models.end()) return;
  std::cout << fmt::format(
      "not stored: the bodies of {}, from which rollfem stress reads; [output] body_fields = "
      "\"last\" or \"all\" stores them\n",
      found->label);
}

void write_and_print(const RunRequest& request, const result::RunRecord& record) {
  const contact::ModelRegistry& models = request.call.models;
  const fs::path directory = request.folder();
  modelling::store_results(directory.string(), record);
  // A wheel above its rail leaves nothing to draw.
  const bool drawn = !record.models.empty() && report_drawn(request, directory);
  if (request.quiet) return;
  std::cout << record.input.title << "\n\n"
            << run_table(record) << result::wheelset_table(record, model_to_print(record, models));
  std::cout << '\n' << notes_text(record.models, contact::Note::remark);
  print_where(directory, "report.html", drawn);
  print_what_is_not_stored(record, models);
  std::cout << notes_text(record.models, contact::Note::warning);
  if (!record.verdict.empty()) std::cout << "warning: " << record.verdict << '\n';
}

/// Throws if sound results miss the requested accuracy: they are written, but the run fails.
void refuse_shortfall(const result::RunRecord& record) {
  std::vector<const contact::ModelResult*> missed;
  for (const contact::ModelResult& model : record.models)
    if (!model.shortfall.empty()) missed.push_back(&model);
  if (missed.empty()) return;
  const contact::ModelResult& first = *missed.front();
  throw contact::SolveError(
      fmt::format("{}: the results were written, but {}model {}: {}", record.input.file,
                  missed.size() > 1 ? record.verdict + " " + first.key() + ", " : "", first.name,
                  first.shortfall));
}

void run_at_once(const RunRequest& request) {
  result::RunRecord record;
  record.input = request.read();
  const std::string asked_by = request.models.empty() ? request.case_file + ": models" : "--model";
  modelling::check_alone(request.call.models, record.input.models, asked_by);
  CommandFrame frame(request, record.input.models);
  if (frame.idle()) return;
  if (frame.first()) warn_of_doubts(record.input);
  const modelling::Placed placed = modelling::placed_wheels(record.input);
  if (frame.first()) check_before(request, record.input, placed);
  frame.own(request.folder());
  record.provenance = frame.provenance();
  frame.compute(asked_by, "load points", [&](modelling::Solving how) {
    how.checkpoint = frame.keep_in(request.folder(), record.input);
    how.own = request.own;
    how.placed = placed;
    modelling::solve(record, how);
    if (!how.first || frame.ends_part()) return;
    if (placed) add_rigid_wheelset(placed->search, record);
    frame.clear_line();
    write_and_print(request, record);
    frame.forget_kept();
    refuse_shortfall(record);
  });
}

void run(RunRequest& request) {
  const contact::ModelRegistry& models = request.call.models;
  // In `run --model hertz CASE` the list option swallows the case file.
  if (request.case_file.empty() && !request.models.empty() &&
      models.find(request.models.back()) == nullptr) {
    request.case_file = request.models.back();
    request.models.pop_back();
  }
  if (request.case_file.empty())
    throw contact::InputError("run: no case file is named; do: rollfem run CASE.toml");
  request.models = modelling::checked_names(models, request.models, "--model");
  const contact::Case input = request.read();
  const std::size_t positions = input.has_profiles() ? input.wheelset.positions() : 1;
  modelling::check_division(request, positions, "position of the wheelset");
  const bool divisible =
      positions > 1 && !input.is_wheel_history() && !modelling::any_parallel(models, input.models);
  modelling::in_parts(request, divisible, request.folder(), [&] { run_at_once(request); });
}

}  // namespace

void add_run(CLI::App& program, Call& call) {
  const auto request = std::make_shared<RunRequest>(call);
  CLI::App* run = program.add_subcommand("run", "solve a case with one or more models");
  run->add_option("case", request->case_file, "case file (.toml)");
  add_model_option(*run, "-m,--model", request->models, call,
                   "; give several in a row or repeat the option (default: the models of the case "
                   "file, or auto)");
  run->add_option("-o,--output", request->directory,
                  "folder for the results (default: results/<name of the case file>)");
  run->add_flag("--resume", request->resume,
                "continue an interrupted run from the load points kept in FOLDER.unfinished");
  add_division(*run, request->own, request->merge, "positions of a wheelset");
  add_report_flags(*run, *request);
  run->footer(footer_with_models("rollfem run cases/thesis_a.toml --model halfspace -o /tmp/case_a",
                                 call.models));
  run->callback([request] { app::run(*request); });
}

}  // namespace rollfem::app

#include "app/run.hpp"

#include "app/processes.hpp"
#include "app/progress_display.hpp"
#include "app/run_table.hpp"
#include "app/solving.hpp"
#include "contact/base/errors.hpp"
#include "contact/case/abilities.hpp"
#include "contact/case/case_reader.hpp"
#include "halfspace/model/registry.hpp"
#include "postprocess/write/checkpoint_folder.hpp"
#include "postprocess/write/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>

namespace rollfem::app {

namespace fs = std::filesystem;

namespace {

std::string output_directory(const RunRequest& request) {
  return result_directory(request.case_file, request.directory);
}

/// What would only come out after the hours of computing: a folder that cannot be made, a model
/// that cannot take the case.
void check_before(const RunRequest& request, const contact::Case& input) {
  postprocess::check_directory(output_directory(request));
  if (!input.has_profiles())
    for (const std::string& name : input.models) contact::check_able(input, name);
  const auto runs = [&](const char* model) {
    return std::find(input.models.begin(), input.models.end(), model) != input.models.end();
  };
  if (runs("halfspace") || runs("fem") || request.quiet) return;
  const auto warn = [&](const char* key) {
    std::cerr << fmt::format(
        "warning: {}: {} is computed by the models halfspace and fem, neither of which is run\n",
        input.file, key);
  };
  if (!input.subsurface.empty()) warn("[[subsurface]]");
  if (input.output.stress_maxima.value_or(false)) warn("[output] stress_maxima");
}

/// After a failure: finished work is not lost.
void tell_about(const RunRequest& request, const postprocess::CheckpointFolder* checkpoint) {
  if (checkpoint == nullptr || request.quiet || !checkpoint->holds_records()) return;
  std::cerr << fmt::format(
      "finished load points are kept; the same command with --resume takes "
      "them up: {}\n",
      checkpoint->folder().string());
}

void write_and_tell(const RunRequest& request, const postprocess::RunRecord& record) {
  const fs::path directory = output_directory(request);
  write_whole(directory.string(), record);
  const bool drawn = request.report && report_drawn(directory.string());
  if (request.quiet) return;
  std::cout << record.input.title << "\n\n" << run_table(record.models);
  std::set<std::string> said;  // patches share most notes
  for (const contact::ModelResult& model : record.models)
    for (const std::string& note : model.notes)
      if (said.insert(model.name + note).second) std::cout << '\n' << model.name << ": " << note;
  std::cout << "\n\nresults: " << directory.string() << '\n';
  if (drawn) std::cout << "report:  " << (directory / "report.html").string() << '\n';
}

/// Results that are sound but less than what was asked for are written and are a failure still.
void refuse_shortfall(const postprocess::RunRecord& record) {
  std::string text;
  for (const contact::ModelResult& model : record.models)
    if (!model.shortfall.empty())
      text += fmt::format("{}model {}: {}", text.empty() ? "" : "; ", model.name, model.shortfall);
  if (!text.empty())
    throw contact::SolveError(
        fmt::format("{}: the results are written, but {}", record.input.file, text));
}

}  // namespace

std::vector<std::string> known_models() {
  std::vector<std::string> names = halfspace::model_names();
  names.emplace_back("fem");
  return names;
}

void run(const RunRequest& request) {
  const Processes here = processes();
  postprocess::RunRecord record;
  record.input = contact::read_case(request.case_file);
  const bool named = !request.models.empty();
  if (named) record.input.models = request.models;
  const auto& names = record.input.models;
  const bool parallel = std::find(names.begin(), names.end(), "fem") != names.end();
  if (!here.first() && !parallel) return;
  if (here.first()) check_before(request, record.input);

  record.provenance = provenance_of(request.command, parallel ? here.count : 1);

  std::unique_ptr<FemSession> session;
  if (parallel)
    session = std::make_unique<FemSession>(named ? "--model fem" : request.case_file + ": models",
                                           request.argc, request.argv);
  ProgressDisplay display(request.quiet || !here.first() ? ProgressDisplay::Mode::silent
                                                         : ProgressDisplay::mode_of_stderr());
  const contact::Progress progress = [&](const contact::ProgressEvent& event) {
    display.show(event);
  };
  std::unique_ptr<postprocess::CheckpointFolder> checkpoint;
  try {
    if (here.first())
      checkpoint =
          open_checkpoint(output_directory(request), record.input, request.resume, request.quiet);
    Solving how;
    how.session = session.get();
    how.progress = progress;
    how.checkpoint = checkpoint.get();
    how.first = here.first();
    Solved solved = solve(record.input, how);
    record.models = std::move(solved.results);
    record.pairs = std::move(solved.pairs);
    display.clear();
    if (here.first()) {
      write_and_tell(request, record);
      checkpoint->remove();
      refuse_shortfall(record);
    }
  } catch (...) {
    display.clear();
    tell_about(request, checkpoint.get());
    // Finalising MPI would wait for processes that may not have failed: main leaves without it.
    static_cast<void>(session.release());
    throw;
  }
}

}  // namespace rollfem::app

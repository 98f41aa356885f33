// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `compare`: several models on one or several cases, side by side.
#include "app/frame/command_frame.hpp"
#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "models/program/provenance.hpp"
#include "models/registry.hpp"
#include "models/solving/auto_model.hpp"
#include "models/solving/solving.hpp"
#include "postprocess/compare/comparison.hpp"
#include "postprocess/files/checkpoint_folder.hpp"
#include "postprocess/files/result_folder.hpp"
#include "postprocess/files/seal.hpp"
#include "postprocess/read/results_reader.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>

namespace rollfem::app {

namespace fs = std::filesystem;

namespace {

using postprocess::ComparedCase;
using postprocess::contents_of;

struct CompareRequest : ComputingRequest {
  using ComputingRequest::ComputingRequest;
  std::vector<std::string> case_files;
  std::vector<std::string> models;  ///< empty: the registry's default for `compare`
  std::string reference;            ///< model; empty: the first that solves the elastic problem

  fs::path folder() const {
    if (!directory.empty()) return directory;
    if (case_files.size() > 1) return fs::path("results") / "compare";
    return fs::path("results") / ("compare_" + fs::path(case_files.front()).stem().string());
  }
};

/// A case with its result folder and earlier results.
struct Task {
  contact::Case input;
  std::string name;
  fs::path folder;
  bool done = false;  ///< finished by an earlier call
  /// Models that cannot take the case, according to an earlier call.
  std::vector<postprocess::MissingModel> missing;
};

/// Whether results.h5 is complete and belongs to this case with these models. If not, a warning
/// says why.
bool is_sound(const Task& task, const nlohmann::json& summary) {
  try {
    const postprocess::ResultsFile file(task.folder.string());
    const auto& stored = file.models();
    const auto& named = summary["models"];
    if (file.input().text == task.input.text && stored.size() == named.size() &&
        std::equal(stored.begin(), stored.end(), named.begin(),
                   [](const auto& a, const auto& b) { return a.name == b.value("name", ""); }))
      return true;
    std::cerr << fmt::format(
        "warning: {} does not belong to this case; the case is computed again\n", file.path());
  } catch (const contact::InputError& error) {
    std::cerr << fmt::format("warning: {}; the case is computed again\n", error.what());
  }
  return false;
}

/// Whether the result of an earlier call is valid: same case and files that it reads, program and
/// models, complete and undamaged.
bool is_done(const Task& task) {
  if (contents_of(task.folder / "case.toml") !=
      contact::text_in_folder(task.input, task.folder.string()))
    return false;
  const std::string text = contents_of(task.folder / "summary.json");
  if (!postprocess::json_seal_is_intact(text)) {
    if (!text.empty())
      std::cerr << fmt::format(
          "warning: {} is damaged or was changed: its checksum does not match; the case is "
          "computed again\n",
          (task.folder / "summary.json").string());
    return false;
  }
  const auto summary = nlohmann::json::parse(text, nullptr, false);
  if (!summary.is_object() || !summary.contains("program") ||
      summary.value("case_checksum", "") != postprocess::checksum_of_case(task.input))
    return false;
  if (summary["program"].value("version", "") != modelling::version() ||
      summary["program"].value("commit", "") != modelling::commit())
    return false;
  std::vector<std::string> there;
  for (const auto& model : summary["models"]) there.push_back(model.value("name", ""));
  for (const postprocess::MissingModel& missing : task.missing) there.push_back(missing.model);
  return std::all_of(task.input.models.begin(), task.input.models.end(),
                     [&](const std::string& name) {
                       return std::find(there.begin(), there.end(), name) != there.end();
                     }) &&
         is_sound(task, summary);
}

/// Models that cannot take a case according to compare.json of an earlier call, which is rewritten
/// after every case.
std::vector<postprocess::MissingModel> left_out_before(const nlohmann::json& before,
                                                       const std::string& name) {
  std::vector<postprocess::MissingModel> all;
  if (!before.is_object() || before.value("kind", "") != "compare") return all;
  for (const auto& compared : before["cases"])
    if (compared.value("name", "") == name)
      for (const auto& missing : compared["missing"])
        if (!missing.value("failed", true))
          all.push_back({missing.value("model", ""), missing.value("reason", ""), false});
  return all;
}

std::vector<Task> tasks_of(const CompareRequest& request, const std::vector<std::string>& models) {
  std::vector<Task> tasks;
  std::map<std::string, std::string> names;
  std::string text = contents_of(request.folder() / "compare.json");
  // A file with a wrong checksum is ignored, and the models are tried again.
  if (!postprocess::json_seal_is_intact(text)) text.clear();
  const auto before = nlohmann::json::parse(text, nullptr, false);
  for (const std::string& file : request.case_files) {
    Task task;
    task.input = request.read(file);
    task.input.models = models;
    task.name = fs::path(file).stem().string();
    task.folder = request.folder() / task.name;
    const auto [found, fresh] = names.emplace(task.name, file);
    if (!fresh)
      throw contact::InputError(fmt::format(
          "compare: {} and {} would both be written to {}; do: give one of them another name",
          found->second, file, task.folder.string()));
    task.missing = left_out_before(before, task.name);
    task.done = request.resume && is_done(task);
    tasks.push_back(std::move(task));
  }
  return tasks;
}

/// A message of InputError without its advice, because a skipped model needs no action.
std::string reason_alone(const std::string& message) {
  return message.substr(0, std::min(message.find("; allowed:"), message.find("; do:")));
}

/// Computes one case and writes its folder. Returns the results, or why there are none.
ComparedCase compare_case(CommandFrame& frame, const Task& task, modelling::Solving how) {
  ComparedCase compared = postprocess::compared_case(task.name, task.input);
  if (task.done) {
    if (how.first) postprocess::remove_records(task.folder.string());
    const postprocess::ResultsFile stored(task.folder.string());
    for (const postprocess::StoredModel& model : stored.models())
      compared.models.push_back(stored.read(model));
    compared.models = postprocess::scalars_of(std::move(compared.models));
    compared.missing = task.missing;
    return compared;
  }
  try {
    how.checkpoint = frame.keep_in(task.folder, task.input);
    postprocess::RunRecord record;
    record.input = task.input;
    record.provenance = frame.provenance();
    compared.missing = modelling::solve(record, how);
    bool failed = false;
    for (postprocess::MissingModel& missing : compared.missing) {
      failed = failed || missing.failed;
      if (!missing.failed) missing.reason = reason_alone(missing.reason);
    }
    for (const contact::ModelResult& model : record.models)
      if (!model.shortfall.empty()) compared.missing.push_back({model.name, model.shortfall, true});
    if (record.models.empty() || !how.first) return compared;
    store_results(task.folder.string(), record);
    if (!failed) frame.forget_kept();
    compared.models = postprocess::scalars_of(std::move(record.models));
  } catch (const contact::SolveError& error) {
    if (!how.together && how.session != nullptr) throw;
    compared.missing.push_back({"every model", error.what(), true});
  }
  return compared;
}

void report_and_tell(const CompareRequest& request, const postprocess::ComparisonRecord& record) {
  const fs::path directory = request.folder();
  const bool drawn = report_drawn(request, directory);
  if (request.quiet) return;
  std::cout << postprocess::comparison_text(record);
  tell_where(directory, "compare.html", drawn);
}

/// Why a case has no result although nothing failed: "a: hertz: ...; fastsim: ..."; otherwise
/// empty.
std::string refusal_of(const ComparedCase& compared) {
  const auto failed = [](const postprocess::MissingModel& missing) { return missing.failed; };
  if (!compared.models.empty() ||
      std::any_of(compared.missing.begin(), compared.missing.end(), failed))
    return {};
  std::string text = compared.name;
  for (const postprocess::MissingModel& missing : compared.missing)
    text += fmt::format("{} {}: {}", &missing == &compared.missing.front() ? ":" : ";",
                        missing.model, missing.reason);
  return text;
}

/// Throws if no model can take one of the cases.
void refuse_untaken(const postprocess::ComparisonRecord& record) {
  std::string text;
  for (const ComparedCase& compared : record.cases)
    if (const std::string why = refusal_of(compared); !why.empty())
      text += (text.empty() ? "" : "; ") + why;
  if (!text.empty())
    throw contact::InputError(
        fmt::format("compare: none of the models can solve {}; do: name one with --model that can "
                    "(docs/models.md), or leave the case out",
                    text));
}

/// Throws for failed models at the end, after everything else is written.
void refuse_failures(const postprocess::ComparisonRecord& record) {
  std::string text;
  for (const ComparedCase& compared : record.cases)
    for (const postprocess::MissingModel& missing : compared.missing)
      if (missing.failed)
        text += fmt::format("{}{}, {}: {}", text.empty() ? "" : "; ", compared.name, missing.model,
                            missing.reason);
  if (!text.empty())
    throw contact::SolveError("the comparison was written without the models that failed: " + text);
}

/// The models of the call, otherwise the registry's default for `compare` in this build. The case's
/// own list applies only to `run`.
std::vector<std::string> models_of(const CompareRequest& request) {
  const contact::ModelRegistry& known = request.call.models;
  std::vector<std::string> models =
      request.models.empty()
          ? modelling::built_of(known, known.names(&contact::ModelInfo::in_compare))
          : request.models;
  if (!request.reference.empty() &&
      std::find(models.begin(), models.end(), request.reference) == models.end())
    throw contact::InputError(
        fmt::format("--reference {}: it is not among the models compared; do: add it to --model, "
                    "or choose one of them",
                    request.reference));
  return models;
}

/// In `compare --model hertz CASE CASE` the list option swallows the case files; this moves them
/// back.
void settle(CompareRequest& request) {
  const contact::ModelRegistry& known = request.call.models;
  const auto is_file = [&](const std::string& name) {
    return known.find(name) == nullptr && fs::path(name).extension() == ".toml";
  };
  const auto first = std::find_if(request.models.begin(), request.models.end(), is_file);
  request.case_files.insert(request.case_files.end(), first, request.models.end());
  request.models.erase(first, request.models.end());
  if (request.case_files.empty())
    throw contact::InputError(
        "compare: no case file is named; do: rollfem compare CASE.toml [CASE.toml ...]");
  request.models = modelling::checked_names(known, request.models, "--model");
  modelling::refuse_choice(known, request.models, "compare");
  if (!request.reference.empty()) static_cast<void>(known.at(request.reference, "--reference"));
}

void compare(CompareRequest& request) {
  settle(request);
  const contact::ModelRegistry& known = request.call.models;
  const std::vector<std::string> models = models_of(request);
  const std::vector<Task> tasks = tasks_of(request, models);
  const bool anything =
      std::any_of(tasks.begin(), tasks.end(), [](const Task& t) { return !t.done; });
  CommandFrame frame(request, anything ? models : std::vector<std::string>());
  if (frame.idle()) return;
  if (frame.first())
    for (const Task& task : tasks) warn_of_doubts(task.input);
  // Checks of problems that would otherwise appear only after the computation.
  if (frame.first()) {
    refuse_other_result(request.folder(), "compare.json");
    for (const Task& task : tasks) postprocess::check_directory(task.folder.string());
  }
  frame.own(request.folder());
  for (const Task& task : tasks) frame.own(task.folder);
  postprocess::ComparisonRecord record =
      modelling::begin_comparison(known, request.reference, frame.provenance());
  record.models = models;
  frame.compute("--model", "load points", [&](modelling::Solving how) {
    how.go_on = true;
    for (const Task& task : tasks) {
      record.cases.push_back(compare_case(frame, task, how));
      if (!how.first) continue;
      postprocess::write_together(request.folder(),
                                  {{"compare.json", postprocess::comparison_json(record)},
                                   {"compare.csv", postprocess::comparison_csv(record)}});
      frame.say(fmt::format("compare: {} {}", task.name,
                            task.done                            ? "was already done"
                            : record.cases.back().models.empty() ? "has no result"
                                                                 : "done"));
    }
    if (!how.first) return;
    report_and_tell(request, record);
    refuse_failures(record);
    refuse_untaken(record);
  });
}

}  // namespace

void add_compare(CLI::App& program, Call& call) {
  const auto request = std::make_shared<CompareRequest>(call);
  CLI::App* compare =
      program.add_subcommand("compare", "solve cases with several models and compare the results");
  compare->add_option("case", request->case_files, "case files (.toml), one or more");
  add_model_option(*compare, "-m,--model", request->models, call,
                   "; give several in a row or repeat the option; default: " +
                       contact::listed(call.models.names(&contact::ModelInfo::in_compare)) +
                       ", regardless of the models in the case files");
  compare->add_option(
      "--reference", request->reference,
      "reference model of the comparison; default: " + call.models.reference().name);
  compare->add_option("-o,--output", request->directory,
                      "folder for the comparison (default: results/compare_<name of the case "
                      "file>, results/compare for several)");
  compare->add_flag("--resume", request->resume,
                    "keep the cases that an earlier call finished and solve the others");
  add_report_flags(*compare, *request);
  compare->footer(
      footer_with_models("rollfem compare cases/thesis_*.toml --reference halfspace", call.models));
  compare->callback([request] { app::compare(*request); });
}

}  // namespace rollfem::app

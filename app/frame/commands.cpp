// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/frame/commands.hpp"

#include "app/frame/screen.hpp"
#include "base/errors.hpp"
#include "base/text_fields.hpp"
#include "case/checks/plausibility.hpp"
#include "case/reading/case_reader.hpp"
#include "modelling/frame/parts.hpp"
#include "modelling/program/provenance.hpp"
#include "modelling/registry.hpp"
#include "profiles/profiles.hpp"
#include "result/write/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace rollfem::app {

namespace fs = std::filesystem;

contact::Case CaseRequest::read(const std::string& file) const {
  return contact::read_case(file, modelling::known_names(call.models), changes);
}

fs::path CaseRequest::folder(const std::string& ending) const {
  if (!directory.empty()) return directory;
  return fs::path("results") / (fs::path(case_file).stem().string() + ending);
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto wrong = [words](const std::string& given) -> std::string {
    if (std::find(words.begin(), words.end(), given) != words.end()) return {};
    return fmt::format("{} is not allowed; {}allowed: {}", given,
                       contact::did_you_mean(given, words), contact::listed(words));
  };
  return {wrong, fmt::format("{{{}}}", fmt::join(words, ","))};
}

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

void add_model_option(CLI::App& command, const std::string& names, std::vector<std::string>& models,
                      const Call& call, const std::string& rest) {
  command.add_option(names, models, contact::listed(call.models.names()) + rest)->delimiter(',');
}

void add_quiet_flags(CLI::App& program) {
  for (CLI::App* command : program.get_subcommands(nullptr)) {
    const std::string& name = command->get_name();
    if (command->get_option_no_throw("--quiet") == nullptr && name != "docs" && name != "new-case")
      command->add_flag_callback("-q,--quiet", silence, "print errors and warnings only");
  }
}

void add_threads_option(CLI::App& program, Call& call) {
  const auto use = [&call](int number) { call.threads.emplace(number); };
  for (const char* name :
       {"run", "compare", "study", "bench", "table", "stress", "mesh", "wheelset", "check"})
    program.get_subcommand(name)
        ->add_option_function<int>("--threads", use,
                                   "threads that compute; default: all cores that affinity, "
                                   "control groups and OMP_NUM_THREADS allow. Results are the same "
                                   "for any number")
        ->check(CLI::Range(1, contact::most_threads))
        ->type_name("N");
}

void add_report_flags(CLI::App& command, ComputingRequest& request) {
  add_set_option(command, request.changes);
  command.add_flag("-q,--quiet", request.quiet, "print errors and warnings only");
  command.add_flag_callback(
      "--no-report", [&request] { request.report = false; },
      "write results only, no figures and no report");
}

void add_division(CLI::App& command, contact::RunPart& own, int& merge, const std::string& items) {
  command.add_option_function<std::string>(
      "--part", [&own](const std::string& text) { own = modelling::parse_part(text); },
      "K/N: compute part K of N of the " + items +
          " and store it beside FOLDER; calls for other parts may run at the same time, on any "
          "machine that shares the folder");
  command
      .add_option("--merge", merge,
                  "N: write the result of the N parts computed with --part, or list the missing "
                  "ones; identical to the result of a single call")
      ->check(CLI::Range(2, 1000000));
}

std::string footer_with_models(const std::string& example, const contact::ModelRegistry& models) {
  std::string text = "example: " + example + "\n\nmodels:\n";
  for (const contact::ModelInfo& model : models.all())
    text += fmt::format("  {:<20}{}{}\n", model.name, model.sentence,
                        model.built ? "" : " (not in this build)");
  return text;
}

void warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) std::cerr << "warning: " << warning << '\n';
}

void warn_of_doubts(const contact::Case& input) {
  warn(contact::implausible_values(input));
  warn(profiles::neglected_in_files(input));
}

bool draw(Call& call, const fs::path& written, const std::string& failure) {
  const std::string problem =
      result::make_report(written.string(), modelling::script_directory().string());
  if (problem.empty()) return true;
  std::cerr << "warning: " << failure << ": " << problem << '\n';
  call.undrawn = true;
  return false;
}

void draw_and_print(Call& call, const fs::path& table) {
  const bool drawn = draw(call, table, "the figure was not drawn");
  std::cout << "table:  " << table.string() << '\n';
  if (drawn) std::cout << "figure: " << fs::path(table).replace_extension(".svg").string() << '\n';
}

bool report_drawn(const ComputingRequest& request, const fs::path& directory) {
  return request.report &&
         draw(request.call, directory, "the results were written, but the report was not drawn");
}

void print_where(const fs::path& directory, const char* page, bool drawn) {
  std::cout << "\nresults: " << directory.string() << '\n';
  if (drawn) std::cout << "report:  " << (directory / page).string() << '\n';
}

}  // namespace rollfem::app

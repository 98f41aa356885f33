// SPDX-License-Identifier: LGPL-2.1-or-later
#include "rollfem/rollfem.hpp"

#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"
#include "modelling/frame/in_process.hpp"
#include "modelling/program/provenance.hpp"
#include "modelling/registry.hpp"
#include "modelling/solving/auto_model.hpp"
#include "modelling/solving/solving.hpp"
#include "result/files/result_folder.hpp"
#include "result/write/output.hpp"
#include "result/write/report.hpp"

namespace rollfem {

namespace {

const contact::ModelRegistry& registry() {
  static const contact::ModelRegistry models = modelling::built_in_models();
  return models;
}

}  // namespace

Case read_case(const std::string& file, const std::vector<std::string>& changes) {
  return contact::read_case(file, modelling::known_names(registry()), changes);
}

Case parse_case(const std::string& text, const std::string& name) {
  return contact::parse_case(text, name, modelling::known_names(registry()));
}

std::string describe(const Case& input) {
  return contact::describe(input, modelling::known_names(registry()));
}

std::vector<std::string> models() {
  return modelling::built_of(registry(), registry().names());
}

Result solve(const Case& input, const std::vector<std::string>& models, const Progress& progress,
             std::vector<Missing>* missing) {
  const contact::ModelRegistry& known = registry();
  Result result;
  result.input = input;
  if (!models.empty()) result.input.models = modelling::checked_names(known, models, "models");
  const std::vector<std::string>& names = result.input.models;
  modelling::check_alone(known, names, "models");
  modelling::check_built(known, names, "models");
  result.provenance = modelling::provenance_of(known, "rollfem::solve");
  modelling::InProcess here = modelling::in_process(known, names, progress);
  here.how.go_on = missing != nullptr;
  const std::vector<Missing> unsolved = modelling::solve(result, here.how);
  if (missing != nullptr) missing->insert(missing->end(), unsolved.begin(), unsolved.end());
  return result;
}

Result solve_file(const std::string& file, const std::vector<std::string>& models,
                  const Progress& progress) {
  return solve(read_case(file), models, progress);
}

std::string write(const std::string& folder, const Result& result, bool report) {
  result::check_directory(folder);
  result::write_results(folder, result);
  return report ? result::make_report(folder, modelling::script_directory().string()) : "";
}

std::string figures_directory() {
  return modelling::script_directory().string();
}

std::string version() {
  return modelling::version();
}

}  // namespace rollfem

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "rollfem/rollfem.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "models/fem/fem_library.hpp"
#include "models/program/provenance.hpp"
#include "models/registry.hpp"
#include "models/solving/auto_model.hpp"
#include "models/solving/solving.hpp"
#include "models/study/study_series.hpp"
#include "postprocess/compare/comparison.hpp"
#include "postprocess/files/result_folder.hpp"
#include "postprocess/study/study.hpp"
#include "postprocess/write/record_check.hpp"

namespace rollfem {

namespace {

const contact::ModelRegistry& registry() {
  static const contact::ModelRegistry models = modelling::built_in_models();
  return models;
}

/// How to solve with these models; parallel ones wait for each other while it lives.
struct Ready {
  modelling::Solving how;
  modelling::FemLock one_at_a_time;
};

/// Starts MPI where a model needs it. Throws contact::InputError for a model that is not built.
Ready ready_for(const std::vector<std::string>& models, const contact::Progress& progress) {
  Ready ready;
  ready.how.models = &registry();
  ready.how.progress = progress;
  if (!modelling::any_parallel(registry(), models)) return ready;
  ready.one_at_a_time = modelling::lock_fem();
  ready.how.need_session = [] { modelling::parallel_session("models"); };
  if (!modelling::any_choice(registry(), models)) ready.how.need_session();
  return ready;
}

}  // namespace

Case read_case(const std::string& file) {
  return contact::read_case(file, modelling::model_words(registry()));
}

Case parse_case(const std::string& text, const std::string& name) {
  return contact::parse_case(text, name, modelling::model_words(registry()));
}

std::string describe(const Case& input) {
  return contact::describe(input, modelling::model_words(registry()));
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
  Ready ready = ready_for(names, progress);
  ready.how.go_on = missing != nullptr;
  const std::vector<Missing> unsolved = modelling::solve(result, ready.how);
  if (missing != nullptr) missing->insert(missing->end(), unsolved.begin(), unsolved.end());
  return result;
}

Result solve_file(const std::string& file, const std::vector<std::string>& models,
                  const Progress& progress) {
  return solve(read_case(file), models, progress);
}

std::string write(const std::string& folder, const Result& result, bool report) {
  postprocess::check_directory(folder);
  postprocess::write_results(folder, result);
  return report ? postprocess::make_report(folder, modelling::script_directory().string()) : "";
}

std::string figures_directory() {
  return modelling::script_directory().string();
}

Files study(const Case& input, const StudyOptions& options, const Progress& progress) {
  const contact::ModelRegistry& known = registry();
  const bool any = options.models.empty() || options.models.front() == "all";
  const modelling::StudyWishes wishes{
      any ? options.models : modelling::checked_names(known, options.models, "models"),
      options.vary, options.together, options.levels, options.references};
  const std::vector<std::string> named = modelling::named_models(wishes, known);
  modelling::check_wishes(wishes, input, known);
  const modelling::Scenes scenes =
      modelling::scenes_of(input, modelling::placed_wheels(input), progress);
  const std::vector<std::string> models = modelling::models_of(wishes, scenes, known);
  const Ready ready = ready_for(named, progress);
  postprocess::StudyRecord record = modelling::begin_study(
      wishes, input, scenes, modelling::provenance_of(known, "rollfem::study"));
  Files found;
  modelling::StudyRun run;
  run.how = ready.how;
  run.notes = scenes.notes;
  run.say = [](const std::string&) {};
  modelling::solve_levels(wishes, models, scenes, run, record);
  if (const std::string failures = modelling::finish_study(scenes, ready.how, record);
      !failures.empty())
    found.warnings.push_back("levels that failed: " + failures);
  found.contents = {{"study.json", postprocess::study_json(record)},
                    {"study.csv", postprocess::study_csv(record)}};
  found.text = postprocess::study_table(record);
  return found;
}

Files compare(const std::vector<Compared>& cases, const std::string& reference) {
  const contact::ModelRegistry& known = registry();
  postprocess::ComparisonRecord record;
  record.provenance = modelling::provenance_of(known, "rollfem::compare");
  record.reference = reference;
  record.references = known.names(&contact::ModelInfo::measures_others);
  record.references.insert(record.references.begin(), reference);
  Files found;
  std::vector<postprocess::CaseStandings> standings;
  for (const Compared& one : cases) {
    postprocess::ComparedCase compared;
    compared.name = one.name;
    compared.case_file = one.result.input.file;
    compared.title = one.result.input.title;
    compared.friction = one.result.input.friction_coefficient;
    record.models = one.result.input.models;
    compared.missing = one.missing;
    if (!one.result.models.empty()) {
      postprocess::check_record(one.result);
      compared.models = postprocess::scalars_of(one.result.models);
    }
    standings.push_back(postprocess::case_standings(compared, record.references));
    found.text += compared.name + ": " + compared.title + '\n' +
                  postprocess::comparison_table(standings.back()) + '\n';
    record.cases.push_back(std::move(compared));
  }
  found.text += postprocess::comparison_verdict(standings);
  found.contents = {{"compare.json", postprocess::comparison_json(record)},
                    {"compare.csv", postprocess::comparison_csv(record)}};
  return found;
}

std::string version() {
  return modelling::version();
}

}  // namespace rollfem

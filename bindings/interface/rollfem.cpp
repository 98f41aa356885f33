// SPDX-License-Identifier: LGPL-2.1-or-later
#include "rollfem/rollfem.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "models/fem/fem_library.hpp"
#include "models/program/provenance.hpp"
#include "models/registry.hpp"
#include "models/solving/auto_model.hpp"
#include "models/solving/solving.hpp"
#include "models/study/study.hpp"
#include "postprocess/compare/comparison.hpp"
#include "postprocess/files/result_folder.hpp"
#include "postprocess/study/study.hpp"
#include "postprocess/write/output.hpp"

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
  modelling::Study made(wishes, input, known, modelling::provenance_of(known, "rollfem::study"),
                        progress);
  const Ready ready = ready_for(named, progress);
  made.solve({ready.how});
  Files found;
  if (const std::string failures = made.finish(); !failures.empty())
    found.warnings.push_back("levels that failed: " + failures);
  found.contents = {{"study.json", postprocess::study_json(made.record())},
                    {"study.csv", postprocess::study_csv(made.record())}};
  found.text = postprocess::study_table(made.record());
  return found;
}

Files compare(const std::vector<Compared>& cases, const std::string& reference) {
  postprocess::ComparisonRecord record = modelling::begin_comparison(
      registry(), reference, modelling::provenance_of(registry(), "rollfem::compare"));
  for (const Compared& one : cases) {
    postprocess::ComparedCase& compared =
        record.cases.emplace_back(postprocess::compared_case(one.name, one.result.input));
    record.models = one.result.input.models;
    compared.missing = one.missing;
    if (!one.result.models.empty()) {
      postprocess::check_record(one.result);
      compared.models = postprocess::scalars_of(one.result.models);
    }
  }
  Files found;
  found.text = postprocess::comparison_text(record);
  found.contents = {{"compare.json", postprocess::comparison_json(record)},
                    {"compare.csv", postprocess::comparison_csv(record)}};
  return found;
}

std::string version() {
  return modelling::version();
}

}  // namespace rollfem

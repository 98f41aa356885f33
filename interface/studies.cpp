// SPDX-License-Identifier: LGPL-2.1-or-later
// Comparisons and refinement studies as values.
#include "contact/base/errors.hpp"
#include "interface/session.hpp"
#include "models/program/provenance.hpp"
#include "models/registry.hpp"
#include "models/study/study_series.hpp"
#include "postprocess/compare/comparison.hpp"
#include "postprocess/study/study.hpp"
#include "postprocess/write/record_check.hpp"

#include "rollfem/rollfem.hpp"

namespace rollfem {

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

}  // namespace rollfem

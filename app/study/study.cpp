// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/study/study.hpp"

#include "app/frame/parts.hpp"
#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "models/registry.hpp"
#include "models/study/study_series.hpp"
#include "postprocess/files/files_together.hpp"

#include <filesystem>
#include <iostream>

namespace rollfem::app {

namespace fs = std::filesystem;

namespace {

fs::path directory_of(const StudyRequest& request) {
  if (!request.directory.empty()) return request.directory;
  return fs::path("results") / (fs::path(request.case_file).stem().string() + "_study");
}

modelling::StudyWishes wishes_of(const StudyRequest& request) {
  return {request.models, request.vary, request.together, request.levels, request.references};
}

void write_and_tell(const StudyRequest& request, const postprocess::StudyRecord& record) {
  const std::string directory = directory_of(request).string();
  postprocess::FilesTogether files(directory);
  files.write("study.json", postprocess::study_json(record));
  files.write("study.csv", postprocess::study_csv(record));
  files.commit();
  const bool drawn = report_drawn(request, directory);
  if (request.quiet) return;
  std::cout << record.title << "\n\n" << postprocess::study_table(record);
  for (const std::string& note : record.notes) std::cout << '\n' << note << '\n';
  std::cout << "\nresults: " << directory << '\n';
  if (drawn) std::cout << "report:  " << directory << "/study.html\n";
}

void study_at_once(const StudyRequest& request, const contact::ModelRegistry& known) {
  const contact::Case input =
      contact::read_case(request.case_file, modelling::model_words(known), request.changes);
  const modelling::StudyWishes wishes = wishes_of(request);
  CommandFrame frame(request, known, modelling::named_models(wishes, known));
  if (frame.idle()) return;
  if (frame.first()) warn_of_doubts(input);
  modelling::check_wishes(wishes, input, known);
  refuse_other_result(directory_of(request), "study.json");
  static_cast<void>(postprocess::FilesTogether(directory_of(request)));
  frame.own(directory_of(request));
  const modelling::Scenes scenes =
      modelling::scenes_of(input, modelling::placed_wheels(input), frame.progress());
  const std::vector<std::string> models = modelling::models_of(wishes, scenes, known);
  postprocess::StudyRecord record =
      modelling::begin_study(wishes, input, scenes, frame.provenance());
  frame.compute("--model", "levels", [&](const modelling::Solving& how) {
    modelling::StudyRun run;
    run.how = how;
    run.how.share = request.share;
    run.notes = scenes.notes;
    run.say = [&](const std::string& text) { frame.say("study: " + text); };
    run.kept = frame.keep_in(directory_of(request), input);
    modelling::solve_levels(wishes, models, scenes, run, record);
    frame.clear_line();
    if (!how.first || frame.ends_part()) return;
    const std::string failures = modelling::finish_study(scenes, how, record);
    write_and_tell(request, record);
    if (!failures.empty())
      throw contact::SolveError("the study was written without the levels that failed: " +
                                failures);
    frame.forget_kept();
  });
}

}  // namespace

void study(StudyRequest request, const contact::ModelRegistry& known) {
  check_division(request, 2, "");  // a study has several levels
  const bool divisible =
      !modelling::any_parallel(known, modelling::named_models(wishes_of(request), known));
  in_parts(request, divisible, directory_of(request), [&] { study_at_once(request, known); });
}

}  // namespace rollfem::app

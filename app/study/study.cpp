// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `study`: one case on successively finer grids, cells, degrees or domains; with
// profiles every patch, at loads and creepages determined once and then fixed.
#include "models/study/study.hpp"

#include "app/frame/command_frame.hpp"
#include "app/frame/parts.hpp"
#include "contact/base/errors.hpp"
#include "models/registry.hpp"
#include "models/solving/auto_model.hpp"
#include "postprocess/files/files_together.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>

namespace rollfem::app {

namespace fs = std::filesystem;

namespace {

struct StudyRequest : ComputingRequest {
  using ComputingRequest::ComputingRequest;
  modelling::StudyWishes wishes;
  fs::path folder() const { return CaseRequest::folder("_study"); }
};

void write_and_tell(const StudyRequest& request, const postprocess::StudyRecord& record) {
  const fs::path directory = request.folder();
  postprocess::write_together(directory, {{"study.json", postprocess::study_json(record)},
                                          {"study.csv", postprocess::study_csv(record)}});
  const bool drawn = report_drawn(request, directory);
  if (request.quiet) return;
  std::cout << record.title << "\n\n" << postprocess::study_table(record);
  for (const std::string& note : record.notes) std::cout << '\n' << note << '\n';
  tell_where(directory, "study.html", drawn);
}

void study_at_once(const StudyRequest& request) {
  const contact::ModelRegistry& known = request.call.models;
  const contact::Case input = request.read();
  const modelling::StudyWishes& wishes = request.wishes;
  CommandFrame frame(request, modelling::named_models(wishes, known));
  if (frame.idle()) return;
  if (frame.first()) warn_of_doubts(input);
  modelling::check_wishes(wishes, input, known);
  refuse_other_result(request.folder(), "study.json");
  static_cast<void>(postprocess::FilesTogether(request.folder()));
  frame.own(request.folder());
  modelling::Study study(wishes, input, known, frame.provenance(), frame.progress());
  frame.compute("--model", "levels", [&](modelling::Solving how) {
    how.share = request.share;
    study.solve({how, frame.keep_in(request.folder(), input),
                 [&](const std::string& text) { frame.say("study: " + text); }});
    frame.clear_line();
    if (!how.first || frame.ends_part()) return;
    const std::string failures = study.finish();
    write_and_tell(request, study.record());
    if (!failures.empty())
      throw contact::SolveError("the study was written without the levels that failed: " +
                                failures);
    frame.forget_kept();
  });
}

/// "all" must stand alone.
void settle(StudyRequest& request) {
  modelling::StudyWishes& wishes = request.wishes;
  settle_case_file(request, "study", {&wishes.models, &wishes.vary, &wishes.references},
                   [](const std::string& name) { return fs::path(name).extension() == ".toml"; });
  if (wishes.all()) return;
  const contact::ModelRegistry& known = request.call.models;
  wishes.models = modelling::checked_names(known, wishes.models, "--model");
  modelling::refuse_choice(known, wishes.models, "study");
}

void study(StudyRequest& request) {
  settle(request);
  check_division(request, 2, "");  // a study has several levels
  const contact::ModelRegistry& known = request.call.models;
  const bool divisible =
      !modelling::any_parallel(known, modelling::named_models(request.wishes, known));
  in_parts(request, divisible, request.folder(), [&] { study_at_once(request); });
}

/// "grid (of carter, fastsim), cell (of fem)"
std::string refinement_help(const contact::ModelRegistry& models) {
  std::vector<std::string> ways;
  for (const std::string& word : modelling::varied_words(models))
    ways.push_back(fmt::format("{} (of {})", word,
                               contact::listed(modelling::models_that_vary(models, word))));
  return contact::listed(ways);
}

}  // namespace

void add_study(CLI::App& program, Call& call) {
  const auto request = std::make_shared<StudyRequest>(call);
  modelling::StudyWishes& wishes = request->wishes;
  CLI::App* study = program.add_subcommand(
      "study", "solve a case on ever finer grids: errors, observed orders, cost");
  study->add_option("case", request->case_file, "case file (.toml)");
  add_model_option(*study, "-m,--model,--models", wishes.models, call,
                   ", or all; default: " + call.models.reference().name);
  study
      ->add_option("--vary", wishes.vary,
                   "what to refine: " + refinement_help(call.models) +
                       "; give several in a row (default: the first one of each model)")
      ->delimiter(',');
  study->add_flag("--together", wishes.together,
                  "refine everything in --vary together (default: one at a time)");
  study->add_option("--levels", wishes.levels,
                    "number of levels, 2 to 8 (default: 5 grids, from a quarter of the case's "
                    "elements to four times as many; 3 cell sizes, from four times the case's to "
                    "the case's; 3 domains, from half to twice the case's)");
  study
      ->add_option("--reference", wishes.references,
                   "reference of the errors: exact (Hertz), finest, extrapolated, or numbers such "
                   "as max_pressure=578.967 traction_coefficient:4=0.3722 (with several patches "
                   "left_1_2.max_pressure=1010); default: exact where an exact "
                   "value exists, otherwise extrapolated")
      ->delimiter(',');
  study->add_option("-o,--output", request->directory,
                    "folder for the study (default: results/<name of the case file>_study)");
  study->add_flag("--resume", request->resume,
                  "continue an interrupted study from the levels kept in FOLDER.unfinished");
  add_division(*study, *request, "levels");
  add_report_flags(*study, *request);
  study->footer(footer_with_models("rollfem study cases/thesis_a.toml --models all", call.models));
  study->callback([request] { app::study(*request); });
}

}  // namespace rollfem::app

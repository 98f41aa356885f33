#include "app/study.hpp"

#include "app/processes.hpp"
#include "app/progress_display.hpp"
#include "app/run.hpp"
#include "app/solving.hpp"
#include "app/study_levels.hpp"
#include "contact/abilities.hpp"
#include "contact/case_reader.hpp"
#include "contact/errors.hpp"
#include "halfspace/registry.hpp"
#include "postprocess/result_folder.hpp"
#include "postprocess/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace rollfem::app {

namespace fs = std::filesystem;

namespace {

using contact::InputError;
using postprocess::ReferenceRule;
using postprocess::StudySeries;
using postprocess::StudyValues;

fs::path directory_of(const StudyRequest& request) {
  if (!request.directory.empty()) return request.directory;
  return fs::path("results") / (fs::path(request.case_file).stem().string() + "_study");
}

StudyValues values_of(const contact::ModelResult& result) {
  StudyValues values;
  if (result.points.empty()) return values;
  const contact::PointResult& first = result.points.front();
  const auto put = [&](const char* name, double value) {
    if (value != 0.0) values[name] = value;  // 0: the model does not give it
  };
  put("max_pressure", first.max_pressure);
  put("semi_axis_x", first.semi_axis_x);
  put("semi_axis_y", first.semi_axis_y);
  put("approach", first.approach);
  const bool friction =
      std::any_of(result.points.begin(), result.points.end(),
                  [](const contact::PointResult& point) { return point.max_traction > 0.0; });
  for (std::size_t k = 0; friction && k < result.points.size(); ++k)
    if (result.points[k].max_traction > 0.0)
      values[fmt::format("traction_coefficient:{}", k + 1)] = result.points[k].traction_coefficient;
  return values;
}

/// Hertz's values where the case is one that they are exact for.
StudyValues exact_values(const contact::Case& input) {
  try {
    StudyValues values = values_of(halfspace::run_model("hertz", input, {}));
    return values;
  } catch (const InputError&) {
    return {};
  }
}

const char* const allowed_references =
    "allowed: exact, finest, extrapolated, or QUANTITY=VALUE with max_pressure, semi_axis_x, "
    "semi_axis_y, approach or traction_coefficient:N of load point N";

void read_references(const StudyRequest& request, std::size_t points,
                     postprocess::StudyRecord& record) {
  for (const std::string& word : request.references) {
    const auto refuse = [&](const std::string& why) {
      throw InputError(
          fmt::format("--reference {}: {}; {}; do: correct it", word, why, allowed_references));
    };
    if (word == "exact") {
      record.rule = ReferenceRule::exact;
      if (record.exact.empty()) refuse("no exact value is known for this case");
    } else if (word == "finest") {
      record.rule = ReferenceRule::finest;
    } else if (word == "extrapolated") {
      record.rule = ReferenceRule::extrapolated;
    } else {
      const std::size_t at = word.find('=');
      if (at == std::string::npos) refuse("not a reference");
      const std::string key = word.substr(0, at);
      bool known = key == "max_pressure" || key == "semi_axis_x" || key == "semi_axis_y" ||
                   key == "approach";
      for (std::size_t k = 1; k <= points; ++k)
        known = known || key == fmt::format("traction_coefficient:{}", k);
      if (!known) refuse("no such quantity in this case");
      char* end = nullptr;
      const double value = std::strtod(word.c_str() + at + 1, &end);
      if (end == word.c_str() + at + 1 || *end != '\0' || !std::isfinite(value))
        refuse("the value is not a number");
      record.given[key] = value;
    }
  }
}

/// The models of the study, and of those that cannot take the case a line on stderr with "all".
std::vector<std::string> models_of(const StudyRequest& request, const contact::Case& input) {
  if (request.models.empty()) return {"halfspace"};
  if (request.models.front() != "all") {
    for (const std::string& name : request.models) contact::check_able(input, name);
    return request.models;
  }
  std::vector<std::string> able;
  for (const std::string& name : known_models()) try {
#if !ROLLFEM_WITH_FEM
      if (name == "fem") continue;
#endif
      contact::check_able(input, name);
      able.push_back(name);
    } catch (const InputError&) {  // "all" means all that can
    }
  return able;
}

void check_call(const StudyRequest& request, const contact::Case& input,
                const std::vector<std::string>& models) {
  if (input.has_profiles())
    throw InputError(fmt::format(
        "{}: study: a case with profiles has several patches, which a study does not take; do: "
        "study a case with radii",
        input.file));
  for (const std::string& word : request.vary) {
    const auto& known = varied_words();
    if (std::find(known.begin(), known.end(), word) == known.end())
      throw InputError(fmt::format(
          "--vary {}: not something to refine; allowed: grid, cell, degree, domain; do: name one "
          "of them",
          word));
    const bool any = std::any_of(models.begin(), models.end(),
                                 [&](const std::string& model) { return can_vary(model, word); });
    if (!any)
      throw InputError(fmt::format(
          "--vary {}: none of the models of this study has it; allowed: grid of halfspace, "
          "fastsim, strip and carter, cell, degree and domain of fem; do: add --model fem, or vary "
          "grid",
          word));
  }
  if (request.levels != 0 && (request.levels < 2 || request.levels > 8))
    throw InputError(fmt::format("--levels {}: allowed: 2 to 8; do: correct it", request.levels));
  for (const char* other : {"summary.json", "compare.json"})
    if (fs::exists(directory_of(request) / other))
      throw InputError(fmt::format(
          "study: {} holds the result of another command ({}); do: name another folder with -o",
          directory_of(request).string(), other));
}

StudySeries run_series(const LevelPlan& plan, const Solving& how, ProgressDisplay& display,
                       bool quiet) {
  StudySeries series;
  series.model = plan.model;
  series.vary = plan.vary;
  series.parameter = plan.parameter;
  series.ratio = plan.ratio;
  for (const LevelPlan::Level& level : plan.levels) {
    try {
      const Solved solved = solve(level.input, how);
      if (solved.results.empty()) continue;
      const contact::ModelResult& result = solved.results.front();
      const auto total = result.seconds.find("total");
      series.levels.push_back(
          {level.label, level.parameter, result.unknowns, result.contact_elements,
           total == result.seconds.end() ? 0.0 : total->second, values_of(result)});
    } catch (const std::exception& error) {
      const bool input_error = dynamic_cast<const InputError*>(&error) != nullptr;
      if (!how.together || (!input_error && !dynamic_cast<const contact::SolveError*>(&error)))
        throw;
      series.failure = error.what();
      break;
    }
    display.clear();
    if (how.first && !quiet)
      std::cerr << fmt::format("study: {} {}: {:.2g} s\n", plan.model, level.label,
                               series.levels.back().seconds);
  }
  return series;
}

void write_and_tell(const StudyRequest& request, const postprocess::StudyRecord& record) {
  const fs::path directory = directory_of(request);
  std::error_code error;
  fs::create_directories(directory, error);
  postprocess::replace_file(directory / "study.json", postprocess::study_json(record));
  postprocess::replace_file(directory / "study.csv", postprocess::study_csv(record));
  const bool drawn = request.report && report_drawn(directory.string());
  if (request.quiet) return;
  std::cout << record.title << "\n\n" << postprocess::study_table(record);
  std::cout << "\nresults: " << directory.string() << '\n';
  if (drawn) std::cout << "report:  " << (directory / "study.html").string() << '\n';
}

/// Theories that cannot take a case say so when they run: with "all" they are left out.
bool only_unable(const StudyRequest& request, const StudySeries& series) {
  return series.levels.empty() && !request.models.empty() && request.models.front() == "all";
}

}  // namespace

void study(const StudyRequest& request) {
  const Processes here = processes();
  const contact::Case input = contact::read_case(request.case_file);
  const std::vector<std::string> models = models_of(request, input);
  const bool parallel = std::find(models.begin(), models.end(), "fem") != models.end();
  if (!here.first() && !parallel) return;
  check_call(request, input, models);
  postprocess::StudyRecord record;
  record.title = input.title;
  record.case_file = input.file;
  record.case_text = input.text;
  record.friction = input.friction_coefficient;
  record.creepages = input.rolling.creepages;
  record.exact = exact_values(input);
  read_references(request, input.rolling.creepages.size(), record);
  record.provenance = provenance_of(request.command, parallel ? here.count : 1);
  std::vector<LevelPlan> plans;
  for (const std::string& model : models)
    for (LevelPlan& plan :
         level_plans(input, model, request.vary, request.together, request.levels))
      plans.push_back(std::move(plan));

  std::unique_ptr<FemSession> session;
  if (parallel) session = std::make_unique<FemSession>("--model fem", request.argc, request.argv);
  ProgressDisplay display(request.quiet || !here.first() ? ProgressDisplay::Mode::silent
                                                         : ProgressDisplay::mode_of_stderr());
  Solving how;
  how.session = session.get();
  how.progress = [&](const contact::ProgressEvent& event) { display.show(event); };
  how.first = here.first();
  how.together = here.count == 1;
  try {
    for (const LevelPlan& plan : plans) {
      StudySeries series = run_series(plan, how, display, request.quiet);
      if (only_unable(request, series)) {
        if (here.first() && !request.quiet)
          std::cerr << fmt::format("study: {} is left out: {}\n", plan.model, series.failure);
        continue;
      }
      record.series.push_back(std::move(series));
    }
    display.clear();
    if (!here.first()) return;
    std::string failures;
    bool any = false;
    for (const StudySeries& series : record.series) {
      any = any || !series.levels.empty();
      if (!series.failure.empty())
        failures += fmt::format("{}{}", failures.empty() ? "" : "; ", series.failure);
    }
    if (!any) throw contact::SolveError(failures);
    write_and_tell(request, record);
    if (!failures.empty())
      throw contact::SolveError("the study is written without what failed: " + failures);
  } catch (...) {
    display.clear();
    // As in run: finalising MPI would wait for processes that may not have failed.
    static_cast<void>(session.release());
    throw;
  }
}

}  // namespace rollfem::app

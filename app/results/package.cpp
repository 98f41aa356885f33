// SPDX-License-Identifier: LGPL-2.1-or-later
// The commands `study`, `compare`, `bench` and `stress`, which the Python package carries out
// (postprocess/rollfem/commands): here are their options, for help, manual page and completion.
#include "app/frame/commands.hpp"
#include "base/errors.hpp"
#include "base/threads.hpp"
#include "modelling/frame/waiting.hpp"
#include "modelling/program/provenance.hpp"
#include "modelling/registry.hpp"
#include "result/write/report.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>

namespace rollfem::app {

namespace {

/// Where CLI11 puts the options of a command.
struct Handed {
  std::map<std::string, std::vector<std::string>> words;
  std::map<std::string, std::string> text;
  std::map<std::string, std::vector<int>> numbers;
  std::map<std::string, std::vector<double>> values;
  std::map<std::string, int> number;
  std::map<std::string, double> value;
  std::map<std::string, bool> flag;
  contact::RunPart own;
};

/// {"model": ["hertz", "halfspace"], "quiet": ["true"], ...}: the options that the call has.
std::string given_of(const CLI::App& command, const Call& call) {
  nlohmann::json given{{"command", call.command}, {"threads", contact::threads()}};
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0 && option->get_single_name() != "threads")
      given[option->get_single_name()] = option->results();
  return given.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// The package has the built-in models only.
void refuse_own_models(const CLI::App& command, const contact::ModelRegistry& models) {
  const contact::ModelRegistry known = modelling::built_in_models();
  for (const std::string& name : models.names())
    if (known.find(name) == nullptr)
      throw contact::InputError(
          command.get_name() +
          ": the Python package, which carries it out, does not have the model " + name +
          " of this program; allowed: run; do: run the models one by one, "
          "or add the model to the built-in ones");
}

/// Runs the command in the package: this process becomes Python.
[[noreturn]] void hand_over(const CLI::App& command, const Call& call) {
  // Before numpy starts a thread a core.
  ::setenv("OPENBLAS_NUM_THREADS", "1", 0);
  if (modelling::processes().count > 1)
    ::setenv("LD_PRELOAD", modelling::library_that_waits().c_str(), 0);
  std::cout.flush();
  throw contact::InputError(command.get_name() + ": " +
                            result::become_package({command.get_name(), given_of(command, call)},
                                                   modelling::script_directory().string()));
}

/// Ends the declaration of a command: the last options, and what it does.
void finish(CLI::App& command, const Call& call, const std::shared_ptr<Handed>& handed) {
  command.add_flag("-q,--quiet", handed->flag["quiet"], "print errors and warnings only");
  command.callback([&command, &call, handed] {
    refuse_own_models(command, call.models);
    hand_over(command, call);
  });
}

/// Adds the options of the commands that write a folder with a report.
void add_folder(CLI::App& command, Handed& handed, const std::string& folder,
                const std::string& resume) {
  command.add_option("-o,--output", handed.text["output"], folder);
  command.add_flag("--resume", handed.flag["resume"], resume);
  add_set_option(command, handed.words["set"]);
  command.add_flag("--no-report", handed.flag["no-report"],
                   "write results only, no figures and no report");
}

/// "grid (of carter, fastsim), cell (of fem)"
std::string refinement_help(const contact::ModelRegistry& models) {
  std::vector<std::string> ways;
  for (const contact::ModelInfo& model : models.all())
    for (const contact::Refinement& way : model.refinements) {
      std::vector<std::string> names;
      for (const contact::ModelInfo& other : models.all())
        for (const contact::Refinement& same : other.refinements)
          if (same.word == way.word || same.also == way.word) names.push_back(other.name);
      std::string text = way.word + " (of " + contact::listed(names) + ")";
      if (std::find(ways.begin(), ways.end(), text) == ways.end()) ways.push_back(std::move(text));
    }
  return contact::listed(ways);
}

}  // namespace

void add_compare(CLI::App& program, Call& call) {
  const auto handed = std::make_shared<Handed>();
  CLI::App* compare =
      program.add_subcommand("compare", "solve cases with several models and compare the results");
  compare->add_option("case", handed->words["case"], "case files (.toml), one or more");
  add_model_option(*compare, "-m,--model", handed->words["model"], call,
                   "; give several in a row or repeat the option; default: " +
                       contact::listed(call.models.names(&contact::ModelInfo::in_compare)) +
                       ", regardless of the models in the case files");
  compare->add_option(
      "--reference", handed->text["reference"],
      "reference model of the comparison; default: " + call.models.reference().name);
  add_folder(*compare, *handed,
             "folder for the comparison (default: results/compare_<name of the case file>, "
             "results/compare for several)",
             "keep the cases that an earlier call finished and solve the others");
  finish(*compare, call, handed);
  compare->footer(
      footer_with_models("rollfem compare cases/thesis_*.toml --reference halfspace", call.models));
}

void add_study(CLI::App& program, Call& call) {
  const auto handed = std::make_shared<Handed>();
  CLI::App* study = program.add_subcommand(
      "study", "solve a case on ever finer grids: errors, observed orders, cost");
  study->add_option("case", handed->text["case"], "case file (.toml)");
  add_model_option(*study, "-m,--model,--models", handed->words["model"], call,
                   ", or all; default: " + call.models.reference().name);
  study
      ->add_option("--vary", handed->words["vary"],
                   "what to refine: " + refinement_help(call.models) +
                       "; give several in a row (default: the first one of each model)")
      ->delimiter(',');
  study->add_flag("--together", handed->flag["together"],
                  "refine everything in --vary together (default: one at a time)");
  study
      ->add_option(
          "--quantity", handed->words["quantity"],
          "quantities to follow in addition: scalars of a load point (docs/results.md), or "
          "max_MEASURE_BODY such as max_von_mises_rail; give several in a row")
      ->delimiter(',');
  study->add_option("--levels", handed->number["levels"],
                    "number of levels, 2 to 8 (default: 5 grids, from a quarter of the case's "
                    "elements to four times as many; 3 cell sizes, from four times the case's to "
                    "the case's; 3 domains, from half to twice the case's)");
  study
      ->add_option(
          "--reference", handed->words["reference"],
          "reference of the errors: exact (Hertz), finest, extrapolated, or numbers such "
          "as max_pressure=578.967 traction_coefficient:4=0.3722 (with several patches "
          "left_1_2.max_pressure=1010); default: exact where an exact "
          "value exists, otherwise extrapolated, or a finer level where the levels show no limit")
      ->delimiter(',');
  study->add_option("--reference-seconds", handed->value["reference-seconds"],
                    "solve this finer level only if it is expected to take no longer than this "
                    "(default: 60; 0: never)");
  add_folder(*study, *handed,
             "folder for the study (default: results/<name of the case file>_study)",
             "continue an interrupted study from the levels kept in FOLDER.unfinished");
  add_division(*study, handed->own, handed->number["merge"], "levels");
  finish(*study, call, handed);
  study->footer(footer_with_models("rollfem study cases/thesis_a.toml --models all", call.models));
}

void add_bench(CLI::App& program, Call& call) {
  const auto handed = std::make_shared<Handed>();
  CLI::App* bench = program.add_subcommand(
      "bench",
      "measure error and run time of each model on this machine, in cases with known solutions");
  bench->add_flag("--quick", handed->flag["quick"], "one case on coarse grids, about a second");
  bench->add_flag("--json", handed->flag["json"], "print one JSON object and nothing else");
  finish(*bench, call, handed);
  bench->footer("example: rollfem bench");
}

void add_stress(CLI::App& program, Call& call) {
  const auto handed = std::make_shared<Handed>();
  CLI::App* stress = program.add_subcommand(
      "stress",
      "stress and displacement at points, on lines and on planes from stored results, without "
      "solving again; largest stresses; shakedown map");
  stress
      ->add_option("result", handed->text["result"],
                   "result folder of rollfem run, or its results.h5")
      ->required();
  stress
      ->add_option("-m,--model", handed->words["model"],
                   "models of the result, separated by commas; default: " +
                       contact::listed(call.models.names(&contact::ModelInfo::has_stress)) +
                       ", if present")
      ->delimiter(',')
      ->allow_extra_args(false);
  stress->add_option("--patch", handed->text["patch"],
                     "with profiles: SIDE,POSITION,PATCH, e.g. left,1,1; default: the first");
  stress
      ->add_option("--point", handed->numbers["point"],
                   "load points, counted from 1, separated by commas; default: the last")
      ->delimiter(',')
      ->allow_extra_args(false);
  stress
      ->add_option("--creepage", handed->values["creepage"],
                   "load points with these longitudinal creepages, separated by commas")
      ->delimiter(',')
      ->allow_extra_args(false);
  stress->add_option(
      "--places", handed->text["places"],
      "TOML file with [[subsurface.point]], .line, .plane and .surface, as in a case file");
  stress->add_flag("--depth-profile", handed->flag["depth-profile"],
                   "add vertical lines below the centre of the patch and below the most loaded "
                   "element; the default when no points are requested");
  stress->add_option("--depth", handed->value["depth"],
                     "depth of these lines in mm; default: three times the smaller semi-axis");
  stress->add_option("--yield-shear-stress", handed->value["yield-shear-stress"],
                     "shear yield stress k in MPa, for the shakedown map");
  stress->add_option("--yield-strength", handed->value["yield-strength"],
                     "yield strength in MPa, instead of k (k = strength / sqrt(3))");
  stress->add_option("-o,--output", handed->text["output"],
                     "folder for stress.csv, stress.json and figures; default: the name of the "
                     "result folder with _stress");
  add_json_flag(*stress, handed->flag["json"]);
  stress->add_flag("--no-figures", handed->flag["no-figures"], "write the tables only");
  stress->footer(
      "example: rollfem stress results/thesis_a --yield-strength 520 --places places.toml\n"
      "x along rolling, y lateral, z into the wheel: z > 0 in the wheel, z < 0 in the rail.");
  stress->callback([stress, handed, &call] { hand_over(*stress, call); });
}

}  // namespace rollfem::app

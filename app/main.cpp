// The command-line program: reads the call, hands over to the command, and turns every failure
// into one line on stderr and an exit status (0 done, 1 the solution failed, 2 input or call
// wrong).
#include "app/compare.hpp"
#include "app/mesh.hpp"
#include "app/processes.hpp"
#include "app/profile.hpp"
#include "app/run.hpp"
#include "app/scenes.hpp"
#include "app/stress.hpp"
#include "app/study.hpp"
#include "app/version.hpp"
#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "contact/result/quantities.hpp"
#include "contact/scene/what_follows.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <thread>

namespace {

using namespace rollfem;

struct Call {
  app::RunRequest run;
  app::CompareRequest compare;
  app::StudyRequest study;
  app::MeshRequest mesh;
  app::StressRequest stress;
  app::ProfileRequest profile;
  std::string check_file;
  std::string new_case_file;
  std::string page;
};

std::string joined(int argc, char** argv) {
  std::string text;
  for (int i = 0; i < argc; ++i) text += (i > 0 ? " " : "") + std::string(argv[i]);
  return text;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// CLI11 would only say that a command is missing.
void check_command(const CLI::App& program, int argc, char** argv) {
  const std::string allowed =
      "allowed: run, compare, study, stress, mesh, profile, check, new-case, docs; do: rollfem "
      "--help";
  if (argc < 2) throw contact::InputError("no command is given; " + allowed);
  const std::string name = argv[1];
  if (name.empty() || name.front() == '-') return;
  const auto is_named = [&](const CLI::App* command) { return command->check_name(name); };
  if (program.get_subcommands(is_named).empty())
    throw contact::InputError(fmt::format("{}: there is no such command; {}", name, allowed));
}

bool is_model(const std::string& name) {
  const std::vector<std::string> known = app::known_models();
  return std::find(known.begin(), known.end(), name) != known.end();
}

[[noreturn]] void no_such_model(const std::string& option, const std::string& name) {
  throw contact::InputError(
      fmt::format("{} {}: there is no such model; allowed: {}; do: name one of them", option, name,
                  listed(app::known_models())));
}

/// Every name once, in order; throws for one that is no model.
std::vector<std::string> checked_models(const std::vector<std::string>& names) {
  std::vector<std::string> once;
  for (const std::string& name : names) {
    if (!is_model(name)) no_such_model("--model", name);
    if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
  }
  return once;
}

/// `run --model hertz CASE`: a list option also takes the case file, which is given back here.
void settle_run(app::RunRequest& request) {
  if (request.case_file.empty() && !request.models.empty() && !is_model(request.models.back())) {
    request.case_file = request.models.back();
    request.models.pop_back();
  }
  if (request.case_file.empty())
    throw contact::InputError("run: no case file is named; do: rollfem run CASE.toml");
  request.models = checked_models(request.models);
}

/// The same where several case files may follow the models.
void settle_compare(app::CompareRequest& request) {
  const auto is_file = [](const std::string& name) {
    return !is_model(name) && std::filesystem::path(name).extension() == ".toml";
  };
  const auto first = std::find_if(request.models.begin(), request.models.end(), is_file);
  request.case_files.insert(request.case_files.end(), first, request.models.end());
  request.models.erase(first, request.models.end());
  if (request.case_files.empty())
    throw contact::InputError(
        "compare: no case file is named; do: rollfem compare CASE.toml [CASE.toml ...]");
  request.models = checked_models(request.models);
  if (!request.reference.empty() && !is_model(request.reference))
    no_such_model("--reference", request.reference);
}

/// `study --models all CASE`: as settle_run, and "all" stands alone.
void settle_study(app::StudyRequest& request) {
  for (std::vector<std::string>* list : {&request.models, &request.vary, &request.references})
    if (request.case_file.empty() && !list->empty() &&
        std::filesystem::path(list->back()).extension() == ".toml") {
      request.case_file = list->back();
      list->pop_back();
    }
  if (request.case_file.empty())
    throw contact::InputError("study: no case file is named; do: rollfem study CASE.toml");
  if (request.models != std::vector<std::string>{"all"})
    request.models = checked_models(request.models);
}

void new_case(const std::string& file) {
  if (file.empty()) {
    std::cout << contact::case_template();
    return;
  }
  if (std::filesystem::exists(file))
    throw contact::InputError(
        fmt::format("new-case: {} is there already; do: name another file", file));
  std::ofstream stream(file);
  stream << contact::case_template();
  stream.close();
  if (!stream)
    throw contact::InputError(
        fmt::format("new-case: {} cannot be written; do: name another file", file));
}

void check_case(const std::string& file) {
  const contact::Case input = contact::read_case(file);
  std::cout << contact::describe(input) << contact::what_follows(input);
  if (input.has_profiles())
    std::cout << "\nwhere wheel and rail touch\n"
              << app::contacts_text(input, meshes::search_scene_of(input));
}

void add_stress(CLI::App& program, Call& call) {
  app::StressRequest& request = call.stress;
  CLI::App* stress = program.add_subcommand(
      "stress",
      "stress and displacement at places, on lines and on planes from stored results, without "
      "solving again; the largest stresses; the shakedown map");
  stress->add_option("result", request.result, "result folder of rollfem run, or its results.h5")
      ->required();
  stress
      ->add_option("-m,--model", request.models,
                   "models of the result, separated by commas; without it halfspace and fem, "
                   "whichever are there")
      ->delimiter(',')
      ->allow_extra_args(false);
  stress->add_option("--patch", request.patch,
                     "with profiles: SIDE,POSITION,PATCH, as left,1,1; without it the first");
  stress->add_option("--point", request.point, "load point, from 0; without it the last one");
  stress->add_option("--creepage", request.creepage, "load point of this longitudinal creepage");
  stress->add_option("--at", request.places, "x,y,z in mm: a place; may be repeated")
      ->allow_extra_args(false);
  stress
      ->add_option("--line", request.lines,
                   "x,y,z:x,y,z[:n]: n points from one place to the other; may be repeated")
      ->allow_extra_args(false);
  stress
      ->add_option("--plane", request.planes,
                   "x,y,z:x,y,z:x,y,z[:n,m]: n by m points of the parallelogram whose sides go "
                   "from the first place to the other two; may be repeated")
      ->allow_extra_args(false);
  stress->add_option("--body", request.body, "wheel or rail; without it by the sign of z")
      ->check(CLI::IsMember({"wheel", "rail"}));
  stress->add_flag("--depth-profile", request.depth_profile,
                   "also lines down under the centre of the patch and under the most loaded "
                   "element; drawn when no places are asked for");
  stress->add_option("--depth", request.depth,
                     "mm, how deep these go; without it three times the smaller semi-axis");
  stress->add_option("--yield-shear-stress", request.yield_shear_stress,
                     "k in MPa, for the shakedown map");
  stress->add_option("--yield-strength", request.yield_strength,
                     "in MPa, in place of k, which is this over sqrt(3)");
  stress->add_option("-o,--output", request.directory,
                     "folder for stress.csv, stress.json and figures; without it the result "
                     "folder's name with _stress");
  stress->add_flag("-q,--quiet", request.quiet, "print errors and warnings only");
  stress->add_flag("!--no-figures", request.figures, "write the tables only");
  stress->footer(
      "example: rollfem stress results/thesis_a --yield-strength 520 --line 0,0,0:0,0,-12:61\n"
      "x along rolling, y lateral, z into the wheel: z > 0 in the wheel, z < 0 in the rail.");
  stress->callback([&request] { app::stress(request); });
}

/// The flags that run, compare and study share.
template <class Request>
void add_report_flags(CLI::App& command, Request& request) {
  command.add_flag("-q,--quiet", request.quiet, "print errors and warnings only");
  command.add_flag("!--no-report", request.report, "write results only, no figures and no report");
}

void add_run(CLI::App& program, Call& call) {
  CLI::App* run = program.add_subcommand("run", "compute a case with one or more models");
  run->add_option("case", call.run.case_file, "case file (.toml)");
  run->add_option(
         "-m,--model", call.run.models,
         listed(app::known_models()) +
             "; several in a row or with the option repeated; without it the models of the "
             "case file")
      ->delimiter(',');
  run->add_option("-o,--output", call.run.directory,
                  "folder for the results; without it results/<name of the case file>");
  run->add_flag(
      "--resume", call.run.resume,
      "go on with a run that was ended: its finished load points are in FOLDER.unfinished "
      "beside the results");
  add_report_flags(*run, call.run);
  run->footer("example: rollfem run cases/thesis_a.toml --model halfspace -o /tmp/case_a");
  run->callback([&call] {
    settle_run(call.run);
    app::run(call.run);
  });
}

void add_compare(CLI::App& program, Call& call) {
  CLI::App* compare = program.add_subcommand(
      "compare", "compute cases with several models and lay the results beside each other");
  compare->add_option("case", call.compare.case_files, "case files (.toml), one or more");
  compare
      ->add_option("-m,--model", call.compare.models,
                   listed(app::known_models()) +
                       "; several in a row or with the option repeated; without it hertz, fastsim, "
                       "strip, halfspace and fem, whatever models the case files name")
      ->delimiter(',');
  compare->add_option("--reference", call.compare.reference,
                      "the model that the others are compared with; without it halfspace");
  compare->add_option("-o,--output", call.compare.directory,
                      "folder for the comparison; without it results/compare_<name of the case "
                      "file>, results/compare for several");
  compare->add_flag("--resume", call.compare.resume,
                    "keep the cases that an earlier call finished and go on with the others");
  add_report_flags(*compare, call.compare);
  compare->footer("example: rollfem compare cases/thesis_*.toml --reference halfspace");
  compare->callback([&call] {
    settle_compare(call.compare);
    app::compare(call.compare);
  });
}

void add_study(CLI::App& program, Call& call) {
  CLI::App* study = program.add_subcommand(
      "study", "compute a case on ever finer grids: errors, observed orders, cost");
  study->add_option("case", call.study.case_file, "case file (.toml)");
  study
      ->add_option("-m,--model,--models", call.study.models,
                   listed(app::known_models()) + ", or all; without it halfspace")
      ->delimiter(',');
  study
      ->add_option(
          "--vary", call.study.vary,
          "what is refined: grid (contact grid, strips), cell (of the finite elements and "
          "the contact grid with them), degree, domain; several in a row; without it grid, "
          "in finite elements cell")
      ->delimiter(',');
  study->add_flag("--together", call.study.together,
                  "refine all of --vary at once; without it one at a time");
  study->add_option(
      "--levels", call.study.levels,
      "how many levels, 2 to 8; without it 5 grids (a fourth of the case's elements "
      "to four times as many), 3 cells (four times the case's to the case's), 3 domains "
      "(half to twice the case's)");
  study
      ->add_option("--reference", call.study.references,
                   "what errors are measured against: exact (Hertz), finest, extrapolated, or "
                   "numbers such as max_pressure=578.967 traction_coefficient:4=0.3722 (of one of "
                   "several patches left_1_2.max_pressure=1010); without it exact where there is "
                   "such a value, else extrapolated")
      ->delimiter(',');
  study->add_option("-o,--output", call.study.directory,
                    "folder for the study; without it results/<name of the case file>_study");
  study->add_flag("--resume", call.study.resume,
                  "go on with a study that was ended: its finished levels are in FOLDER.unfinished "
                  "beside the results");
  add_report_flags(*study, call.study);
  study->footer("example: rollfem study cases/thesis_a.toml --models all");
  study->callback([&call] {
    settle_study(call.study);
    app::study(call.study);
  });
}

void add_commands(CLI::App& program, Call& call) {
  program.set_version_flag("--version",
                           fmt::format("rollfem {} ({})", app::version(), app::commit()));
  program.require_subcommand(1);

  add_run(program, call);
  add_compare(program, call);
  add_study(program, call);
  add_stress(program, call);

  CLI::App* mesh = program.add_subcommand(
      "mesh", "write the finite-element meshes of a case and print their quality");
  mesh->add_option("case", call.mesh.case_file, "case file (.toml)")->required();
  mesh->add_option("-o,--output", call.mesh.directory,
                   "folder for wheel.msh, rail.msh, wheel.vtu, rail.vtu (with profiles "
                   "left_1_1_wheel.msh and so on, for every patch); without it "
                   "results/<name of the case file>_mesh");
  mesh->footer("example: rollfem mesh cases/thesis_a.toml");
  mesh->callback([&call] { app::mesh(call.mesh); });

  CLI::App* profile = program.add_subcommand(
      "profile", "print, write and draw a profile of wheel or rail with its curvature");
  profile
      ->add_option("name", call.profile.name,
                   "a built-in profile, a profile file, or a case file (.toml) with profiles")
      ->required();
  profile->add_flag("--wheel", call.profile.wheel, "the file is the profile of a wheel");
  profile->add_flag("--rail", call.profile.rail, "the file is the profile of a rail");
  profile->add_option("-o,--output", call.profile.directory,
                      "folder for the table (.csv) and the figure (.svg); without it "
                      "results/<name>_profile");
  profile->footer("example: rollfem profile S1002 -o /tmp/profile");
  profile->callback([&call] { app::profile(call.profile); });

  CLI::App* check = program.add_subcommand("check", "read a case and print what was understood");
  check->add_option("case", call.check_file, "case file (.toml)")->required();
  check->footer("example: rollfem check cases/s1002_uic60_left.toml");
  check->callback([&call] { check_case(call.check_file); });

  CLI::App* fresh = program.add_subcommand("new-case", "print a commented case file");
  fresh->add_option("-o,--output", call.new_case_file, "write it to this new file instead");
  fresh->footer("example: rollfem new-case -o my_case.toml");
  fresh->callback([&call] { new_case(call.new_case_file); });

  CLI::App* docs = program.add_subcommand("docs", "print a generated page of the documentation");
  docs->add_option("page", call.page, "case-file, or quantities: the table in docs/results.md")
      ->required()
      ->check(CLI::IsMember({"case-file", "quantities"}));
  docs->footer("example: rollfem docs case-file > docs/case-file.md");
  docs->callback([&call] {
    std::cout << (call.page == "quantities" ? contact::quantities_markdown()
                                            : contact::case_reference_markdown());
  });
}

int execute(int argc, char** argv) {
  Call call;
  call.run.command = call.compare.command = call.study.command = joined(argc, argv);
  call.run.argc = call.compare.argc = call.study.argc = call.mesh.argc = argc;
  call.run.argv = call.compare.argv = call.study.argv = call.mesh.argv = argv;
  CLI::App program(
      "rollfem: steady rolling contact of wheel and rail by finite elements and by "
      "half-space elements",
      "rollfem");
  add_commands(program, call);
  check_command(program, argc, argv);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);
    throw contact::InputError(fmt::format("{}; do: rollfem --help", error.what()));
  }
  std::cout.flush();
  if (!std::cout) throw contact::InputError("the output cannot be written (is the disk full?)");
  return 0;
}

/// Process 0 speaks; the others let it, and only if it is not about to (it would have ended this
/// process through mpirun by then) say what happened here.
int failed(int status, const std::string& what) {
  const app::Processes here = app::processes();
  if (!here.first()) std::this_thread::sleep_for(std::chrono::seconds(3));
  const std::string where = here.first() ? "" : fmt::format("process {}: ", here.rank);
  std::cerr << fmt::format("rollfem: {}{}\n", where, what);
  app::leave(status);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return execute(argc, argv);
  } catch (const contact::InputError& error) {
    return failed(2, error.what());
  } catch (const contact::SolveError& error) {
    return failed(1, error.what());
  } catch (const std::bad_alloc&) {
    return failed(1, "out of memory; do: take fewer or larger elements, or more processes");
  } catch (const std::exception& error) {
    return failed(1, fmt::format("internal error: {}", error.what()));
  }
}

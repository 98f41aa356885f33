// The command-line program: reads the call, hands over to the command, and turns every failure
// into one line on stderr and an exit status (0 done, 1 the solution failed, 2 input or call
// wrong).
#include "app/mesh.hpp"
#include "app/processes.hpp"
#include "app/profile.hpp"
#include "app/run.hpp"
#include "app/scenes.hpp"
#include "app/stress.hpp"
#include "app/version.hpp"
#include "contact/case_reader.hpp"
#include "contact/errors.hpp"

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
      "allowed: run, stress, mesh, profile, check, new-case, docs; do: rollfem --help";
  if (argc < 2) throw contact::InputError("no command is given; " + allowed);
  const std::string name = argv[1];
  if (name.empty() || name.front() == '-') return;
  const auto is_named = [&](const CLI::App* command) { return command->check_name(name); };
  if (program.get_subcommands(is_named).empty())
    throw contact::InputError(fmt::format("{}: there is no such command; {}", name, allowed));
}

/// `run --model hertz CASE`: a list option also takes the case file, which is given back here.
void settle_run(app::RunRequest& request) {
  const std::vector<std::string> known = app::known_models();
  const auto is_known = [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  if (request.case_file.empty() && !request.models.empty() && !is_known(request.models.back())) {
    request.case_file = request.models.back();
    request.models.pop_back();
  }
  if (request.case_file.empty())
    throw contact::InputError("run: no case file is named; do: rollfem run CASE.toml");
  std::vector<std::string> once;
  for (const std::string& name : request.models) {
    if (!is_known(name))
      throw contact::InputError(
          fmt::format("--model {}: there is no such model; allowed: {}; do: name one of them", name,
                      listed(known)));
    if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
  }
  request.models = once;
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
  std::cout << contact::describe(input);
  if (input.has_profiles())
    std::cout << "\nwhere wheel and rail touch\n" << app::contacts_text(input);
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
  stress->add_option("--point", request.point,
                     "load point, from 0; without it the last one, the only one of fem");
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

void add_commands(CLI::App& program, Call& call) {
  program.set_version_flag("--version",
                           fmt::format("rollfem {} ({})", app::version(), app::commit()));
  program.require_subcommand(1);

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
  run->add_flag("-q,--quiet", call.run.quiet, "print errors and warnings only");
  run->add_flag("!--no-report", call.run.report, "write results only, no figures and no report");
  run->callback([&call] {
    settle_run(call.run);
    app::run(call.run);
  });

  add_stress(program, call);

  CLI::App* mesh = program.add_subcommand(
      "mesh", "write the finite-element meshes of a case and print their quality");
  mesh->add_option("case", call.mesh.case_file, "case file (.toml)")->required();
  mesh->add_option("-o,--output", call.mesh.directory,
                   "folder for wheel.msh, rail.msh, wheel.vtu, rail.vtu (with profiles "
                   "left_1_1_wheel.msh and so on, for every patch); without it "
                   "results/<name of the case file>_mesh");
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
  profile->callback([&call] { app::profile(call.profile); });

  CLI::App* check = program.add_subcommand("check", "read a case and print what was understood");
  check->add_option("case", call.check_file, "case file (.toml)")->required();
  check->callback([&call] { check_case(call.check_file); });

  CLI::App* fresh = program.add_subcommand("new-case", "print a commented case file");
  fresh->add_option("-o,--output", call.new_case_file, "write it to this new file instead");
  fresh->callback([&call] { new_case(call.new_case_file); });

  CLI::App* docs = program.add_subcommand("docs", "print a generated page of the documentation");
  docs->add_option("page", call.page, "case-file")->required()->check(CLI::IsMember({"case-file"}));
  docs->callback([] { std::cout << contact::case_reference_markdown(); });
}

int execute(int argc, char** argv) {
  Call call;
  call.run.command = joined(argc, argv);
  call.run.argc = call.mesh.argc = argc;
  call.run.argv = call.mesh.argv = argv;
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

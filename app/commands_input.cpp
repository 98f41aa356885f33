// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/commands.hpp"
#include "app/frame/command_frame.hpp"
#include "app/frame/shell_words.hpp"
#include "app/run/cache.hpp"
#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "contact/result/quantities.hpp"
#include "models/program/provenance.hpp"
#include "models/program/version.hpp"
#include "models/registry.hpp"
#include "postprocess/files/files_together.hpp"
#include "postprocess/write/case_schema.hpp"
#include "postprocess/write/output.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>

namespace rollfem::app {

namespace {

void new_case(const std::string& file, const contact::ModelRegistry& models) {
  if (file.empty()) {
    std::cout << contact::case_template(modelling::model_words(models));
    return;
  }
  if (std::filesystem::exists(file))
    throw contact::InputError(
        fmt::format("new-case: {} already exists; do: name another file", file));
  postprocess::write_file(file, contact::case_template(modelling::model_words(models)));
}

void draw_report(const std::string& directory) {
  const auto holds = [&](const char* file) {
    return std::filesystem::exists(std::filesystem::path(directory) / file);
  };
  if (!holds("results.h5") && !holds("compare.json") && !holds("study.json") && !holds("table.h5"))
    throw contact::InputError(
        fmt::format("report: {} holds no result; do: name a folder that rollfem run, compare, "
                    "study or table wrote",
                    directory));
  const std::string problem =
      postprocess::make_report(directory, modelling::script_directory().string());
  if (!problem.empty()) throw contact::InputError("report: " + problem);
}

std::string page_text(const std::string& page, const CLI::App& program,
                      const contact::ModelRegistry& models) {
  if (page == "bash") return bash_completion(program, models);
  if (page == "zsh") return zsh_completion(program, models);
  if (page == "man") return manual_page(program, modelling::version());
  if (page == "schema") return postprocess::case_schema(modelling::model_words(models));
  if (page == "models") return modelling::models_markdown(models);
  if (page == "quantities") return contact::quantities_markdown();
  return contact::case_reference_markdown(modelling::model_words(models));
}

void add_convert_command(CLI::App& program, Call& call) {
  CLI::App* convert = program.add_subcommand(
      "convert", "convert a CONTACT input file (modules 1 and 3) to case files");
  convert->add_option("file", call.convert.file, "input file (.inp)")->required();
  convert->add_option("-o,--output", call.convert.directory,
                      "folder for the case files (default: <name of the file>_cases)");
  convert->add_option("--cases", call.convert.cases,
                      "convert only these cases: numbers and ranges, e.g. 1-5,8 (default: all)");
  convert->add_flag("--partial", call.convert.partial,
                    "skip cases whose physics has no equivalent (default: an error)");
  convert->footer(
      "example: rollfem convert cattaneo.inp\nHow every digit and sign is converted: "
      "docs/coming_from_contact.md");
  convert->callback([&call] { app::convert(call.convert, call.models); });
}

/// mesh, profile, wheelset
void add_geometry_commands(CLI::App& program, Call& call) {
  CLI::App* mesh = program.add_subcommand(
      "mesh", "write the finite-element meshes of a case and print their quality");
  mesh->add_option("case", call.mesh.case_file, "case file (.toml)")->required();
  mesh->add_option(
      "-o,--output", call.mesh.directory,
      "folder for wheel.msh, rail.msh, wheel.vtu, rail.vtu, with profiles left_1_1_wheel.msh and "
      "so on for each patch (default: results/<name of the case file>_mesh)");
  add_set_option(*mesh, call.mesh.changes);
  mesh->footer("example: rollfem mesh cases/thesis_a.toml");
  mesh->callback([&call] { app::mesh(call.mesh, call.models); });

  CLI::App* profile = program.add_subcommand(
      "profile", "print, write and draw a profile of wheel or rail with its curvature");
  profile
      ->add_option("name", call.profile.name,
                   "a built-in profile, a profile file, or a case file (.toml) with profiles")
      ->required();
  profile->add_flag("--wheel", call.profile.wheel, "the file is the profile of a wheel");
  profile->add_flag("--rail", call.profile.rail, "the file is the profile of a rail");
  profile->add_option(
      "-o,--output", call.profile.directory,
      "folder for the table (.csv) and the figure (.svg) (default: results/<name>_profile)");
  add_json_flag(*profile, call.profile.json);
  profile->footer("example: rollfem profile S1002 -o /tmp/profile");
  profile->callback([&call] { app::profile(call.profile, call.undrawn); });

  CLI::App* wheelset = program.add_subcommand(
      "wheelset",
      "rolling radii, contact angles and equivalent conicity of a wheelset over its lateral shift");
  wheelset->add_option("case", call.wheelset.case_file, "case file (.toml) with profiles")
      ->required();
  wheelset->add_option("--reach", call.wheelset.reach, "largest shift in mm (default: 10)");
  wheelset->add_option("-o,--output", call.wheelset.directory,
                       "folder for the table (.csv) and the figure (.svg) (default: results/<name "
                       "of the case file>_wheelset)");
  add_json_flag(*wheelset, call.wheelset.json);
  add_set_option(*wheelset, call.wheelset.changes);
  wheelset->footer("example: rollfem wheelset cases/manchester_A22.toml");
  wheelset->callback([&call] { app::wheelset(call.wheelset, call.models, call.undrawn); });
}

}  // namespace

void add_input_commands(CLI::App& program, Call& call) {
  add_geometry_commands(program, call);

  CLI::App* check =
      program.add_subcommand("check", "check a case file and print how rollfem interprets it");
  check->add_option("case", call.check.case_file, "case file (.toml)")->required();
  add_json_flag(*check, call.check.json);
  add_set_option(*check, call.check.changes);
  check->footer("example: rollfem check cases/s1002_uic60_left.toml");
  check->callback([&call] { check_case(call.check, call.models); });

  CLI::App* fresh = program.add_subcommand("new-case", "print a commented case file");
  fresh->add_option("-o,--output", call.new_case_file, "write it to this new file instead");
  fresh->footer("example: rollfem new-case -o my_case.toml");
  fresh->callback([&call] { new_case(call.new_case_file, call.models); });

  add_convert_command(program, call);

  CLI::App* report =
      program.add_subcommand("report", "draw or redraw figures and report of a stored result");
  report
      ->add_option("result", call.drawn_directory,
                   "folder of a run, a comparison, a study or a table")
      ->required();
  report->footer("example: rollfem report results/thesis_a");
  report->callback([&call] { draw_report(call.drawn_directory); });

  CLI::App* stored =
      program.add_subcommand("cache",
                             "list or clear the corrections that the model hybrid stores for later "
                             "runs on the same bodies, in $ROLLFEM_CACHE or ~/.cache/rollfem");
  stored->add_option("action", call.cache_action, "list (default) or clear")
      ->check(CLI::IsMember({"list", "clear"}));
  stored->footer("example: rollfem cache clear\nAn empty ROLLFEM_CACHE switches the cache off.");
  stored->callback([&call] { app::cache(call.cache_action); });

  CLI::App* docs = program.add_subcommand("docs", "print a generated page of the documentation");
  docs->add_option("page", call.page,
                   "case-file, models; quantities: the table in docs/results.md; schema: JSON "
                   "schema of case files, for completion and checks in editors; bash, zsh: shell "
                   "completion; man: the manual page")
      ->required()
      ->check(CLI::IsMember({"case-file", "models", "quantities", "schema", "bash", "zsh", "man"}));
  docs->footer("example: rollfem docs case-file > docs/case-file.md");
  docs->callback([&call, &program] { std::cout << page_text(call.page, program, call.models); });
}

}  // namespace rollfem::app

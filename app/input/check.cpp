// SPDX-License-Identifier: LGPL-2.1-or-later
// The commands `check`, how a case is read and which models take it, and `new-case`.
#include "app/frame/commands.hpp"
#include "app/frame/screen.hpp"
#include "base/errors.hpp"
#include "case/checks/plausibility.hpp"
#include "case/reading/case_reader.hpp"
#include "modelling/registry.hpp"
#include "modelling/solving/auto_model.hpp"
#include "modelling/solving/case_scenes.hpp"
#include "profiles/profiles.hpp"
#include "result/files/files_together.hpp"
#include "result/write/json_head.hpp"
#include "scene/scene.hpp"
#include "theories/theory_models.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>

namespace rollfem::app {

namespace {

using Json = nlohmann::ordered_json;

using Scenes = std::vector<contact::Scene>;

/// The first reason against the model in one of the scenes; empty if it takes them all.
std::string reason_against(const contact::ModelInfo& model, const Scenes& scenes) {
  for (const contact::Scene& scene : scenes)
    if (const auto reason = model.cannot(scene)) return *reason;
  return {};
}

/// Which models can take the case: their names in one line, and the reason against each other one;
/// or a line each.
std::string taken_by(const Scenes& scenes, const contact::ModelRegistry& models, bool lines) {
  if (!lines) {
    std::string names;
    std::vector<std::pair<std::string, std::string>> others;  // reason, names
    for (const contact::ModelInfo& model : models.all()) {
      const std::string reason = reason_against(model, scenes);
      const auto same = std::find_if(others.begin(), others.end(),
                                     [&](const auto& other) { return other.first == reason; });
      std::string& list = reason.empty()         ? names
                          : same == others.end() ? others.emplace_back(reason, "").second
                                                 : same->second;
      list += (list.empty() ? "" : ", ") + model.name;
    }
    std::string text = "models that take it: " + names + '\n';
    for (const auto& [reason, list] : others) text += fmt::format("  not {}: {}\n", list, reason);
    return text;
  }
  std::string text = "which models take it\n";
  for (const contact::ModelInfo& model : models.all()) {
    const std::string reason = reason_against(model, scenes);
    text +=
        fmt::format("  {:<22} {}\n", model.name, reason.empty() ? model.sentence : "no: " + reason);
  }
  return text;
}

/// Fills `scenes`, those of a wheelset before its balance, and returns what a run of the case
/// refuses before it solves anything.
std::vector<std::string> refusals_of(const contact::Case& input,
                                     const contact::ModelRegistry& models,
                                     const modelling::Placed& placed, Scenes& scenes) {
  std::vector<std::string> refusals;
  const auto try_to = [&](const std::function<void()>& step) {
    const auto done = contact::attempt([&] { return step(), true; });
    if (!done) refusals.push_back(done.why);
  };
  try_to([&] { modelling::check_alone(models, input.models, input.file + ": models"); });
  try_to([&] {
    scenes = modelling::unbalanced_scenes(input, placed ? placed : modelling::placed_wheels(input));
  });
  for (const std::string& name : input.models)
    try_to([&] {
      for (const contact::Scene& scene : scenes) models.check(scene, name);
    });
  return refusals;
}

/// Doubtful values, and reasons to refuse or doubt a result as far as the closed form shows them.
std::vector<std::string> warnings_of(const contact::Case& input) {
  std::vector<std::string> warnings = contact::implausible_values(input);
  if (input.has_profiles()) {
    for (const bool wheel : {true, false}) {
      profiles::ProfileReport report;
      static_cast<void>(profiles::profile_of_case(input, wheel, &report));
      if (!report.neglected.empty()) warnings.push_back(report.neglected);
      const std::string advice = profiles::scatter_advice(report, wheel);
      if (advice.empty()) continue;
      warnings.push_back(fmt::format(
          "{}: {}.profile = \"{}\": its points scatter by {:.2g} mm, of which the pressure feels "
          "waves; do: {}",
          input.file, wheel ? "wheel" : "rail",
          (wheel ? input.wheel.profile : input.rail.profile).name, report.smoothing->scatter,
          advice));
    }
    return warnings;
  }
  try {
    for (const contact::Note& note : theories::models().run("hertz", input, {}).notes)
      if (note.severity == contact::Note::warning) warnings.push_back(note.text);
  } catch (const contact::SolveError& error) {
    warnings.push_back(fmt::format("{}: {}", input.file, error.what()));
  } catch (const contact::InputError&) {
    // No ellipse: the models report problems when they run.
  }
  return warnings;
}

Json case_json(const contact::Case& input, const std::vector<std::string>& warnings,
               const Scenes& scenes, const contact::ModelRegistry& models) {
  Json json = result_head("check");
  json["case_file"] = input.file;
  json["keys"] = result::json_of(result::keys_tree(input), true);
  json["warnings"] = warnings;
  for (const contact::ModelInfo& model : models.all())
    if (!scenes.empty()) json["cannot"][model.name] = reason_against(model, scenes);
  json["contacts"] = Json::array();
  for (const contact::Scene& scene : scenes)
    if (scene.place) json["contacts"].push_back({{"place", result::place_json(*scene.place)}});
  return json;
}

struct CheckRequest : CaseRequest {
  using CaseRequest::CaseRequest;
  bool json = false;
  bool all = false;
};

/// The first lines of a table, unless all are asked for.
std::string shortened(const std::string& text, bool all) {
  constexpr std::ptrdiff_t most = 8;
  const std::ptrdiff_t lines = std::count(text.begin(), text.end(), '\n');
  if (all || lines <= most) return text;
  std::size_t end = 0;
  for (std::ptrdiff_t k = 0; k < most; ++k) end = text.find('\n', end) + 1;
  return text.substr(0, end) + fmt::format("... and {} more rows (--all)\n", lines - most);
}

/// Prints the case and warns of doubtful values; solves nothing.
void check_case(const CheckRequest& request) {
  const contact::ModelRegistry& models = request.call.models;
  const contact::Case input = request.read();
  std::cout << contact::describe(input, modelling::known_names(models), request.all)
            << (request.all ? contact::derived_values(input) : "");
  std::vector<std::string> warnings = warnings_of(input);
  modelling::Placed placed;
  if (input.has_profiles() && !request.json) {
    placed = modelling::placed_wheels(input);
    std::cout << "\nwhere wheel and rail touch\n"
              << shortened(modelling::contacts_text(input, placed->search), request.all) << '\n';
  }
  Scenes scenes;
  for (std::string& refusal : refusals_of(input, models, placed, scenes))
    warnings.push_back(std::move(refusal));
  warn(warnings);
  if (request.json) {
    print_result(case_json(input, warnings, scenes, models).dump(1));
    return;
  }
  if (!scenes.empty()) std::cout << taken_by(scenes, models, request.all);
}

void new_case(const std::string& file, const contact::ModelRegistry& models) {
  if (file.empty()) {
    std::cout << contact::case_template(modelling::known_names(models));
    return;
  }
  if (std::filesystem::exists(file))
    throw contact::InputError(
        fmt::format("new-case: {} already exists; do: name another file", file));
  result::write_file(file, contact::case_template(modelling::known_names(models)));
}

}  // namespace

void add_check(CLI::App& program, Call& call) {
  const auto request = std::make_shared<CheckRequest>(call);
  CLI::App* check =
      program.add_subcommand("check", "check a case file and print how rollfem interprets it");
  check->add_option("case", request->case_file, "case file (.toml)")->required();
  check->add_flag("--all", request->all,
                  "every key with its default, the values that follow, and a line for each model");
  add_json_flag(*check, request->json);
  add_set_option(*check, request->changes);
  check->footer("example: rollfem check cases/s1002_uic60_left.toml");
  check->callback([request] { check_case(*request); });
}

void add_new_case(CLI::App& program, Call& call) {
  const auto file = std::make_shared<std::string>();
  CLI::App* fresh = program.add_subcommand("new-case", "print a commented case file");
  fresh->add_option("-o,--output", *file, "write it to this new file instead");
  fresh->footer("example: rollfem new-case -o my_case.toml");
  fresh->callback([file, &call] { new_case(*file, call.models); });
}

}  // namespace rollfem::app

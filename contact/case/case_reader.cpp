// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/case_reader.hpp"

#include "contact/base/text_fields.hpp"
#include "contact/case/checks/case_checks.hpp"
#include "contact/case/lattice.hpp"
#include "contact/case/toml/toml_reader.hpp"
#include "contact/case/toml/toml_source.hpp"

#include <filesystem>
#include <stdexcept>

namespace rollfem::contact {

namespace {

constexpr std::size_t largest_file = 1 << 20;

void set_values(Case& input, const std::map<const Key*, GivenValue>& values) {
  for (const Key& key : case_keys()) {
    const auto found = values.find(&key);
    if (found != values.end()) key.set(input, found->second.value);
  }
}

/// Reads the files named in the case; their paths are relative to the case file.
void read_files(const GivenCase& given, Case& input) {
  const std::filesystem::path folder = std::filesystem::path(given.file).parent_path();
  const auto fill = [&](std::optional<Lattice>& values, int columns) {
    if (values) values = read_lattice((folder / values->file).string(), values->file, columns);
  };
  fill(input.undeformed_distance.values, 1);
  fill(input.rolling.extra_slip_values, 2);
  for (auto* steel : {&input.wheel.plasticity, &input.rail.plasticity})
    if (*steel && !(*steel)->residual.file.empty()) {
      auto& residual = (*steel)->residual;
      residual = read_residual_stress((folder / residual.file).string(), residual.file);
    }
  // Meshes are read when the bodies are built; missing files are reported at once.
  for (const char* body : {"wheel", "rail"}) {
    const GivenValue* mesh = given.find(body, "mesh");
    std::error_code error;
    if (mesh == nullptr ||
        std::filesystem::is_regular_file(folder / std::get<std::string>(mesh->value), error))
      continue;
    fail_at(given, std::string(body) + ".mesh", *mesh, "there is no such mesh file",
            "a gmsh mesh (.msh), its path relative to the case file",
            "check the path, or omit the key: rollfem then meshes the body");
  }
}

/// The case of keys that have passed their own checks.
Case case_of(const GivenCase& given, const std::vector<std::string>& models_by_default) {
  check_together(given);
  Case input = default_case();
  input.models = models_by_default;
  set_values(input, given.values);
  for (const GivenEntry& entry : given.entries) {
    begin_entry(input, entry.section);
    set_values(input, entry.values);
  }
  input.file = given.file;
  if (input.title.empty()) input.title = std::filesystem::path(given.file).stem().string();
  complete(given, input);
  check_geometry(given, input);
  check_values(given, input);
  read_files(given, input);
  return input;
}

}  // namespace

Case parse_case(const std::string& text, const std::string& name, const ModelWords& models) {
  if (text.size() > largest_file)
    fail_file(name, "is larger than 1 MB, so it is not a case file", "give a case file in TOML");
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    fail_file(name, "is empty", "fill it in; `rollfem new-case` prints a template");
  Case input = case_of(read_toml(text, name, models.known), models.by_default);
  input.text = text;
  return input;
}

Case make_case(const NamedValues& values, const std::string& name) {
  GivenCase given;
  given.file = name;
  for (const auto& [path, value] : values) {
    const std::size_t dot = path.find('.');
    const Key* key = find_key(path.substr(0, dot), path.substr(dot + 1));
    if (key == nullptr) throw std::logic_error(path + " is not a key of a case");
    given.values[key] = checked_value(name, *key, value);
    given.section_lines.emplace(key->section, 0);
  }
  return case_of(given, {});
}

Case read_case(const std::string& path, const ModelWords& models,
               const std::vector<std::string>& changes) {
  std::string text =
      text_of_file(path, path, largest_file, "name a case file (.toml); cases/ holds examples");
  return parse_case(with_changes(std::move(text), path, changes, models), path, models);
}

std::vector<SubsurfaceRequest> read_places(const std::string& path) {
  const GivenCase given =
      read_toml(text_of_file(path, path, largest_file, "name a file of places"), path);
  if (given.entries.empty())
    fail_file(path, "has no section [[subsurface.point]], .line, .plane or .surface",
              "add one, as in a case file (docs/case-file.md)");
  check_entries(given);
  Case places;
  for (const GivenEntry& entry : given.entries) {
    begin_entry(places, entry.section);
    set_values(places, entry.values);
  }
  check_places(given, places, false);
  return places.subsurface;
}

}  // namespace rollfem::contact

// SPDX-License-Identifier: LGPL-2.1-or-later
// Descriptions of a case: `check`, `new-case` and the reference page.
#include "contact/case/case_reader.hpp"
#include "contact/case/case_text.hpp"
#include "contact/case/toml/toml_library.hpp"

#include <fmt/format.h>

#include <set>
#include <string_view>
#include <utility>

namespace rollfem::contact {

namespace {

Case defaults(const ModelWords& models) {
  Case input = default_case();
  input.models = models.by_default;
  return input;
}

/// A section without its heading. Of alternative keys only the given ones get a line; a value given
/// in the file is never marked as the default, even if it equals it.
std::string describe_keys(const Section& section, const Case& input, const Case& by_default,
                          const toml::table& file) {
  std::string text;
  for (const Key& key : section) {
    const KeyValue value = key.get(input);
    const bool given = !std::holds_alternative<std::monostate>(value);
    if (key.path() == "title") continue;
    if (!given && (section.alternatives || key.when_absent.empty())) continue;
    const bool is_default = given && !key.required && key.when_absent.empty() &&
                            value == key.get(by_default) && !file.at_path(key.path());
    text += fmt::format("  {:<22} {}{}{}\n", key.name, given ? toml_text(value) : key.when_absent,
                        given && !key.unit.empty() ? " " + key.unit : "",
                        is_default ? "  (default)" : "");
  }
  return text;
}

std::string default_text(const Key& key, const Case& by_default) {
  if (key.required) return "required";
  const std::string value = toml_text(key.get(by_default));
  return value.empty() || !key.when_absent.empty() ? key.when_absent : value;
}

/// Allowed values in few words: "0.001 to 1e+09 mm" for "a number from 0.001 to 1e+09 mm".
std::string allowed_in_table(const Key& key, const ModelWords& models) {
  std::string text = allowed_values(key, models.known);
  for (const auto& [said, shorter] : {std::pair{"a number or a list of numbers ", "list, "},
                                      {"a list of two numbers ", "two, "},
                                      {"a list of three numbers ", "three, "},
                                      {"a whole number ", "whole, "},
                                      {"a number ", ""},
                                      {"from ", ""},
                                      {"a string in quotes", "text"},
                                      {"one of ", ""},
                                      {"a list of some of ", "some of "}})
    if (text.rfind(said, 0) == 0 || std::string_view(said) == "from ")
      if (const std::size_t at = text.find(said); at != text.npos)
        text.replace(at, std::string_view(said).size(), shorter);
  return text;
}

/// One key of the template: its sentence, the allowed values, and the line itself.
std::string template_key(const Key& key, const ModelWords& models, bool commented_out) {
  const Case by_default = defaults(models);
  const std::string value = key.example.empty() ? toml_text(key.get(by_default)) : key.example;
  std::string text = fmt::format("# {}\n# {}", key.sentence, allowed_values(key, models.known));
  text += key.required ? "; required.\n"
                       : fmt::format("; default: {}.\n", default_text(key, by_default));
  if (value.empty())
    text += fmt::format("# {} = {}\n", key.name, key.kind == KeyKind::pair ? "[0.2, 0.2]" : "...");
  else
    text += fmt::format("{}{} = {}\n", commented_out ? "# " : "", key.name, value);
  return text;
}

}  // namespace

std::string describe(const Case& input, const ModelWords& models) {
  const Case by_default = defaults(models);
  const toml::table file = toml::parse(input.text + "\n");  // the reader has accepted it
  std::string text = fmt::format("{}\n", input.title);
  if (!input.file.empty()) text += fmt::format("  {:<22} {}\n", "file", input.file);
  const auto add = [&](const std::string& head, const std::string& keys) {
    if (!keys.empty()) text += head + keys;
  };
  for (const Section& section : case_sections()) {
    if (!section.applies_to(input)) continue;
    if (!section.repeated) {
      const std::string head = section.name.empty() ? "" : "[" + section.name + "]\n";
      add(head, describe_keys(section, input, by_default, file));
      continue;
    }
    Case one = input;
    for (const SubsurfaceRequest& request : input.subsurface) {
      one.subsurface = {request};
      add("[[" + section.name + "]]\n", describe_keys(section, one, by_default, file));
    }
  }
  return text;
}

std::string case_template(const ModelWords& models) {
  std::string text =
      "# A case of rolling contact for rollfem. Units: mm, N, MPa, rad. x is the rolling\n"
      "# direction, y lateral, z normal. Paths are relative to this file; sections in [[ ]]\n"
      "# may be repeated. `rollfem check FILE` shows how a case is read, `rollfem run FILE`\n"
      "# computes it. Reference of all keys: docs/case-file.md\n";
  for (const Section& section : case_sections()) {
    if (section.repeated)
      text += fmt::format("\n# {}\n# [[{}]]\n", section.sentence, section.name);
    else
      text += section.name.empty() ? "\n"
                                   : fmt::format("\n# {}\n[{}]\n", section.sentence, section.name);
    for (const Key& key : section)
      text += template_key(key, models, section.repeated || section.of_profiles);
  }
  return text;
}

std::string case_reference_markdown(const ModelWords& models) {
  const Case by_default = defaults(models);
  std::string text =
      "# Case file reference\n\n"
      "<!-- Made by `rollfem docs case-file` from the declarations in contact/case/keys/; "
      "do not edit. -->\n\n"
      "A case file is TOML. x is the rolling direction, y lateral, z normal into the wheel. Paths "
      "are relative to the case\nfile. `list` stands for one number or a list of numbers; sections "
      "in `[[ ]]` may be repeated. Unknown keys, wrong types,\nvalues out of bounds and "
      "contradictions are errors that name file, line and key.\n\n`rollfem new-case` prints a "
      "commented template, `rollfem check FILE` how a case is read. `rollfem docs schema >\n"
      "case.schema.json` writes the JSON schema: with `#:schema case.schema.json` as the first "
      "line "
      "of a case, editors that\nknow schemas of TOML complete keys and check values.\n";
  std::set<std::string> last_rows;
  std::string last_name;
  std::size_t end_of_heading = 0;
  for (const Section& section : case_sections()) {
    std::set<std::string> rows;
    std::string told, as_before;  // rows; keys with the row of the previous section
    for (const Key& key : section) {
      const std::string row = fmt::format(
          "| `{}`{}{} | {} | {} | {} |\n", key.name, key.symbol.empty() ? "" : " ", key.symbol,
          allowed_in_table(key, models), default_text(key, by_default), key.sentence);
      rows.insert(row);
      if (last_rows.count(row) == 0)
        told += row;
      else
        as_before += fmt::format("{}`{}`", as_before.empty() ? "" : ", ", key.name);
    }
    last_rows = std::move(rows);
    const std::string before = std::exchange(last_name, section.name);
    if (told.empty()) text.insert(end_of_heading, fmt::format(", [{}]", section.name));
    if (told.empty()) continue;
    text += section.name.empty()
                ? "\n## Before the first section"
                : fmt::format(section.repeated ? "\n## [[{}]]" : "\n## [{}]", section.name);
    end_of_heading = text.size();
    text += section.name.empty() ? "\n\n" : fmt::format("\n\n{}.", section.sentence);
    if (!as_before.empty()) text += fmt::format(" As in [{}]: {}.", before, as_before);
    text += section.name.empty() ? "" : "\n\n";
    text += "| key | allowed | default | meaning |\n";
    text += "|---|---|---|---|\n" + told;
  }
  return text;
}

}  // namespace rollfem::contact

// What a case file says, said back: `check`, `new-case` and the reference page.
#include "contact/case/case_reader.hpp"
#include "contact/case/case_text.hpp"

#include <fmt/format.h>

namespace rollfem::contact {

namespace {

const Case& defaults() {
  static const Case input = default_case();
  return input;
}

std::string pad(const std::string& text, std::size_t width) {
  return fmt::format("{:<{}}", text, width);
}

std::string describe_key(const Key& key, const Case& input) {
  const KeyValue value = key.get(input);
  const std::string text = toml_text(value);
  if (text.empty()) {
    // Of two alternatives only the given one is worth a line.
    const bool alternative = key.section == "load" || key.section == "contact_grid" ||
                             key.section == "history" || key.section == "undeformed_distance" ||
                             key.section == "given_pressure" || key.section == "rolling";
    return alternative ? "" : fmt::format("  {} {}\n", pad(key.name, 22), key.when_absent);
  }
  const bool is_default = !key.required && key.when_absent.empty() && value == key.get(defaults());
  std::string line = fmt::format("  {} {}", pad(key.name, 22), text);
  if (!key.unit.empty()) line += " " + key.unit;
  if (is_default) line += "  (default)";
  return line + "\n";
}

/// A section of which there may be several: each with its own values.
std::string describe_entries(const Section& section, const Case& input) {
  std::string text;
  Case one = input;
  for (const SubsurfaceRequest& request : input.subsurface) {
    one.subsurface = {request};
    std::string keys;
    bool here = false;
    for (const Key& key : case_keys()) {
      if (key.section != section.name) continue;
      const std::string value = toml_text(key.get(one));
      here = here || !value.empty();
      keys += fmt::format("  {} {}{}\n", pad(key.name, 22), value,
                          key.unit.empty() ? "" : " " + key.unit);
    }
    if (here) text += fmt::format("[[{}]]\n{}", section.name, keys);
  }
  return text;
}

/// Sections that belong to profiles, which a case may do without.
bool is_of_profiles(const Section& section) {
  return section.name == "track" || section.name == "wheelset";
}

/// Sections that say nothing when nothing is given in them, or without profiles.
bool is_silent(const Section& section, const Case& input) {
  if (is_of_profiles(section)) return !input.has_profiles();
  if (section.name != "history" && section.name != "undeformed_distance" &&
      section.name != "given_pressure")
    return false;
  for (const Key& key : case_keys())
    if (key.section == section.name && !toml_text(key.get(input)).empty()) return false;
  return true;
}

std::string default_text(const Key& key) {
  if (key.required) return "required";
  const std::string value = toml_text(key.get(defaults()));
  return value.empty() || !key.when_absent.empty() ? key.when_absent : value;
}

/// One key of the template: its sentence, what is allowed, and the line itself.
std::string template_key(const Key& key, bool commented_out) {
  const std::string value = key.example.empty() ? toml_text(key.get(defaults())) : key.example;
  std::string text = fmt::format("# {}\n# {}", key.sentence, allowed_values(key));
  text += key.required ? "; required.\n" : fmt::format("; default: {}.\n", default_text(key));
  if (value.empty())
    text += fmt::format("# {} = {}\n", key.name, key.kind == KeyKind::pair ? "[0.2, 0.2]" : "...");
  else
    text += fmt::format("{}{} = {}\n", commented_out ? "# " : "", key.name, value);
  return text;
}

}  // namespace

std::string describe(const Case& input) {
  std::string text = fmt::format("{}\n", input.title);
  if (!input.file.empty()) text += fmt::format("  {} {}\n", pad("file", 22), input.file);
  for (const Section& section : case_sections()) {
    if (section.repeated) {
      text += describe_entries(section, input);
      continue;
    }
    if (is_silent(section, input)) continue;
    if (!section.name.empty()) text += fmt::format("[{}]\n", section.name);
    for (const Key& key : case_keys())
      if (key.section == section.name && key.name != "title") text += describe_key(key, input);
  }
  return text;
}

std::string case_template() {
  std::string text =
      "# A case of rolling contact for rollfem. Units: mm, N, MPa, rad. x is the rolling\n"
      "# direction, y lateral, z normal. `rollfem check FILE` says what was understood,\n"
      "# `rollfem run FILE` computes it. Reference of all keys: docs/case-file.md\n";
  for (const Section& section : case_sections()) {
    if (section.repeated)
      text += fmt::format("\n# {}\n# [[{}]]\n", section.sentence, section.name);
    else
      text += section.name.empty() ? "\n"
                                   : fmt::format("\n# {}\n[{}]\n", section.sentence, section.name);
    for (const Key& key : case_keys())
      if (key.section == section.name)
        text += template_key(key, section.repeated || is_of_profiles(section));
  }
  return text;
}

std::string case_reference_markdown() {
  std::string text =
      "# Case file reference\n\n"
      "<!-- Made by `rollfem docs case-file` from the declarations in contact/case/case_keys.cpp; "
      "do "
      "not edit. -->\n\n"
      "A case file is TOML. Units: mm, N, MPa, rad; x is the rolling direction, y lateral, z "
      "normal "
      "into the wheel.\nUnknown keys, wrong types, values out of bounds and contradictions are "
      "errors that name file, line and key.\n`rollfem new-case` prints a commented template, "
      "`rollfem check FILE` what was understood.\n";
  for (const Section& section : case_sections()) {
    text += section.name.empty()
                ? "\n## Before the first section\n\n"
                : fmt::format(section.repeated ? "\n## [[{}]]\n\n{}.\n\n" : "\n## [{}]\n\n{}.\n\n",
                              section.name, section.sentence);
    text += "| key | symbol | unit | allowed | default | meaning |\n";
    text += "|---|---|---|---|---|---|\n";
    for (const Key& key : case_keys())
      if (key.section == section.name)
        text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", key.name, key.symbol, key.unit,
                            allowed_values(key), default_text(key), key.sentence);
  }
  return text;
}

}  // namespace rollfem::contact

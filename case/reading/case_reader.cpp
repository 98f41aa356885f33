// SPDX-License-Identifier: LGPL-2.1-or-later
#include "case/reading/case_reader.hpp"

#include "base/errors.hpp"
#include "base/text_fields.hpp"
#include "case/checks/case_checks.hpp"
#include "case/keys/case_text.hpp"
#include "case/lattice.hpp"
#include "case/reading/toml_library.hpp"
#include "case/reading/toml_reader.hpp"
#include "case/reading/toml_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace rollfem::contact {

namespace fs = std::filesystem;

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
    fail_at(given, std::string(body) + ".mesh", "there is no such mesh file",
            "a gmsh mesh (.msh), its path relative to the case file",
            "check the path, or omit the key: rollfem then meshes the body");
  }
}

/// The case of keys that have passed their own checks.
Case case_of(const GivenCase& given, const std::vector<std::string>& models_by_default) {
  check_together(given);
  Case input;
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

struct Change {
  std::string section, key, value;
  std::string line() const { return key + " = " + value; }
};

/// `transient` means "transient"; for keys that take text, so do `60E1` and `1:40`.
bool is_bare_word(const std::string& value, const Key* key) {
  if (value.find_first_of("\"'\\") != std::string::npos) return false;
  if (key != nullptr && (key->kind == KeyKind::text || key->kind == KeyKind::word ||
                         (key->kind == KeyKind::lean && value.find(':') != std::string::npos)))
    return !value.empty();
  for (const char* word : {"true", "false", "inf", "nan"})
    if (value == word) return false;
  return !value.empty() && std::isalpha(static_cast<unsigned char>(value.front())) != 0;
}

constexpr const char* example = "--set friction.coefficient=0.3";

/// Read as a separate case file, so that errors are reported for the option and not for the file.
Change read_change(const std::string& text, const KnownNames& known) {
  const std::size_t equals = text.find('=');
  const bool printable = std::all_of(text.begin(), text.end(), [](const char c) {
    return static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
  });
  if (equals == std::string::npos || !printable)
    throw InputError(
        fmt::format("--set {}: expected KEY=VALUE; allowed: the keys of docs/case-file.md, each "
                    "with its section; do: write for instance {}",
                    printable ? text : "...", example));
  const std::string path(trimmed(std::string_view(text).substr(0, equals)));
  const std::size_t dot = path.rfind('.');
  Change change;
  if (dot != std::string::npos) change.section = path.substr(0, dot);
  change.key = dot == std::string::npos ? path : path.substr(dot + 1);
  change.value = trimmed(std::string_view(text).substr(equals + 1));
  if (is_bare_word(change.value, find_key(change.section, change.key)))
    change.value = '"' + change.value + '"';
  const std::string header = change.section.empty() ? "" : "[" + change.section + "]\n";
  const std::string option = "--set " + (text.size() > 80 ? text.substr(0, 77) + "..." : text);
  if (change.value.empty())
    throw InputError(option + ": the value is missing; do: write for instance " + example);
  if (change.section.find('.') != std::string::npos)
    throw InputError(
        fmt::format("{}: [[{}]] may be repeated; allowed: keys of other sections; do: "
                    "change it in the case file",
                    option, change.section));
  static_cast<void>(read_toml(header + change.line() + "\n", option, known, true));
  return change;
}

/// Start of a line, counted from 1; the end of the text for lines beyond the last.
std::size_t begin_of(const std::string& text, unsigned line) {
  std::size_t at = 0;
  for (unsigned k = 1; k < line && at < text.size(); ++k)
    at = std::min(text.find('\n', at), text.size() - 1) + 1;
  return at;
}

std::size_t offset(const std::string& text, const toml::source_position& place) {
  return std::min(begin_of(text, place.line) + place.column - 1, text.size());
}

/// Insertion into an existing section.
void insert(const Change& change, const toml::table& section, const std::string& file,
            std::string& text) {
  if (section.is_inline())
    throw InputError(
        fmt::format("{}:{}: {}: the section is an inline table, in which --set can change keys but "
                    "not add them; do: write [{}] on a line of its own and its keys below",
                    file, section.source().begin.line, change.section, change.section));
  const unsigned line = section.source().begin.line;
  const std::size_t begin = begin_of(text, line);
  const bool headed = text.find_first_not_of(" \t", begin) == text.find('[', begin);
  if (headed)
    text.insert(begin_of(text, line + 1), change.line() + '\n');
  else
    text.insert(begin, change.section + '.' + change.line() + '\n');
}

void make(const Change& change, const std::string& file, std::string& text) {
  if (!text.empty() && text.back() != '\n') text += '\n';
  const toml::table root = toml::parse(text, file);
  const toml::table* section = &root;
  if (!change.section.empty()) {
    section = nullptr;
    if (const toml::node* found = root.get(change.section)) section = found->as_table();
  }
  if (section == nullptr) {
    text += fmt::format("\n[{}]\n{}\n", change.section, change.line());
  } else if (const toml::node* value = section->get(change.key)) {
    const std::size_t begin = offset(text, value->source().begin);
    text.replace(begin, offset(text, value->source().end) - begin, change.value);
  } else if (change.section.empty()) {
    text.insert(0, change.line() + '\n');
  } else {
    insert(change, *section, file, text);
  }
}

/// Keys that may name files, with the names.
std::vector<std::pair<const Key*, std::string>> named_files(const Case& input) {
  std::vector<std::pair<const Key*, std::string>> named;
  for (const Key& key : case_keys()) {
    const KeyValue value = key.names_file ? key.get(input) : KeyValue();
    if (const auto* name = std::get_if<std::string>(&value)) named.emplace_back(&key, *name);
  }
  return named;
}

// Descriptions of a case: `check`, `new-case` and the reference page.

Case defaults(const KnownNames& known) {
  Case input;
  input.models = known.default_models;
  return input;
}

/// A section without its heading. Of alternative keys only the given ones get a line; a value given
/// in the file is never marked as the default, even if it equals it.
std::string describe_keys(const Section& section, const Case& input, const Case& by_default,
                          const toml::table& file, bool every_key) {
  std::string text;
  for (const Key& key : section) {
    const KeyValue value = key.get(input);
    const bool given = !std::holds_alternative<std::monostate>(value);
    if (key.path() == "title") continue;
    if (!given && (section.alternatives || key.when_absent.empty())) continue;
    if (!every_key && (!given || value == key.get(by_default))) continue;
    const bool is_default = given && !key.required && key.when_absent.empty() &&
                            value == key.get(by_default) && !file.at_path(key.path());
    text += fmt::format("  {:<{}} {}{}{}\n", every_key ? key.name : key.path(), every_key ? 22 : 30,
                        given ? toml_text(value) : key.when_absent,
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

/// One key of the template: its sentence, the allowed values, and the line itself.
std::string template_key(const Key& key, const KnownNames& known, bool commented_out) {
  const Case by_default = defaults(known);
  const std::string value = key.example.empty() ? toml_text(key.get(by_default)) : key.example;
  std::string text = fmt::format("# {}\n# {}", key.sentence, allowed_values(key, known));
  text += key.required ? "; required.\n"
                       : fmt::format("; default: {}.\n", default_text(key, by_default));
  if (value.empty())
    text += fmt::format("# {} = {}\n", key.name, key.kind == KeyKind::pair ? "[0.2, 0.2]" : "...");
  else
    text += fmt::format("{}{} = {}\n", commented_out ? "# " : "", key.name, value);
  return text;
}

}  // namespace

Case parse_case(const std::string& text, const std::string& name, const KnownNames& known) {
  if (text.size() > largest_file)
    fail_file(name, "is larger than 1 MB, so it is not a case file", "give a case file in TOML");
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    fail_file(name, "is empty", "fill it in; `rollfem new-case` prints a template");
  Case input = case_of(read_toml(text, name, known), known.default_models);
  input.text = text;
  return input;
}

Case make_case(const NamedValues& values, const std::string& name) {
  GivenCase given;
  given.file = name;
  for (const auto& [path, value] : values) {
    const Key* key = find_key(path);
    if (key == nullptr) throw std::logic_error(path + " is not a key of a case");
    given.values[key] = checked_value(name, *key, value);
    given.section_lines.emplace(key->section, 0);
  }
  return case_of(given, {});
}

Case read_case(const std::string& path, const KnownNames& known,
               const std::vector<std::string>& changes) {
  std::string text =
      text_of_file(path, path, largest_file, "name a case file (.toml); cases/ holds examples");
  return parse_case(with_changes(std::move(text), path, changes, known), path, known);
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

std::vector<std::string> files_read_by(const Case& input) {
  std::vector<std::string> files;
  std::set<std::string> seen;
  const auto add = [&](const fs::path& folder, std::string_view name, const auto& self) -> void {
    const fs::path file = (folder / name).lexically_normal();
    std::error_code error;  // built-in profiles have no file
    if (!fs::is_regular_file(file, error) || !seen.insert(file.string()).second) return;
    files.push_back(file.string());
    if (!is_list_of_sections(file.string())) return;
    // Every field of a list that is the name of a file, whatever the format of the list.
    constexpr std::size_t largest = 10'000'000;
    const std::string text = text_of_file(file.string(), file.string(), largest);
    for (const std::string_view field : fields_of(text, " \t\r\n,'\""))
      self(file.parent_path(), field, self);
  };
  for (const auto& [key, name] : named_files(input))
    add(fs::path(input.file).parent_path(), name, add);
  return files;
}

std::string with_changes(std::string text, const std::string& file,
                         const std::vector<std::string>& changes, const KnownNames& known) {
  for (const std::string& change : changes) {
    static_cast<void>(read_toml(text, file, known));
    make(read_change(change, known), file, text);
  }
  return text;
}

std::string text_in_folder(const Case& input, const std::string& folder) {
  std::string text = input.text;
  for (const auto& [key, name] : named_files(input)) {
    // Built-in profiles have names without dots and slashes.
    if (name.find_first_of("./") == std::string::npos || fs::path(name).is_absolute()) continue;
    std::error_code error;
    const fs::path there = fs::path(input.file).parent_path() / name;
    const std::string way = fs::relative(there, folder, error).generic_string();
    if (!error && !way.empty() && way != name)
      make({key->section, key->name, toml_text(KeyValue(way))}, input.file, text);
  }
  return text;
}

std::string describe(const Case& input, const KnownNames& known, bool every_key) {
  const Case by_default = defaults(known);
  const toml::table file = toml::parse(input.text + "\n");  // the reader has accepted it
  std::string text = fmt::format("{}\n", input.title);
  if (!input.file.empty())
    text += fmt::format("  {:<{}} {}\n", "file", every_key ? 22 : 30, input.file);
  const auto add = [&](const std::string& head, const std::string& keys) {
    if (!keys.empty()) text += head + keys;
  };
  for (const Section& section : case_sections()) {
    if (!section.applies_to(input)) continue;
    if (!section.repeated) {
      const std::string head = section.name.empty() || !every_key ? "" : "[" + section.name + "]\n";
      add(head, describe_keys(section, input, by_default, file, every_key));
      continue;
    }
    Case one = input;
    for (const SubsurfaceRequest& request : input.subsurface) {
      one.subsurface = {request};
      add("[[" + section.name + "]]\n", describe_keys(section, one, by_default, file, every_key));
    }
  }
  return text;
}

std::string case_template(const KnownNames& known) {
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
      text += template_key(key, known, section.repeated || section.of_profiles);
  }
  return text;
}

std::string case_reference_markdown(const KnownNames& known) {
  const Case by_default = defaults(known);
  std::string text =
      "# Case file reference\n\n"
      "<!-- Made by `rollfem docs case-file` from the declarations in case/keys/; "
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
          allowed_values(key, known, true), default_text(key, by_default), key.sentence);
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

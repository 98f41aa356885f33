// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/base/errors.hpp"
#include "contact/base/text_fields.hpp"
#include "contact/case/case_reader.hpp"
#include "contact/case/case_text.hpp"
#include "contact/case/toml/toml_library.hpp"
#include "contact/case/toml/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

namespace fs = std::filesystem;

namespace rollfem::contact {

namespace {

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
Change read_change(const std::string& text, const ModelWords& models) {
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
  static_cast<void>(read_toml(header + change.line() + "\n", option, models.known));
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

}  // namespace

std::vector<std::string> files_read_by(const Case& input) {
  std::vector<std::string> files;
  std::set<std::string> seen;
  const auto add = [&](const fs::path& folder, std::string_view name, const auto& self) -> void {
    const fs::path file = (folder / name).lexically_normal();
    std::error_code error;  // built-in profiles have no file
    if (!fs::is_regular_file(file, error) || !seen.insert(file.string()).second) return;
    files.push_back(file.string());
    ProfileSource profile;
    profile.name = file.string();
    if (!profile.lists_sections()) return;
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
                         const std::vector<std::string>& changes, const ModelWords& models) {
  for (const std::string& change : changes) {
    static_cast<void>(read_toml(text, file, models.known));
    make(read_change(change, models), file, text);
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

}  // namespace rollfem::contact

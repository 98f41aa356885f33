// SPDX-License-Identifier: LGPL-2.1-or-later
#include "case/reading/toml_reader.hpp"

#include "base/errors.hpp"
#include "base/text_fields.hpp"
#include "case/keys/case_text.hpp"
#include "case/reading/toml_source.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rollfem::contact {

namespace {

constexpr std::size_t longest_line = 10000;

CaseProblem at(const toml::source_region& source, const std::string& key) {
  CaseProblem problem;
  problem.line = source.begin.line;
  problem.column = source.begin.column;
  problem.key = printable(key, longest_name);
  return problem;
}

bool is_section(const std::string& name) {
  for (const Section& section : case_sections())
    if (!section.name.empty() && section.name == name) return true;
  return false;
}

/// Whether repeatable sections "name.x" are declared.
bool has_repeated_sections(const std::string& name) {
  for (const Section& section : case_sections())
    if (section.repeated && section.name.rfind(name + ".", 0) == 0) return true;
  return false;
}

std::vector<std::string> keys_of(const std::string& name) {
  std::vector<std::string> names;
  for (const Section& section : case_sections())
    if (section.name == name)
      for (const Key& key : section) names.push_back(key.name);
  return names;
}

/// Non-repeatable sections with a key of that name.
std::vector<std::string> sections_that_have(const std::string& name) {
  std::vector<std::string> found;
  for (const Section& section : case_sections())
    if (!section.repeated && !section.name.empty() && find_key(section.name, name) != nullptr)
      found.push_back(section.name);
  return found;
}

/// Correct section of a key given without its section, or in another one.
std::string move_to(const std::vector<std::string>& sections, const std::string& name,
                    bool option) {
  std::string places;
  for (const std::string& section : sections)
    places +=
        (places.empty() ? "" : " or ") + (option ? section + '.' + name : '[' + section + ']');
  return option ? "write " + places : "move it to " + places;
}

/// Converts TOML into checked key values; every fault becomes one InputError.
class Reader {
 public:
  Reader(const std::string& text, const std::string& file, const KnownNames& known, bool option)
      : source_(text, file, option), known_(known) {
    given_.file = file;
  }

  GivenCase read() {
    const toml::table root = parse();
    for (const auto& [name, node] : root) {
      const std::string key(name.str());
      if (find_key("", key) != nullptr)
        read_key("", key, name.source(), node);
      else if (is_section(key))
        read_section(key, node);
      else if (has_repeated_sections(key))
        read_repeated_sections(key, name.source(), node);
      else
        fail_unknown("", key, name.source());
    }
    return std::move(given_);
  }

 private:
  toml::table parse() const {
    if (source_.text().find('\0') != std::string::npos)
      fail_file(given_.file, "is a binary file, not a case file",
                "give a case file in TOML; `rollfem new-case` prints one");
    const std::vector<std::string>& lines = source_.lines();
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].size() > longest_line)
        fail_file(fmt::format("{}:{}", given_.file, i + 1),
                  fmt::format("the line is longer than {} characters", longest_line),
                  "break it into several; lists may extend over many lines");
    if (const auto fault = find_toml_fault(source_))
      fail_invalid(fault->line, fault->column, fault->wrong);
    try {
      // Adds a final line end, so that faults of the last line are reported like those of any
      // other.
      const bool ends = source_.text().empty() || source_.text().back() == '\n';
      return toml::parse(source_.text() + (ends ? "" : "\n"), given_.file);
    } catch (const toml::parse_error& error) {
      const unsigned line = error.source().begin.line;
      fail_invalid(line, error.source().begin.column,
                   meaning_of(error.description(), lines[line - 1]));
    }
  }

  [[noreturn]] void fail_invalid(unsigned line, unsigned column, const std::string& wrong) const {
    const bool option = source_.is_option();
    if (!option && !source_.looks_like_case())
      fail_file(given_.file,
                "is not a case file: most of its lines are neither keys with values nor sections",
                "give a case file in TOML; `rollfem new-case` prints one");
    source_.fail({line, column, "", "",
                  option ? "not a value in TOML: " + wrong
                         : fmt::format("not valid TOML in `{}`: {}", source_.line(line), wrong),
                  "",
                  option ? "write the value as in a case file"
                         : "correct this line; `rollfem new-case` prints a valid case file"});
  }

  /// `parent` holds lists of sections, written [[parent.child]].
  void read_repeated_sections(const std::string& parent, const toml::source_region& parent_source,
                              const toml::node& node) {
    std::vector<std::string> names;
    for (const Section& section : case_sections())
      if (section.repeated) names.push_back(section.name.substr(section.name.find('.') + 1));
    const toml::table* table = node.as_table();
    if (table == nullptr) fail_unrepeated(parent, parent_source, names);
    for (const auto& [name, child] : *table) {
      const std::string section = parent + "." + std::string(name.str());
      if (!is_section(section)) fail_unrepeated(section, name.source(), names);
      const toml::array* entries = child.as_array();
      if (entries == nullptr || entries->empty() || !entries->is_array_of_tables())
        fail_unrepeated(section, name.source(), names);
      for (const toml::node& entry : *entries) read_entry(section, entry);
    }
    // toml++ sorts by name; entries are needed in the order of the file.
    std::stable_sort(given_.entries.begin(), given_.entries.end(),
                     [](const GivenEntry& a, const GivenEntry& b) { return a.line < b.line; });
  }

  void read_entry(const std::string& section, const toml::node& node) {
    if (given_.entries.size() >= longest_list)
      fail_file(given_.file, fmt::format("has more than {} sections [[{}]]", longest_list, section),
                "give planes or lines of points instead");
    GivenEntry entry;
    entry.section = section;
    entry.line = node.source().begin.line;
    std::swap(entry.values, given_.values);
    for (const auto& [name, child] : *node.as_table())
      read_key(section, std::string(name.str()), name.source(), child);
    std::swap(entry.values, given_.values);
    given_.entries.push_back(std::move(entry));
  }

  [[noreturn]] void fail_unrepeated(const std::string& section, const toml::source_region& source,
                                    const std::vector<std::string>& names) const {
    CaseProblem problem = at(source, section);
    problem.wrong = "is not a known list of sections";
    problem.allowed = "[[subsurface.NAME]] with NAME one of " + joined(names);
    problem.action =
        "write for instance [[subsurface.line]] on a line of its own and its keys below";
    source_.fail(problem);
  }

  void read_section(const std::string& section, const toml::node& node) {
    const toml::source_region& source = node.source();
    const toml::table* table = node.as_table();
    if (table == nullptr) {
      CaseProblem problem = at(source, section);
      problem.value = source_.value(source);
      problem.wrong = "is a section, not a key with a value";
      problem.allowed =
          fmt::format("[{0}] once, with keys like {0}.{1}", section, keys_of(section).front());
      problem.action = fmt::format("write [{}] on a line of its own and its keys below", section);
      source_.fail(problem);
    }
    given_.section_lines[section] = source.begin.line;
    for (const auto& [name, child] : *table)
      read_key(section, std::string(name.str()), name.source(), child);
  }

  void read_key(const std::string& section, const std::string& name,
                const toml::source_region& name_source, const toml::node& node) {
    const Key* key = find_key(section, name);
    if (key == nullptr) fail_unknown(section, name, name_source);
    given_.values[key] = read_value(source_, *key, known_, node);
  }

  [[noreturn]] void fail_unknown(const std::string& section, const std::string& name,
                                 const toml::source_region& source) const {
    CaseProblem problem = at(source, section.empty() ? name : section + "." + name);
    problem.wrong = "is not a key of a case file";
    std::vector<std::string> here = keys_of(section);
    if (section.empty())
      for (const Section& known : case_sections())
        if (!known.name.empty()) here.push_back(known.name);
    problem.allowed = joined(here);
    const std::string near = nearest_name(name, here);
    const std::vector<std::string> elsewhere = sections_that_have(name);
    const bool option = source_.is_option();
    if (option) problem.wrong = problem.key + ' ' + problem.wrong;
    if (!elsewhere.empty())
      problem.action = move_to(elsewhere, name, option);
    else if (!near.empty())
      problem.action = fmt::format("did you mean `{}`? Write that, or remove the key", near);
    else
      problem.action = "remove it; docs/case-file.md lists all keys";
    source_.fail(problem);
  }

  const TomlSource source_;
  const KnownNames& known_;
  GivenCase given_;
};

}  // namespace

void fail_file(const std::string& file, const std::string& wrong, const std::string& action) {
  throw FileError(file + ": " + wrong + "; do: " + action);
}

GivenCase read_toml(const std::string& text, const std::string& file, const KnownNames& known,
                    bool option) {
  return Reader(text, file, known, option).read();
}

}  // namespace rollfem::contact

#include "contact/case/case_reader.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/case_checks.hpp"
#include "contact/case/case_text.hpp"
#include "contact/case/lattice.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace rollfem::contact {

namespace {

constexpr std::uintmax_t largest_file = 1 << 20;
constexpr std::size_t longest_list = 1000;
// Dotted keys nest without a limit in toml++, and a chain of 100 000 overflows the stack.
constexpr std::size_t longest_line = 10000;
constexpr std::size_t longest_title = 200;

[[noreturn]] void fail_whole(const std::string& file, const std::string& wrong,
                             const std::string& action) {
  CaseProblem problem;
  problem.wrong = wrong;
  problem.action = action;
  fail(file, problem);
}

/// Turns TOML into checked key values; everything it refuses becomes one InputError.
class Reader {
 public:
  Reader(const std::string& text, const std::string& name) : text_(text) {
    given_.file = name;
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      lines_.push_back(text.substr(begin, end - begin));
      begin = end + 1;
    }
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
    if (text_.find('\0') != std::string::npos)
      fail_whole(given_.file, "is a binary file, not a case file",
                 "give a case file in TOML; `rollfem new-case` prints one");
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (lines_[i].size() > longest_line)
        fail_whole(fmt::format("{}:{}", given_.file, i + 1),
                   fmt::format("the line is longer than {} characters", longest_line),
                   "break it into several; lists may go over many lines");
    try {
      return toml::parse(text_, given_.file);
    } catch (const toml::parse_error& error) {
      CaseProblem problem;
      problem.line = error.source().begin.line;
      problem.column = error.source().begin.column;
      problem.wrong =
          fmt::format("not valid TOML in `{}`: {}", line_text(problem.line), error.description());
      problem.action = "mend this line; `rollfem new-case` prints a valid case file";
      fail(given_.file, problem);
    }
  }

  static bool is_section(const std::string& name) {
    for (const Section& section : case_sections())
      if (!section.name.empty() && section.name == name) return true;
    return false;
  }

  /// Whether sections "name.x" of which there may be several are declared.
  static bool has_repeated_sections(const std::string& name) {
    for (const Section& section : case_sections())
      if (section.repeated && section.name.rfind(name + ".", 0) == 0) return true;
    return false;
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
    // toml++ sorts by name; entries are wanted in the order of the file.
    std::stable_sort(given_.entries.begin(), given_.entries.end(),
                     [](const GivenEntry& a, const GivenEntry& b) { return a.line < b.line; });
  }

  void read_entry(const std::string& section, const toml::node& node) {
    if (given_.entries.size() >= longest_list)
      fail_whole(given_.file,
                 fmt::format("has more than {} sections [[{}]]", longest_list, section),
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
    CaseProblem problem = at(source);
    problem.key = section;
    problem.wrong = "is not a list of sections that is known";
    problem.allowed = "[[subsurface.NAME]] with NAME one of " + joined(names);
    problem.action =
        "write for instance [[subsurface.line]] on a line of its own and its keys below";
    fail(given_.file, problem);
  }

  void read_section(const std::string& section, const toml::node& node) {
    const toml::source_region& source = node.source();
    const toml::table* table = node.as_table();
    if (table == nullptr) {
      CaseProblem problem = at(source);
      problem.key = section;
      problem.value = value_text(source);
      problem.wrong = "is a section, not a key with a value";
      problem.allowed =
          fmt::format("[{0}] once, with keys like {0}.{1}", section, keys_of(section).front());
      problem.action = fmt::format("write [{}] on a line of its own and its keys below", section);
      fail(given_.file, problem);
    }
    given_.section_lines[section] = source.begin.line;
    for (const auto& [name, child] : *table)
      read_key(section, std::string(name.str()), name.source(), child);
  }

  void read_key(const std::string& section, const std::string& name,
                const toml::source_region& name_source, const toml::node& node) {
    const Key* key = find_key(section, name);
    if (key == nullptr) fail_unknown(section, name, name_source);
    GivenValue given;
    given.line = node.source().begin.line;
    given.column = node.source().begin.column;
    given.text = value_text(node.source());
    given.value = value_of(*key, node, given);
    given_.values[key] = given;
  }

  [[noreturn]] void fail_unknown(const std::string& section, const std::string& name,
                                 const toml::source_region& source) const {
    CaseProblem problem = at(source);
    problem.key = section.empty() ? name : section + "." + name;
    if (problem.key.size() > 80) problem.key = problem.key.substr(0, 77) + "...";
    problem.wrong = "is not a key of a case file";
    std::vector<std::string> here = keys_of(section);
    if (section.empty())
      for (const Section& known : case_sections())
        if (!known.name.empty()) here.push_back(known.name);
    problem.allowed = joined(here);
    const std::string near = nearest_name(name, here);
    const std::string elsewhere = section_that_has(name);
    if (!elsewhere.empty())
      problem.action = fmt::format("move it to [{}]", elsewhere);
    else if (!near.empty())
      problem.action = fmt::format("did you mean `{}`? Write that, or remove the key", near);
    else
      problem.action = "remove it; docs/case-file.md lists all keys";
    fail(given_.file, problem);
  }

  static std::vector<std::string> keys_of(const std::string& section) {
    std::vector<std::string> names;
    for (const Key& key : case_keys())
      if (key.section == section) names.push_back(key.name);
    return names;
  }

  static std::string section_that_has(const std::string& name) {
    for (const Key& key : case_keys())
      if (key.name == name && !key.section.empty() && key.section.find('.') == std::string::npos)
        return key.section;
    return "";
  }

  [[noreturn]] void fail_value(const Key& key, const GivenValue& given,
                               const std::string& wrong) const {
    CaseProblem problem;
    problem.line = given.line;
    problem.column = given.column;
    problem.key = key.path();
    problem.value = given.text;
    problem.wrong = wrong;
    problem.allowed = allowed_values(key);
    problem.action = key.kind == KeyKind::word || key.kind == KeyKind::words
                         ? "write one of these names in quotes"
                         : fmt::format("correct it, for instance {}", instance_of(key));
    fail(given_.file, problem);
  }

  static std::string instance_of(const Key& key) {
    const std::string value =
        key.example.empty() ? toml_text(key.get(default_case())) : key.example;
    if (!value.empty()) return fmt::format("`{} = {}`", key.name, value);
    if (key.kind == KeyKind::text) return fmt::format("`{} = \"points.csv\"`", key.name);
    return fmt::format("`{} = {}`", key.name, key.kind == KeyKind::pair ? "[0.2, 0.2]" : "2.0");
  }

  KeyValue value_of(const Key& key, const toml::node& node, const GivenValue& given) const {
    switch (key.kind) {
      case KeyKind::text:
        return title_of(key, node, given);
      case KeyKind::word:
        return word_of(key, node, given);
      case KeyKind::words:
        return words_of(key, node, given);
      case KeyKind::number:
        return number_of(key, node, given);
      case KeyKind::integer:
        if (!node.is_integer()) fail_value(key, given, kind_is(node) + " is no whole number");
        return number_of(key, node, given);
      case KeyKind::boolean:
        if (!node.is_boolean())
          fail_value(key, given, kind_is(node) + " is neither true nor false");
        return node.value_or(false);
      case KeyKind::pair:
      case KeyKind::triple:
      case KeyKind::numbers:
        return numbers_of(key, node, given);
    }
    return {};
  }

  std::string title_of(const Key& key, const toml::node& node, const GivenValue& given) const {
    if (!node.is_string()) fail_value(key, given, kind_is(node) + " is no text");
    const std::string text = node.value_or(std::string());
    if (text.size() > longest_title)
      fail_value(key, given, fmt::format("is longer than {} characters", longest_title));
    for (const char c : text)
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
        fail_value(key, given, "has a line break or another control character");
    return text;
  }

  std::string word_of(const Key& key, const toml::node& node, const GivenValue& given) const {
    if (!node.is_string()) fail_value(key, given, kind_is(node) + " is no text");
    const std::string word = node.value_or(std::string());
    if (std::find(key.words.begin(), key.words.end(), word) != key.words.end()) return word;
    const std::string near = nearest_name(word, key.words);
    fail_value(key, given,
               near.empty() ? "is not known" : fmt::format("is not known (near: {})", near));
  }

  std::vector<std::string> words_of(const Key& key, const toml::node& node,
                                    const GivenValue& given) const {
    const toml::array* array = node.as_array();
    if (array == nullptr) fail_value(key, given, kind_is(node) + " is no list");
    if (array->empty()) fail_value(key, given, "is an empty list");
    std::vector<std::string> words;
    for (const toml::node& item : *array) {
      const std::string word = word_of(key, item, given);
      if (std::find(words.begin(), words.end(), word) != words.end())
        fail_value(key, given, fmt::format("names {} twice", word));
      words.push_back(word);
    }
    return words;
  }

  double number_of(const Key& key, const toml::node& node, const GivenValue& given) const {
    if (!node.is_number()) fail_value(key, given, kind_is(node) + " is no number");
    const double value = node.value_or(0.0);
    if (std::isnan(value)) fail_value(key, given, "is not a number");
    if (std::isinf(value) && !key.bounds.contains(value))
      fail_value(key, given, "is infinite, which makes no sense here");
    if (!key.bounds.contains(value)) fail_value(key, given, "is out of bounds");
    // -0.0 would turn up with its sign in every table.
    return value == 0.0 ? 0.0 : value;
  }

  std::vector<double> numbers_of(const Key& key, const toml::node& node,
                                 const GivenValue& given) const {
    const toml::array* array = node.as_array();
    const std::size_t expected = key.kind == KeyKind::pair     ? 2
                                 : key.kind == KeyKind::triple ? 3
                                                               : 0;
    if (array == nullptr && expected > 0)
      fail_value(key, given,
                 fmt::format("{} is no list of {} numbers", kind_is(node),
                             expected == 2 ? "two" : "three"));
    if (array == nullptr) return {number_of(key, node, given)};
    if (array->empty()) fail_value(key, given, "is an empty list");
    if (expected > 0 && array->size() != expected)
      fail_value(key, given, fmt::format("has {} entries, not {}", array->size(), expected));
    if (array->size() > longest_list)
      fail_value(key, given, fmt::format("has more than {} entries", longest_list));
    std::vector<double> numbers;
    for (const toml::node& item : *array) {
      GivenValue entry = given;
      entry.line = item.source().begin.line;
      entry.column = item.source().begin.column;
      entry.text = value_text(item.source());
      numbers.push_back(number_of(key, item, entry));
    }
    return numbers;
  }

  static std::string kind_is(const toml::node& node) {
    switch (node.type()) {
      case toml::node_type::table:
        return "a section";
      case toml::node_type::array:
        return "a list";
      case toml::node_type::string:
        return "a text";
      case toml::node_type::integer:
        return "a whole number";
      case toml::node_type::floating_point:
        return "a number with a fraction or exponent";
      case toml::node_type::boolean:
        return "true or false";
      default:
        return "a date or time";
    }
  }

  static CaseProblem at(const toml::source_region& source) {
    CaseProblem problem;
    problem.line = source.begin.line;
    problem.column = source.begin.column;
    return problem;
  }

  std::string line_text(unsigned line) const {
    if (line == 0 || line > lines_.size()) return "";
    return printable(lines_[line - 1]);
  }

  /// The value as typed: to the end of its region, or of the line if it goes on.
  std::string value_text(const toml::source_region& source) const {
    if (source.begin.line == 0 || source.begin.line > lines_.size()) return "";
    const std::string& line = lines_[source.begin.line - 1];
    const std::size_t begin = std::min<std::size_t>(source.begin.column - 1, line.size());
    const bool one_line = source.end.line == source.begin.line;
    const std::size_t end =
        one_line ? std::min<std::size_t>(source.end.column - 1, line.size()) : line.size();
    return printable(line.substr(begin, end > begin ? end - begin : std::string::npos)) +
           (one_line ? "" : " ...");
  }

  /// Shortened, and without anything that would upset a terminal.
  static std::string printable(std::string text) {
    while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.pop_back();
    const bool cut = text.size() > 60;
    if (cut) text.resize(57);
    for (char& c : text)
      if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
    return cut ? text + "..." : text;
  }

  const std::string& text_;
  std::vector<std::string> lines_;
  GivenCase given_;
};

}  // namespace

namespace {

void set_values(Case& input, const std::map<const Key*, GivenValue>& values) {
  for (const Key& key : case_keys()) {
    const auto found = values.find(&key);
    if (found != values.end()) key.set(input, found->second.value);
  }
}

/// Reads the files that the case names; their paths are relative to the case file.
void read_files(const GivenCase& given, Case& input) {
  const std::filesystem::path folder = std::filesystem::path(given.file).parent_path();
  const auto fill = [&](std::optional<Lattice>& values, int columns) {
    if (values) values = read_lattice((folder / values->file).string(), values->file, columns);
  };
  fill(input.undeformed_distance.values, 1);
  fill(input.rolling.extra_slip_values, 2);
  // Meshes are read when the bodies are made; that they are there is said at once.
  for (const char* body : {"wheel", "rail"}) {
    const GivenValue* mesh = given.find(body, "mesh");
    std::error_code error;
    if (mesh == nullptr ||
        std::filesystem::is_regular_file(folder / std::get<std::string>(mesh->value), error))
      continue;
    CaseProblem problem = problem_at(std::string(body) + ".mesh", *mesh);
    problem.wrong = "there is no such mesh file";
    problem.allowed = "a gmsh mesh (.msh), its path relative to the case file";
    problem.action = "check the path, or leave the key out: the program then meshes the body";
    fail(given.file, problem);
  }
}

}  // namespace

Case parse_case(const std::string& text, const std::string& name) {
  if (text.size() > largest_file)
    fail_whole(name, "is larger than 1 MB, so it is no case file", "give a case file in TOML");
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    fail_whole(name, "is empty", "fill it in; `rollfem new-case` prints a template");
  const GivenCase given = Reader(text, name).read();
  check_together(given);
  check_problem(given);
  Case input = default_case();
  set_values(input, given.values);
  for (const GivenEntry& entry : given.entries) {
    begin_entry(input, entry.section);
    set_values(input, entry.values);
  }
  input.file = name;
  input.text = text;
  if (input.title.empty()) input.title = std::filesystem::path(name).stem().string();
  complete(given, input);
  complete_track(given, input);
  check_geometry(given, input);
  check_values(given, input);
  read_files(given, input);
  return input;
}

Case read_case(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
    fail_whole(path, "there is no such file", "check the path; cases/ holds examples");
  if (fs::is_directory(status))
    fail_whole(path, "is a folder, not a case file", "name a .toml file in it");
  if (!fs::is_regular_file(status))
    fail_whole(path, "is not a regular file", "save the case in a file and name that");
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error && size > largest_file)
    fail_whole(path, "is larger than 1 MB, so it is no case file", "give a case file in TOML");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file && size > 0) text << file.rdbuf();
  if (!file || !text) fail_whole(path, "cannot be read", "check the permissions of the file");
  return parse_case(text.str(), path);
}

}  // namespace rollfem::contact

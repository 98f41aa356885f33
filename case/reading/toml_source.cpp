// SPDX-License-Identifier: LGPL-2.1-or-later
#include "case/reading/toml_source.hpp"

#include "base/text_fields.hpp"
#include "case/keys/case_text.hpp"

#include <boost/locale/utf.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace rollfem::contact {

namespace {

std::string for_message(std::string_view text) {
  return printable(text.substr(0, text.find_last_not_of(" \r") + 1), 60);
}

constexpr std::size_t longest_key = 64;

struct Wording {
  std::string_view said;  ///< part of the message of toml++
  std::string_view meant;
};

constexpr std::string_view values =
    "expected a number, true or false, a list in brackets, or a string in straight quotes";
constexpr std::string_view escapes =
    "unknown escape after a backslash; write \\\\, or put the string in 'single quotes'";
constexpr Wording wordings[] = {
    {"could not determine value type", values},
    {"boolean: expected", values},
    {"expected 'inf'", values},
    {"expected 'nan'", values},
    {"expected value, saw", "expected a value"},
    {"floating-point: expected decimal digit", "expected a digit (0.5, not .5; 5.0, not 5.)"},
    {"decimal integer: expected digit", "expected a digit or the end of the number"},
    {"expected a comment or whitespace", "expected the end of the line or a comment"},
    {"expected '='", "expected '=' after a key"},
    {"bare key starting character",
     "expected a key, of the letters A to Z and a to z, digits, '_' and '-'"},
    {"keys, tables, whitespace or comments", "expected a key, a [section] or a comment"},
    {"table header: expected ']'", "expected ']' after the name of a section"},
    {"comma or closing ']'", "expected ',' or ']' in a list"},
    {"value or closing ']'", "expected a value or ']' in a list"},
    {"array: encountered end-of-file", "expected ',' or ']' in a list, found the end of the file"},
    {"key or closing '}'", "expected ',' or '}' between braces"},
    {"string: encountered end-of-file",
     "expected the three closing quotation marks of a string, found the end of the file"},
    {"escape sequence", escapes},
    {"line-ending backslashes", escapes},
    {"unicode scalar sequence",
     "\\u and \\U need 4 and 8 hexadecimal digits of a character; for a backslash write \\\\, or "
     "put the string in 'single quotes'"},
    {"maximum nested value depth", "nested more than 64 deep"},
};

/// The text found by toml++, as the end of a sentence; "" if unknown.
std::string found_instead(std::string_view description) {
  const std::size_t at = description.rfind(", saw ");
  if (at == std::string_view::npos) return "";
  const std::string saw(description.substr(at + 6));
  if (saw == "'\\n'" || saw == "'\\r'") return ", found the end of the line";
  const bool ascii = std::all_of(saw.begin(), saw.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  return ascii ? ", found " + printable(saw, longest_name)
               : ", found a character that is not ASCII";
}

bool has_control_character(const std::string& line) {
  return std::any_of(line.begin(), line.end(), [&](const char& c) {
    const bool ends_line = c == '\r' && &c == &line.back();
    return (static_cast<unsigned char>(c) < 0x20 && c != '\t' && !ends_line) || c == 0x7f;
  });
}

std::optional<TomlFault> find_fault_of_encoding(const std::vector<std::string>& lines) {
  for (unsigned number = 1; number <= lines.size(); ++number) {
    const std::string& line = lines[number - 1];
    unsigned column = 1;
    for (auto at = line.begin(); at != line.end(); ++column) {
      const auto byte = static_cast<unsigned char>(*at);
      if (!boost::locale::utf::is_valid_codepoint(
              boost::locale::utf::utf_traits<char>::decode(at, line.end())))
        return TomlFault{number, column,
                         fmt::format("the file is not UTF-8: found byte 0x{:02X}", byte)};
    }
  }
  return {};
}

/// End of the quoted text or comment that begins at `at`; `at` if neither begins there.
std::size_t end_of_words(std::string_view text, std::size_t at) {
  if (text[at] == '#') return std::min(text.find('\n', at), text.size());
  const char quote = text[at];
  if (quote != '"' && quote != '\'') return at;
  const std::string three(3, quote);
  const bool of_lines = text.substr(at, 3) == three;
  const std::string closing = of_lines ? three : std::string(1, quote);
  for (at += closing.size(); at < text.size(); ++at) {
    if (!of_lines && text[at] == '\n') return at;
    if (text.substr(at, closing.size()) == closing) {
      // A multi-line text may end with up to two additional quotes.
      const std::size_t last = at + (of_lines ? 5 : 1);
      for (at += closing.size(); at < std::min(last, text.size()) && text[at] == quote;) ++at;
      return at;
    }
    if (text[at] == '\\' && quote == '"') ++at;
  }
  return text.size();
}

/// The position after the first 64 dots of one key; the end of the text if there is none.
std::size_t find_long_key(std::string_view text) {
  std::size_t dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = end_of_words(text, at);
    if (end > at) {
      at = end;
      continue;
    }
    const char c = text[at++];
    if (c == '.' && text.substr(at, 1) != ".") ++dots;
    if (dots == longest_key) return at;
    if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) dots = 0;
  }
  return text.size();
}

constexpr std::size_t longest_text = 200;

std::string instance_of(const Key& key) {
  const std::string value = key.example.empty() ? toml_text(key.get(Case())) : key.example;
  if (!value.empty()) return fmt::format("`{} = {}`", key.name, value);
  if (key.kind == KeyKind::text) return fmt::format("`{} = \"points.csv\"`", key.name);
  if (key.kind == KeyKind::pair) return fmt::format("`{} = [0.2, 0.2]`", key.name);
  const double plain = key.unit == "N"      ? 80e3
                       : key.unit == "MPa"  ? 1000.0
                       : key.unit == "mm/s" ? 30e3
                                            : 2.0;
  const Bounds& of = key.bounds;
  return fmt::format("`{} = {}`", key.name, toml_text(of.contains(plain) ? plain : 0.5 * of.upper));
}

std::string kind_is(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a section";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a string";
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

/// One value of one key, or an item of a list with its own position in the file.
class ValueReader {
 public:
  ValueReader(const TomlSource& source, const Key& key, const KnownNames& known,
              const toml::node& node)
      : source_(source), key_(key), known_(known), node_(node) {
    given_.line = node.source().begin.line;
    given_.column = node.source().begin.column;
    given_.text = source.value(node.source());
  }

  GivenValue read() {
    given_.value = value();
    return std::move(given_);
  }

 private:
  [[noreturn]] void fail_value(const std::string& wrong) const {
    const bool words = key_.kind == KeyKind::word || key_.kind == KeyKind::words;
    source_.fail({given_.line, given_.column, key_.path(), given_.text, wrong,
                  allowed_values(key_, known_),
                  words ? "write one of these names in quotes"
                        : fmt::format("correct it, for instance {}", instance_of(key_))});
  }

  KeyValue value() const {
    switch (key_.kind) {
      case KeyKind::text:
        return text();
      case KeyKind::word:
        return word_of(node_);
      case KeyKind::words:
        return words();
      case KeyKind::integer:
        if (!node_.is_integer()) fail_value("expected a whole number, got " + kind_is(node_));
        return number();
      case KeyKind::number:
        return number();
      case KeyKind::boolean:
        if (!node_.is_boolean()) fail_value("expected true or false, got " + kind_is(node_));
        return node_.value_or(false);
      case KeyKind::pair:
        return numbers("two", 2);
      case KeyKind::triple:
        return numbers("three", 3);
      case KeyKind::numbers:
        return node_.is_array() ? numbers("", 0) : std::vector<double>{number()};
      case KeyKind::lean:
        if (node_.is_string()) return lean();
        return number();
    }
    return {};
  }

  std::string text() const {
    if (!node_.is_string()) fail_value("expected a string in quotes, got " + kind_is(node_));
    const std::string text = node_.value_or(std::string());
    if (text.size() > longest_text)
      fail_value(fmt::format("is longer than {} characters", longest_text));
    for (const char c : text)
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
        fail_value("has a line break or another control character");
    return text;
  }

  std::string word_of(const toml::node& node) const {
    if (!node.is_string()) fail_value("expected a string in quotes, got " + kind_is(node));
    const std::string word = node.value_or(std::string());
    const std::vector<std::string>& words = key_.choices(known_);
    if (words.empty() || std::find(words.begin(), words.end(), word) != words.end()) return word;
    const std::string near = nearest_name(word, words);
    fail_value(near.empty() ? "is not known" : fmt::format("is not known (near: {})", near));
  }

  std::string lean() const {
    const std::string given = text();
    if (ratio_of(given)) return given;
    if (std::find(key_.words.begin(), key_.words.end(), given) == key_.words.end())
      fail_value("is not a ratio of 1 to a number above 1");
    return given;
  }

  /// The value as a list.
  const toml::array& list(const std::string& what) const {
    const toml::array* array = node_.as_array();
    if (array == nullptr) fail_value("expected a list" + what + ", got " + kind_is(node_));
    if (array->empty() && !key_.empty) fail_value("is an empty list");
    return *array;
  }

  std::vector<std::string> words() const {
    std::vector<std::string> words;
    for (const toml::node& item : list("")) {
      const std::string word = word_of(item);
      if (std::find(words.begin(), words.end(), word) != words.end())
        fail_value(fmt::format("names {} twice", word));
      words.push_back(word);
    }
    return words;
  }

  double number() const {
    if (!node_.is_number()) fail_value("expected a number, got " + kind_is(node_));
    const double value = node_.value_or(0.0);
    if (std::isnan(value) && !key_.bounds.none) fail_value("is not a number");
    if (std::isinf(value) && !key_.bounds.contains(value))
      fail_value("is infinite, which is not allowed here");
    if (!key_.bounds.contains(value)) fail_value("is out of bounds");
    // -0.0 would keep its sign in every table.
    return value == 0.0 ? 0.0 : value;
  }

  /// `count` in words and as a number, 0 for any number of entries.
  std::vector<double> numbers(const std::string& words, std::size_t count) const {
    const toml::array& array = list(" of " + words + " numbers");
    if (count > 0 && array.size() != count)
      fail_value(fmt::format("has {} entries, not {}", array.size(), count));
    if (array.size() > longest_list)
      fail_value(fmt::format("has more than {} entries", longest_list));
    std::vector<double> numbers;
    for (const toml::node& item : array)
      numbers.push_back(ValueReader(source_, key_, known_, item).number());
    return numbers;
  }

  const TomlSource& source_;
  const Key& key_;
  const KnownNames& known_;
  const toml::node& node_;
  GivenValue given_;
};

}  // namespace

std::optional<TomlFault> find_toml_fault(const TomlSource& source) {
  if (const auto fault = find_fault_of_encoding(source.lines())) return fault;
  const std::string_view text = source.text();
  const std::string_view before = text.substr(0, find_long_key(text));
  if (before.size() == text.size()) return {};
  const auto lines = std::count(before.begin(), before.end(), '\n');
  return TomlFault{1 + static_cast<unsigned>(lines),
                   static_cast<unsigned>(before.size() - before.rfind('\n')),
                   fmt::format("nested more than {} deep", longest_key)};
}

std::string meaning_of(std::string_view description, const std::string& line) {
  if (description.find("control characters other than") != std::string_view::npos)
    return has_control_character(line)
               ? "control characters are not allowed in texts and comments"
               : "expected the closing quotation mark of a string, found the end of the line";
  for (const Wording& wording : wordings)
    if (description.find(wording.said) != std::string_view::npos)
      return std::string(wording.meant) + found_instead(description);
  constexpr std::string_view beginning = "Error while parsing ";
  if (description.substr(0, beginning.size()) == beginning)
    description.remove_prefix(beginning.size());
  return printable(description, 200);
}

TomlSource::TomlSource(const std::string& text, std::string file, bool option)
    : text_(text), file_(std::move(file)), option_(option) {
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines_.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
}

void TomlSource::fail(CaseProblem problem) const {
  if (option_) problem.line = 0, problem.key.clear(), problem.value.clear();
  contact::fail(file_, problem);
}

bool TomlSource::looks_like_case() const {
  std::size_t keys = 0, others = 0;
  for (const std::string& line : lines_) {
    const std::string_view text = trimmed(line);
    const std::size_t word = text.find_first_not_of(
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.\"' ");
    if (text.empty() || text.front() == '#') continue;
    if (text.front() == '[' || (word != std::string_view::npos && word > 0 && text[word] == '='))
      ++keys;
    else if (std::isalpha(static_cast<unsigned char>(text.front())) != 0)
      ++others;
  }
  return keys + 1 >= others;  // one line may be wrong
}

std::string TomlSource::line(unsigned number) const {
  return number == 0 || number > lines_.size() ? "" : for_message(lines_[number - 1]);
}

std::string TomlSource::value(const toml::source_region& region) const {
  if (region.begin.line == 0) return for_message(text_);
  if (region.begin.line > lines_.size()) return "";
  const std::string& line = lines_[region.begin.line - 1];
  const std::size_t begin = std::min<std::size_t>(region.begin.column - 1, line.size());
  const bool one_line = region.end.line == region.begin.line;
  const std::size_t end =
      one_line ? std::min<std::size_t>(region.end.column - 1, line.size()) : line.size();
  return for_message(line.substr(begin, end > begin ? end - begin : std::string::npos)) +
         (one_line ? "" : " ...");
}

GivenValue read_value(const TomlSource& source, const Key& key, const KnownNames& known,
                      const toml::node& node) {
  return ValueReader(source, key, known, node).read();
}

GivenValue checked_value(const std::string& file, const Key& key, const KeyValue& value) {
  const auto read = [&](const toml::node& node) {
    return read_value(TomlSource(toml_text(value), file), key, {}, node);
  };
  if (const auto* text = std::get_if<std::string>(&value)) return read(toml::value(*text));
  if (const auto* is = std::get_if<bool>(&value)) return read(toml::value(*is));
  if (const auto* list = std::get_if<std::vector<double>>(&value)) {
    toml::array numbers;
    for (const double number : *list) numbers.push_back(number);
    return read(numbers);
  }
  const double number = std::get<double>(value);
  return key.kind == KeyKind::integer ? read(toml::value(static_cast<std::int64_t>(number)))
                                      : read(toml::value(number));
}

}  // namespace rollfem::contact

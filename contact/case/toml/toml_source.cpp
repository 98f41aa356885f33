// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/toml/toml_source.hpp"

#include "contact/base/text_fields.hpp"

#include <boost/locale/utf.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

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

TomlSource::TomlSource(const std::string& text, std::string file)
    : text_(text), file_(std::move(file)) {
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines_.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
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

}  // namespace rollfem::contact

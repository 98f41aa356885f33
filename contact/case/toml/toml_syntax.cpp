// The grammar is that of https://toml.io/en/v1.0.0; what is read is only walked over.
#include "contact/case/toml/toml_syntax.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace rollfem::contact {

namespace {

/// toml++ follows nested values and dotted keys by recursion; a case file has two levels.
constexpr int deepest = 64;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

struct Departure {
  std::size_t at;
  std::string wrong;
};

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}
bool is_of_bare_key(char c) {
  return is_letter_or_digit(c) || c == '_' || c == '-';
}
bool is_of_scalar(char c) {
  return is_of_bare_key(c) || c == '+' || c == '.' || c == ':';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
int hex_digit(char c) {
  if (is_digit(c)) return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}
bool is_surrogate(std::uint32_t code) {
  return code >= 0xD800 && code <= 0xDFFF;
}

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;  ///< 0: the bytes are no UTF-8
};

/// The first character of a text that is not empty.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < bytes) return {};
  std::uint32_t code = first & (0xFFu >> (bytes + 1));
  for (std::size_t k = 1; k < bytes; ++k) {
    if ((byte(k) & 0xC0u) != 0x80u) return {};
    code = (code << 6) | (byte(k) & 0x3Fu);
  }
  constexpr std::uint32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < smallest[bytes] || is_surrogate(code) || code > 0x10FFFF) return {};
  return {code, bytes};
}

class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {}

  void document() {
    if (looking_at(byte_order_mark)) at_ += byte_order_mark.size();
    while (!at_end()) {
      blanks();
      if (!at_end() && !at_line_break() && peek() != '#') {
        if (peek() == '[')
          header();
        else
          pair(0);
        blanks();
      }
      if (peek() == '#') comment();
      if (!at_end() && !line_break()) fail("expected the end of the line or a comment");
    }
  }

 private:
  bool at_end() const { return at_ >= text_.size(); }
  /// '\0' at the end.
  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  bool looking_at(std::string_view expected) const {
    return text_.substr(at_, expected.size()) == expected;
  }
  bool at_line_break() const { return peek() == '\n' || looking_at("\r\n"); }

  std::string found() const {
    if (at_end()) return "the end of the file";
    if (at_line_break()) return "the end of the line";
    const Character here = first_character(text_.substr(at_));
    if (here.bytes == 0)
      return fmt::format("byte 0x{:02X}", static_cast<unsigned char>(text_[at_]));
    return here.code > 0x20 && here.code < 0x7F ? fmt::format("'{}'", text_[at_])
                                                : fmt::format("U+{:04X}", here.code);
  }
  [[noreturn]] void fail_with(const std::string& wrong) const { throw Departure{at_, wrong}; }
  [[noreturn]] void fail(const std::string& expected) const {
    fail_with(expected + ", found " + found());
  }

  void blanks() {
    while (peek() == ' ' || peek() == '\t') ++at_;
  }
  bool line_break() {
    if (!at_line_break()) return false;
    at_ += peek() == '\n' ? 1 : 2;
    return true;
  }
  /// Blanks, line breaks and comments, as between the items of a list.
  void blank_lines() {
    for (;;) {
      blanks();
      if (peek() == '#')
        comment();
      else if (!line_break())
        return;
    }
  }
  void comment() {
    while (!at_end() && !at_line_break()) character("comments");
  }

  /// One character of a text or a comment.
  void character(const char* where) {
    const Character here = first_character(text_.substr(at_));
    if (here.bytes == 0) fail_with("the file is not UTF-8: found " + found());
    if ((here.code < 0x20 && here.code != '\t') || here.code == 0x7F)
      fail(fmt::format("control characters are not allowed in {}", where));
    at_ += here.bytes;
  }

  void check_depth(int depth) const {
    if (depth > deepest) fail_with(fmt::format("nested more than {} deep", deepest));
  }

  void key() {
    for (int parts = 1;; ++parts) {
      check_depth(parts);
      if (peek() == '"' || peek() == '\'') {
        if (looking_at("\"\"\"") || looking_at("'''"))
          fail_with("a key must not be a multi-line string");
        line_text(peek());
      } else {
        if (!is_of_bare_key(peek()))
          fail("expected a key, of the letters A to Z and a to z, digits, '_' and '-'");
        while (is_of_bare_key(peek())) ++at_;
      }
      blanks();
      if (peek() != '.') return;
      ++at_;
      blanks();
    }
  }

  /// [section] or [[section]]
  void header() {
    ++at_;
    const bool repeated = peek() == '[';
    if (repeated) ++at_;
    blanks();
    key();
    if (peek() != ']') fail("expected ']' after the name of a section");
    ++at_;
    if (!repeated) return;
    if (peek() != ']') fail("expected ']]' after the name of a section");
    ++at_;
  }

  void pair(int depth) {
    key();
    if (peek() != '=') fail("expected '=' after a key");
    ++at_;
    blanks();
    value(depth);
  }

  void value(int depth) {
    check_depth(depth);
    const char first = peek();
    if (first == '[')
      list(depth);
    else if (first == '{')
      inline_table(depth);
    else if (looking_at("\"\"\"") || looking_at("'''"))
      text_of_lines(first);
    else if (first == '"' || first == '\'')
      line_text(first);
    else
      scalar();
  }

  void list(int depth) {
    ++at_;
    for (;;) {
      blank_lines();
      if (peek() == ']') break;
      value(depth + 1);
      blank_lines();
      if (peek() == ']') break;
      if (peek() != ',') fail("expected ',' or ']' in a list");
      ++at_;
    }
    ++at_;
  }

  void inline_table(int depth) {
    ++at_;
    blanks();
    if (peek() != '}') {
      for (;;) {
        pair(depth + 1);
        blanks();
        if (peek() == '}') break;
        if (peek() != ',') fail("expected ',' or '}' between braces");
        ++at_;
        blanks();
      }
    }
    ++at_;
  }

  /// A number, a date, true or false, as far as its characters go.
  void scalar() {
    const std::size_t begin = at_;
    while (is_of_scalar(peek())) ++at_;
    if (at_ == begin) fail("expected a value");
    // Between date and time a blank may stand.
    const std::string_view word = text_.substr(begin, at_ - begin);
    const bool date = word.size() == 10 && word[4] == '-' && word[7] == '-';
    if (!date || peek() != ' ' || !is_digit(peek(1))) return;
    ++at_;
    while (is_of_scalar(peek())) ++at_;
  }

  /// A text in quotes, single or double, that ends on its line.
  void line_text(char quote) {
    ++at_;
    while (peek() != quote) {
      if (at_end() || at_line_break()) fail("expected the closing quotation mark of a string");
      if (quote == '"' && peek() == '\\')
        escape();
      else
        character("texts");
    }
    ++at_;
  }

  void text_of_lines(char quote) {
    const std::string ends(3, quote);
    at_ += 3;
    while (!looking_at(ends)) {
      if (at_end()) fail("expected the three closing quotation marks of a string");
      if (line_break()) continue;
      if (quote == '\'' || peek() != '\\')
        character("texts");
      else if (!continued_line())
        escape();
    }
    at_ += 3;
    // Up to two more belong to the text.
    for (int more = 0; more < 2 && peek() == quote; ++more) ++at_;
  }

  /// A backslash at the end of a line, which leaves out the blanks and lines that follow.
  bool continued_line() {
    const std::size_t end = std::min(text_.find_first_not_of(" \t", at_ + 1), text_.size());
    if (text_.substr(end, 1) != "\n" && text_.substr(end, 2) != "\r\n") return false;
    at_ = end;
    while (line_break()) blanks();
    if (static_cast<unsigned char>(peek()) >= 0x80)
      fail_with(
          "a continued line must not begin with a non-ASCII letter here; write the string on one "
          "line");
    return true;
  }

  void escape() {
    const char kind = peek(1);
    if (kind == 'u' || kind == 'U') {
      const std::size_t digits = kind == 'u' ? 4 : 8;
      std::uint32_t code = 0;
      for (std::size_t k = 0; k < digits; ++k) {
        const int digit = hex_digit(peek(2 + k));
        if (digit < 0) fail_with(fmt::format("\\{} needs {} hexadecimal digits", kind, digits));
        code = code << 4 | static_cast<std::uint32_t>(digit);
      }
      if (is_surrogate(code) || code > 0x10FFFF)
        fail_with(fmt::format("\\{} gives U+{:04X}, which is not a character", kind, code));
      at_ += 2 + digits;
      return;
    }
    if (kind == '\0' || std::string_view("btnfr\"\\").find(kind) == std::string_view::npos)
      fail_with(
          "unknown escape after a backslash; write \\\\, or put the string in 'single quotes'");
    at_ += 2;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

TomlFault fault_at(std::string_view text, const Departure& departure) {
  const std::string_view before = text.substr(0, departure.at);
  TomlFault fault;
  fault.line = 1 + static_cast<unsigned>(std::count(before.begin(), before.end(), '\n'));
  std::string_view line = before.substr(before.rfind('\n') + 1);
  if (fault.line == 1 && line.substr(0, byte_order_mark.size()) == byte_order_mark)
    line.remove_prefix(byte_order_mark.size());
  for (const char c : line) fault.column += (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
  fault.wrong = departure.wrong;
  return fault;
}

}  // namespace

std::optional<TomlFault> find_toml_fault(std::string_view text) {
  try {
    Walk(text).document();
  } catch (const Departure& departure) {
    return fault_at(text, departure);
  }
  return {};
}

}  // namespace rollfem::contact

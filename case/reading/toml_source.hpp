// SPDX-License-Identifier: LGPL-2.1-or-later
// The text of a case file, for messages that quote it, the faults of invalid TOML in words, and
// values checked against the declarations of their keys; private to case.
#pragma once

#include "case/checks/case_checks.hpp"
#include "case/reading/toml_library.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rollfem::contact {

class TomlSource {
 public:
  TomlSource(const std::string& text, std::string file, bool option = false);

  const std::string& file() const { return file_; }
  /// Whether `file` is a change by --set as typed: it contains key and value and has no lines.
  bool is_option() const { return option_; }
  /// Throws InputError with the message, which leaves out what `file` shows already.
  [[noreturn]] void fail(CaseProblem problem) const;
  const std::string& text() const { return text_; }
  const std::vector<std::string>& lines() const { return lines_; }
  /// Whether most lines that begin with a letter are keys with values, or [sections]: messages
  /// never quote a line of other files.
  bool looks_like_case() const;

  /// A line, from 1, shortened.
  std::string line(unsigned number) const;
  /// A value as typed, shortened: to the end of its region, or of the line if it continues. The
  /// whole text for a value without a place in it.
  std::string value(const toml::source_region& region) const;

 private:
  const std::string& text_;
  std::string file_;
  bool option_;
  std::vector<std::string> lines_;
};

struct TomlFault {
  unsigned line = 1;    ///< from 1
  unsigned column = 1;  ///< from 1, in characters
  std::string wrong;
};

/// Faults checked before toml++: bytes that are not UTF-8, which it does not locate exactly, and
/// keys of more than 64 parts, because it limits the nesting of values but not of keys, whose
/// tables it destroys recursively. None for most invalid TOML.
std::optional<TomlFault> find_toml_fault(const TomlSource& source);

/// The message of toml++ about a fault on that line, in words for an author of case files who does
/// not know TOML's grammar.
std::string meaning_of(std::string_view description, const std::string& line);

inline constexpr std::size_t longest_list = 1000;

/// Throws InputError when the value is not
/// allowed for the key.
GivenValue read_value(const TomlSource& source, const Key& key, const KnownNames& known,
                      const toml::node& node);

/// The same for a value that stands in no file; messages use `file`.
GivenValue checked_value(const std::string& file, const Key& key, const KeyValue& value);

}  // namespace rollfem::contact

// SPDX-License-Identifier: LGPL-2.1-or-later
// Delimited text: lines, fields and numbers, independent of the locale.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rollfem::contact {

/// Without blanks and carriage returns at both ends.
std::string_view trimmed(std::string_view text);

/// What stands before a comment, which one of `marks` begins.
std::string_view without_comment(std::string_view line, std::string_view marks);

/// The lines of a text, trimmed: for (TextLines lines(text); lines.next();) ...
class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {}
  /// Goes on to the next line; false after the last.
  bool next();
  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }  ///< from 1

 private:
  std::string_view rest_, line_;
  std::size_t number_ = 0;
};

/// Fields of a line, views into it. Several separators in a row count as one, and those at the ends
/// as none.
std::vector<std::string_view> fields_of(std::string_view line, std::string_view separators);

/// Parts between one separator and the next, which may be empty: "1,,2" has three.
std::vector<std::string_view> parts_of(std::string_view line, std::string_view separators);

/// The finite decimal number that all of a field is, or none. `decimal_comma`: a comma stands for
/// the point.
std::optional<double> number_of(std::string_view field, bool decimal_comma = false);
std::optional<int> whole_number_of(std::string_view field);

/// Whether a text is a table of numbers, as far as a message may quote it: at least as many lines
/// begin with a number as do not; comments after one of `marks`, empty lines, settings with `=`
/// and the ends of sections (`point.begin`) count for neither. A file of passwords that is named by
/// mistake is none.
bool looks_like_table(std::string_view text, std::string_view marks);

/// The whole of a regular file. Throws FileError, which calls it `name`, where it cannot be read
/// or is larger than `largest` bytes.
std::string text_of_file(const std::string& path, const std::string& name, std::size_t largest);

/// A field for a message: at most 40 characters, ? in place of what cannot be printed.
std::string printable(std::string_view field);

// Suggestions for misspelt names.

/// The candidate that is nearest to a misspelt name; empty when none is near.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

/// "did you mean NAME? ", for a message; empty when none is near.
std::string did_you_mean(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace rollfem::contact

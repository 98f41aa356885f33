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

/// The text before a comment, which begins with one of `marks`.
std::string_view without_comment(std::string_view line, std::string_view marks);

/// The lines of a text, trimmed: for (TextLines lines(text); lines.next();) ...
class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {}
  /// Advances to the next line; false after the last.
  bool next();
  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }  ///< from 1

 private:
  std::string_view rest_, line_;
  std::size_t number_ = 0;
};

/// Fields of a line, views into it. Consecutive separators count as one, leading and trailing ones
/// are ignored.
std::vector<std::string_view> fields_of(std::string_view line, std::string_view separators);

/// Parts between one separator and the next, which may be empty: "1,,2" has three.
std::vector<std::string_view> parts_of(std::string_view line, std::string_view separators);

/// The finite decimal number that fills the whole field, otherwise none. `decimal_comma`: a comma
/// is the decimal mark.
std::optional<double> number_of(std::string_view field, bool decimal_comma = false);
std::optional<int> whole_number_of(std::string_view field);

/// Whether a text is a table of numbers that messages may quote: at least as many lines begin with
/// a number as do not, not counting comments after one of `marks`, empty lines, settings with `=`
/// and section limits (`point.begin`). A file of passwords named by mistake is never quoted.
bool looks_like_table(std::string_view text, std::string_view marks);

/// A regular file, opened for reading; it is open before it is examined, so that no other file can
/// take its place, and neither a device nor a FIFO is ever read or waited for.
class OpenedFile {
 public:
  /// Throws FileError, which calls the file `name` and advises `action`.
  OpenedFile(const std::string& path, const std::string& name, const std::string& action);
  ~OpenedFile();
  OpenedFile(const OpenedFile&) = delete;
  OpenedFile& operator=(const OpenedFile&) = delete;

  std::size_t size() const { return size_; }  ///< bytes, when it was opened
  /// The next bytes; fewer than `size` only at the end.
  std::size_t read(char* data, std::size_t size);
  [[noreturn]] void fail(const std::string& wrong);

 private:
  std::string name_, action_;
  int file_ = -1;
  std::size_t size_ = 0;
};

/// The whole of a regular file. Throws FileError, which calls it `name` and advises `action`, where
/// it cannot be read or is larger than `largest` bytes.
std::string text_of_file(const std::string& path, const std::string& name, std::size_t largest,
                         const std::string& action =
                             "check the path, which is relative to the case file, its size and "
                             "the permissions");

/// A text for a message: at most so many characters, ? for those that would disturb a terminal or
/// end the line.
std::string printable(std::string_view text, std::size_t longest = 40);
inline constexpr std::size_t longest_name = 80;

// Suggestions for misspelt names.

/// The candidate closest to a misspelt name; empty when none is close.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

/// "did you mean NAME? ", for a message; empty when none is close.
std::string did_you_mean(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace rollfem::contact

// SPDX-License-Identifier: LGPL-2.1-or-later
// The line format of CONTACT's input files: numbers first, then remarks, comments after %,
// continued on the next line if numbers are missing. This class knows the layout only.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rollfem::convert {

class InputLines {
 public:
  /// `name` represents the file in messages.
  InputLines(std::string_view text, std::string name);

  /// Whether only comments and empty lines are left.
  bool at_end() const { return next_ == lines_.size(); }

  /// One number for each of `names`, which messages quote, and up to `more` optional ones on the
  /// same line. Angles in degrees (`90d`) or rad (`1.5r`) are returned in rad; exponents may have a
  /// d, or no letter. Throws contact::InputError with file, line and the name of the missing
  /// number.
  std::vector<double> numbers(const std::vector<std::string>& names, std::size_t more = 0);

  /// The same into an array, whose further entries stay unchanged.
  template <std::size_t size>
  void read(std::array<double, size>& into, const std::vector<std::string>& names,
            std::size_t more = 0) {
    const std::vector<double> values = numbers(names, more);
    std::copy(values.begin(), values.end(), into.begin());
  }

  /// `count` numbers that share a name, on any number of lines.
  std::vector<double> array(const std::string& name, std::size_t count);

  /// A text in quotes, followed by the numbers of `names` and up to `more` optional ones.
  struct Named {
    std::string text;
    std::vector<double> numbers;
  };
  Named named(const std::string& what, const std::vector<std::string>& names, std::size_t more);

  /// `value` as a whole number (a count or a choice). Throws contact::InputError with `name` unless
  /// it lies from `least` to `most`.
  int integer(double value, const char* name, int least, int most) const;
  /// The same for the next number.
  int integer(const char* name, int least, int most) {
    return integer(numbers({name}).front(), name, least, most);
  }

  /// Line on which the last item read began, from 1.
  std::size_t line() const { return line_; }

  /// Throws contact::InputError for that line: `wrong` describes the problem, `action` the advice.
  [[noreturn]] void fail(const std::string& wrong, const std::string& action) const;

 private:
  struct Line {
    std::size_t number;
    std::vector<std::string> fields;
  };
  /// `count` numbers, the k-th named names[k]; a single name serves all.
  std::vector<double> take(std::size_t count, std::size_t more,
                           const std::vector<std::string>& names);
  /// Throws unless a line is left for `what`.
  void demand(const std::string& what) const;

  std::string name_;
  std::vector<Line> lines_;
  std::size_t next_ = 0, line_ = 0;
};

}  // namespace rollfem::convert

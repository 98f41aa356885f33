// SPDX-License-Identifier: LGPL-2.1-or-later
// The line format of CONTACT's input files: numbers first, then words for the reader, comments
// after %, continued on further lines where numbers are missing. Only the layout is known
// here.
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
  /// `name` stands in messages for the file.
  InputLines(std::string_view text, std::string name);

  /// Nothing but comments and empty lines is left.
  bool at_end() const { return next_ == lines_.size(); }

  /// One number for each of `names`, which messages quote, and up to `more` that may follow on the
  /// same line. Angles may be given in degrees (`90d`) or rad (`1.5r`) and come in rad; exponents
  /// may have a d, or no letter. Throws contact::InputError naming file, line and the number that
  /// is missing.
  std::vector<double> numbers(const std::vector<std::string>& names, std::size_t more = 0);

  /// The same into an array, which keeps what it has beyond them.
  template <std::size_t size>
  void read(std::array<double, size>& into, const std::vector<std::string>& names,
            std::size_t more = 0) {
    const std::vector<double> values = numbers(names, more);
    std::copy(values.begin(), values.end(), into.begin());
  }

  /// `count` numbers that share a name, on as many lines as it takes.
  std::vector<double> array(const std::string& name, std::size_t count);

  /// A text in quotes, the numbers of `names` behind it and up to `more`.
  struct Named {
    std::string text;
    std::vector<double> numbers;
  };
  Named named(const std::string& what, const std::vector<std::string>& names, std::size_t more);

  /// A count or a choice: `value` as a whole number. Throws contact::InputError, which calls it
  /// `name`, where it is none from `least` to `most`.
  int integer(double value, const char* name, int least, int most) const;
  /// The same of the next number.
  int integer(const char* name, int least, int most) {
    return integer(numbers({name}).front(), name, least, most);
  }

  /// Line on which the last thing read began, from 1.
  std::size_t line() const { return line_; }

  /// Throws contact::InputError for that line: `wrong` is what is wrong there, `action` what to do.
  [[noreturn]] void fail(const std::string& wrong, const std::string& action) const;

 private:
  struct Line {
    std::size_t number;
    std::vector<std::string> fields;
  };
  /// `count` numbers, the k-th called names[k], or all the same where there is one name.
  std::vector<double> take(std::size_t count, std::size_t more,
                           const std::vector<std::string>& names);
  /// Throws unless a line is left for `what`.
  void demand(const std::string& what) const;

  std::string name_;
  std::vector<Line> lines_;
  std::size_t next_ = 0, line_ = 0;
};

}  // namespace rollfem::convert

// The line format of CONTACT's input files: numbers first, then words for the reader, comments
// after %, continued on further lines where numbers are missing. Only the layout is known
// here.
#pragma once

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
  /// same line. Angles may be given in degrees (`90d`) and come in rad; exponents may have a d.
  /// Throws contact::InputError naming file, line and the number that is missing.
  std::vector<double> numbers(const std::vector<std::string>& names, std::size_t more = 0);

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
  int whole(double value, const char* name, int least, int most) const;

  /// Line on which the last thing read began, from 1.
  std::size_t line() const { return line_; }

  /// Throws contact::InputError for that line: `wrong` is what is wrong there, `action` what to do.
  [[noreturn]] void fail(const std::string& wrong, const std::string& action) const;

 private:
  struct Line {
    std::size_t number;
    std::vector<std::string> fields;
  };
  const Line& take();
  /// `count` numbers, `name_of(k)` that of the k-th.
  template <class NameOf>
  std::vector<double> take_numbers(std::size_t count, std::size_t more, const NameOf& name_of);

  std::string name_;
  std::vector<Line> lines_;
  std::size_t next_ = 0, line_ = 0;
};

}  // namespace rollfem::convert

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convert/input_lines.hpp"

#include "base/errors.hpp"
#include "base/pi.hpp"
#include "base/text_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rollfem::convert {

namespace {

/// Fields of a line. A quoted text is one field and keeps its first quote as a mark.
std::vector<std::string> quoted_fields(std::string_view line) {
  std::vector<std::string> fields;
  while (!line.empty()) {
    const std::size_t quote = line.find('\'');
    for (const std::string_view field : contact::fields_of(line.substr(0, quote), " \t,"))
      fields.emplace_back(field);
    if (quote == std::string_view::npos) break;
    const std::size_t end = line.find('\'', quote + 1);
    fields.emplace_back(line.substr(quote, end == std::string_view::npos ? end : end - quote));
    if (end == std::string_view::npos) break;
    line.remove_prefix(end + 1);
  }
  return fields;
}

/// Inserts the letter of an exponent that Fortran omits before a sign: .1-07 is 0.1e-07.
void complete_exponent(std::string& field) {
  const std::size_t sign = field.find_last_of("+-");
  if (sign == std::string::npos || sign == 0) return;
  if (contact::number_of(field.substr(0, sign))) field.insert(sign, "e");
}

/// Parses a Fortran number (1.5, 1., 1d-5, .1-07) or an angle in degrees (90d) or rad (1.5r),
/// returned in rad.
std::optional<double> number(std::string field) {
  const auto is = [](char letter, char wanted) {
    return letter == wanted || letter == wanted - 'a' + 'A';
  };
  double unit = 1.0;
  if (is(field.back(), 'd')) unit = contact::pi / 180.0;
  if (is(field.back(), 'd') || is(field.back(), 'r')) field.pop_back();
  std::replace_if(
      field.begin(), field.end(), [&](char letter) { return is(letter, 'd'); }, 'e');
  complete_exponent(field);
  const std::optional<double> value = contact::number_of(field);
  return value ? std::optional<double>(unit * *value) : std::nullopt;
}

}  // namespace

InputLines::InputLines(std::string_view text, std::string name) : name_(std::move(name)) {
  for (contact::TextLines lines(text); lines.next();) {
    std::vector<std::string> fields =
        quoted_fields(contact::trimmed(contact::without_comment(lines.line(), "%")));
    if (!fields.empty()) lines_.push_back({lines.number(), std::move(fields)});
  }
}

void InputLines::fail(const std::string& wrong, const std::string& action) const {
  throw contact::InputError(fmt::format("{}:{}: {}; do: {}", name_, line_, wrong, action));
}

void InputLines::demand(const std::string& what) const {
  if (at_end()) fail("the file ends before " + what, "check that it is complete");
}

std::vector<double> InputLines::take(std::size_t count, std::size_t more,
                                     const std::vector<std::string>& names) {
  std::vector<double> values;
  const std::vector<std::string>* fields = nullptr;
  std::size_t at = 0, first = 0;
  while (values.size() < count) {
    const std::string& missing = names[std::min(values.size(), names.size() - 1)];
    if (fields == nullptr || at == fields->size()) {
      demand(missing);
      line_ = lines_[next_].number;
      fields = &lines_[next_++].fields;
      if (first == 0) first = line_;
      at = 0;
    }
    const auto value = number((*fields)[at++]);
    if (!value)
      fail(fmt::format("expected {}, got {}", missing, contact::printable((*fields)[at - 1])),
           "check for a missing value or line, or a file of another version of CONTACT");
    values.push_back(*value);
  }
  for (; fields != nullptr && at < fields->size() && more > 0; --more) {
    const auto value = number((*fields)[at++]);
    if (!value) break;
    values.push_back(*value);
  }
  if (first > 0) line_ = first;
  return values;
}

std::vector<double> InputLines::numbers(const std::vector<std::string>& names, std::size_t more) {
  return take(names.size(), more, names);
}

std::vector<double> InputLines::array(const std::string& name, std::size_t count) {
  return take(count, 0, {name});
}

int InputLines::integer(double value, const char* name, int least, int most) const {
  if (value != std::floor(value) || value < least || value > most)
    fail(fmt::format("{} = {:g}; allowed: a whole number from {} to {}", name, value, least, most),
         "check for a missing value or line above it");
  return static_cast<int>(value);
}

InputLines::Named InputLines::named(const std::string& what, const std::vector<std::string>& names,
                                    std::size_t more) {
  demand(what);
  // Removes the text, so that the numbers on its line are read like any others.
  std::vector<std::string>& fields = lines_[next_].fields;
  line_ = lines_[next_].number;
  if (fields.front().front() != '\'')
    fail(fmt::format("expected {} in quotes, got {}", what, contact::printable(fields.front())),
         "check for a missing line");
  Named result;
  result.text = std::string(contact::trimmed(std::string_view(fields.front()).substr(1)));
  fields.erase(fields.begin());
  if (fields.empty() || (names.empty() && more == 0)) ++next_;
  result.numbers = numbers(names, more);
  return result;
}

}  // namespace rollfem::convert

#include "convert/equivalent.hpp"

#include "contact/base/errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::convert {

namespace {

std::string with_comment(const std::string& line, const std::string& comment) {
  return comment.empty() ? line : fmt::format("{:<30} # {}", line, comment);
}

const char* problem_of(int T) {
  if (T == 0) return "frictionless";
  if (T == 1) return "shift";
  return T == 2 ? "transient" : "steady";
}

}  // namespace

double in_mm(double place) {
  return std::round(place * 1e10) / 1e10;
}

std::string quoted(const std::string& text) {
  std::string made = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') made += '\\';
    made += letter;
  }
  return made + '"';
}

void Equivalent::set(const std::string& section, const std::string& key, double value,
                     const std::string& comment) {
  fixed[section].push_back(with_comment(fmt::format("{} = {:.12g}", key, value), comment));
}

void Equivalent::set_pair(const std::string& section, const std::string& key, double first,
                          double second, const std::string& comment) {
  fixed[section].push_back(
      with_comment(fmt::format("{} = [{:.12g}, {:.12g}]", key, first, second), comment));
}

void Equivalent::set_word(const std::string& section, const std::string& key,
                          const std::string& word) {
  fixed[section].push_back(key + " = " + quoted(word));
}

Equivalent equivalent_of(const ContactCase& given, const std::string& profile_folder) {
  Equivalent made;
  made.problem = problem_of(given.digits.T);
  // P = 1 keeps the pressure before as a start alone: friction begins from nothing, as with P = 2.
  made.continues = made.history() && given.digits.P == 0;
  judge_digits(given, made);
  note_settings(given, made);
  if (!made.impossible.empty()) return made;
  made.set("friction", "coefficient", given.fstat);
  try {
    if (given.module == 3)
      fill_single_contact(given, made);
    else
      fill_wheel_rail(given, profile_folder, made);
  } catch (const contact::InputError& error) {  // of Hertz, for values that make no contact
    made.impossible.push_back(error.what());
  }
  return made;
}

}  // namespace rollfem::convert

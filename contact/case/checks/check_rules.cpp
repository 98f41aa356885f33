// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks a case against the tables of case_rules.cpp.
#include "contact/case/case_text.hpp"
#include "contact/case/checks/case_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

/// Whether a path matches "section.name" with at most one *.
bool matches(const std::string& pattern, const std::string& path) {
  const std::size_t star = pattern.find('*');
  if (star == std::string::npos) return pattern == path;
  const std::size_t after = pattern.size() - star - 1;
  return path.size() >= star + after && path.compare(0, star, pattern, 0, star) == 0 &&
         path.compare(path.size() - after, after, pattern, star + 1, after) == 0;
}

/// A value without effect: the default, no curvature, no motion.
bool asks_for_nothing(const Key& key, const GivenValue& given) {
  static const Case defaults = default_case();
  if (key.get(defaults) == given.value) return true;
  if (const auto* number = std::get_if<double>(&given.value)) return std::isinf(*number);
  if (const auto* text = std::get_if<std::string>(&given.value)) return *text == "planar";
  const auto* numbers = std::get_if<std::vector<double>>(&given.value);
  return numbers != nullptr && key.unit != "N" &&
         std::all_of(numbers->begin(), numbers->end(), [](double number) { return number == 0.0; });
}

/// Two defaults also contradict each other.
bool is_none(const Key&, const GivenValue& given) {
  return given.value == KeyValue(std::string("none"));
}

using Given = std::map<const Key*, GivenValue>::value_type;

/// The first key of the file that matches a pattern and has an effect; null if none.
const Given* find_match(const GivenCase& given, const char* pattern,
                        bool (*nothing)(const Key&, const GivenValue&)) {
  for (const Given& one : given.values)
    if (matches(pattern, one.first->path()) && !nothing(*one.first, one.second)) return &one;
  return nullptr;
}

std::string falling_laws() {
  std::vector<std::string> words;
  for (const FallShape& shape : fall_shapes())
    if (shape != FallShape::none) words.emplace_back(shape.word);
  return joined(words);
}

void check_exclusion(const GivenCase& given, const Exclusion& rule) {
  if (!rule.where(given)) return;
  for (const char* pattern : rule.keys) {
    const Given* found = find_match(given, pattern, rule.defaults_too ? is_none : asks_for_nothing);
    if (found == nullptr) continue;
    const auto filled = [&](const char* text) {
      return fmt::format(
          fmt::runtime(text), fmt::arg("problem", word_of(given, "rolling", "problem")),
          fmt::arg("slip", word_of(given, "rolling", "extra_slip")),
          fmt::arg("law", word_of(given, "friction", "law")), fmt::arg("laws", falling_laws()));
    };
    fail_at(given, found->first->path(), found->second, filled(rule.wrong), filled(rule.allowed),
            rule.action);
  }
}

bool leaves_points(const GivenValue& value) {
  const auto* list = std::get_if<std::vector<double>>(&value.value);
  return list != nullptr &&
         std::any_of(list->begin(), list->end(), [](double one) { return std::isnan(one); });
}

void check_rivals(const GivenCase& given, const Rivals& rule) {
  const Given* first = nullptr;
  for (const char* pattern : rule.keys) {
    const Given* found = find_match(given, pattern, is_none);
    if (found == nullptr || (rule.by_point && leaves_points(found->second))) continue;
    if (first != nullptr)
      fail_at(given, found->first->path(), found->second,
              fmt::format("contradicts {} = {} of line {}{}", first->first->path(),
                          first->second.text, first->second.line, rule.why),
              rule.allowed, "remove one of the two");
    first = found;
  }
}

void check_need(const GivenCase& given, const Need& rule) {
  if (!rule.where(given)) return;
  for (const char* key : rule.one_of)
    for (const auto& [known, value] : given.values)
      if (known->path() == key) return;
  const std::string path = rule.one_of.front();
  fail_missing(given, path, section_line(given, path.substr(0, path.find('.'))), rule.wrong,
               rule.allowed, rule.action);
}

/// The constants of a law have no meaning for another one.
void check_constants(const GivenCase& given) {
  const std::string law = word_of(given, "friction", "law");
  for (const FallShape& shape : fall_shapes())
    for (const FallShape::Constant& own : shape.constants) {
      if (own.name == nullptr || law == shape.word) continue;
      const GivenValue* found = given.find("friction", own.name);
      if (found != nullptr)
        fail_at(given, std::string("friction.") + own.name, *found,
                fmt::format("is of the law {}, but friction.law is {}", shape.word, law),
                fmt::format("with law = \"{}\"", shape.word), "remove it, or choose that law");
    }
}

}  // namespace

void check_rules(const GivenCase& given) {
  for (const Exclusion& rule : exclusions) check_exclusion(given, rule);
  for (const Rivals& rule : rivals) check_rivals(given, rule);
  for (const Need& rule : needs) check_need(given, rule);
  check_constants(given);
}

}  // namespace rollfem::contact

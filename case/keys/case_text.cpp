// SPDX-License-Identifier: LGPL-2.1-or-later
#include "case/keys/case_text.hpp"

#include "base/text_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rollfem::contact {

namespace {

std::string text_of(double value) {
  return fmt::format("{}", value);
}

std::string text_of(const std::string& value) {
  std::string escaped;
  for (const char c : value) {
    if (c == '"' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return '"' + escaped + '"';
}

template <class Item>
std::string list_of(const std::vector<Item>& items) {
  std::vector<std::string> texts;
  for (const Item& item : items) texts.push_back(text_of(item));
  return "[" + joined(texts) + "]";
}

struct ValueText {
  std::string operator()(std::monostate) const { return ""; }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(double value) const { return text_of(value); }
  std::string operator()(const std::string& value) const { return text_of(value); }
  std::string operator()(const std::vector<double>& value) const {
    return value.size() == 1 ? text_of(value.front()) : list_of(value);
  }
  std::string operator()(const std::vector<std::string>& value) const { return list_of(value); }
};

/// `from`: "from ", or nothing in few words.
std::string range(const Key& key, const std::string& from) {
  const Bounds& bounds = key.bounds;
  const std::string unit = key.unit.empty() ? "" : " " + key.unit;
  std::string text;
  if (bounds.magnitude && bounds.lower == 0.0)
    text = from.empty() ? fmt::format("\u00b1{:g}{}", bounds.upper, unit)
                        : fmt::format("{}{:g} to {:g}{}", from, -bounds.upper, bounds.upper, unit);
  else if (bounds.magnitude)
    text = fmt::format("of magnitude {:g} to {:g}{}", bounds.lower, bounds.upper, unit);
  else
    text = fmt::format("{}{:g} to {}{:g}{}", from, bounds.lower, bounds.upper_open ? "below " : "",
                       bounds.upper, unit);
  if (bounds.zero) text += ", or 0";
  return text + (bounds.infinite ? ", or inf" : bounds.none ? ", or nan" : "");
}

}  // namespace

std::optional<double> ratio_of(const std::string& text) {
  if (text.rfind("1:", 0) != 0) return {};
  const std::optional<double> number = number_of(std::string_view(text).substr(2));
  return number && *number > 1.0 ? number : std::nullopt;
}

// Not fmt::join: gcc 12 reports a false buffer overflow in its inlined format parser.
std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all;
}

std::string toml_text(const KeyValue& value) {
  return std::visit(ValueText{}, value);
}

std::string allowed_values(const Key& key, const KnownNames& known, bool brief) {
  const auto said = [&](const char* full, const char* few) {
    return std::string(brief ? few : full);
  };
  const std::string within = range(key, said("from ", ""));
  switch (key.kind) {
    case KeyKind::text:
      return said("a string in quotes", "text");
    case KeyKind::word:
      return said("one of ", "") + joined(key.words);
    case KeyKind::words:
      if (key.choices(known).empty()) return "a list of names";
      return fmt::format("{}of {}",
                         key.empty ? "a list of some or none " : said("a list of some ", "some "),
                         joined(key.choices(known)));
    case KeyKind::number:
      return said("a number ", "") + within;
    case KeyKind::integer:
      return said("a whole number ", "whole, ") + within;
    case KeyKind::boolean:
      return "true or false";
    case KeyKind::pair:
      return said("a list of two numbers ", "two, ") + within;
    case KeyKind::triple:
      return said("a list of three numbers ", "three, ") + within;
    case KeyKind::numbers:
      return said("a number or a list of numbers ", "list, ") + within;
    case KeyKind::lean:
      return fmt::format("\"{}\", a ratio such as \"1:40\", or an angle {} rad", joined(key.words),
                         within);
  }
  return "";
}

}  // namespace rollfem::contact

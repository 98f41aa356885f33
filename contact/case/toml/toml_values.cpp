// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/base/text_fields.hpp"
#include "contact/case/case_text.hpp"
#include "contact/case/toml/toml_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

constexpr std::size_t longest_text = 200;

std::string instance_of(const Key& key) {
  const std::string value = key.example.empty() ? toml_text(key.get(default_case())) : key.example;
  if (!value.empty()) return fmt::format("`{} = {}`", key.name, value);
  if (key.kind == KeyKind::text) return fmt::format("`{} = \"points.csv\"`", key.name);
  if (key.kind == KeyKind::pair) return fmt::format("`{} = [0.2, 0.2]`", key.name);
  const double plain = key.unit == "N"      ? 80e3
                       : key.unit == "MPa"  ? 1000.0
                       : key.unit == "mm/s" ? 30e3
                                            : 2.0;
  const Bounds& of = key.bounds;
  return fmt::format("`{} = {}`", key.name, toml_text(of.contains(plain) ? plain : 0.5 * of.upper));
}

std::string kind_is(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a section";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number with a fraction or exponent";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

/// One value of one key, or an item of a list with its own position in the file.
class ValueReader {
 public:
  ValueReader(const TomlSource& source, const Key& key, const std::vector<std::string>& names,
              const toml::node& node)
      : source_(source), key_(key), names_(names), node_(node) {
    given_.line = node.source().begin.line;
    given_.column = node.source().begin.column;
    given_.text = source.value(node.source());
  }

  GivenValue read() {
    given_.value = value();
    return std::move(given_);
  }

 private:
  [[noreturn]] void fail_value(const std::string& wrong) const {
    const bool words = key_.kind == KeyKind::word || key_.kind == KeyKind::words;
    fail(source_.file(),
         {given_.line, given_.column, key_.path(), given_.text, wrong, allowed_values(key_, names_),
          words ? "write one of these names in quotes"
                : fmt::format("correct it, for instance {}", instance_of(key_))});
  }

  KeyValue value() const {
    switch (key_.kind) {
      case KeyKind::text:
        return text();
      case KeyKind::word:
        return word_of(node_);
      case KeyKind::words:
        return words();
      case KeyKind::integer:
        if (!node_.is_integer()) fail_value("expected a whole number, got " + kind_is(node_));
        return number();
      case KeyKind::number:
        return number();
      case KeyKind::boolean:
        if (!node_.is_boolean()) fail_value("expected true or false, got " + kind_is(node_));
        return node_.value_or(false);
      case KeyKind::pair:
        return numbers("two", 2);
      case KeyKind::triple:
        return numbers("three", 3);
      case KeyKind::numbers:
        return node_.is_array() ? numbers("", 0) : std::vector<double>{number()};
      case KeyKind::lean:
        if (node_.is_string()) return lean();
        return number();
    }
    return {};
  }

  std::string text() const {
    if (!node_.is_string()) fail_value("expected a string in quotes, got " + kind_is(node_));
    const std::string text = node_.value_or(std::string());
    if (text.size() > longest_text)
      fail_value(fmt::format("is longer than {} characters", longest_text));
    for (const char c : text)
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
        fail_value("has a line break or another control character");
    return text;
  }

  std::string word_of(const toml::node& node) const {
    if (!node.is_string()) fail_value("expected a string in quotes, got " + kind_is(node));
    const std::string word = node.value_or(std::string());
    const std::vector<std::string>& words = key_.words.empty() ? names_ : key_.words;
    if (words.empty() || std::find(words.begin(), words.end(), word) != words.end()) return word;
    const std::string near = nearest_name(word, words);
    fail_value(near.empty() ? "is not known" : fmt::format("is not known (near: {})", near));
  }

  std::string lean() const {
    const std::string given = text();
    if (ratio_of(given)) return given;
    if (std::find(key_.words.begin(), key_.words.end(), given) == key_.words.end())
      fail_value("is not a ratio of 1 to a number above 1");
    return given;
  }

  /// The value as a list.
  const toml::array& list(const std::string& what) const {
    const toml::array* array = node_.as_array();
    if (array == nullptr) fail_value("expected a list" + what + ", got " + kind_is(node_));
    if (array->empty() && !key_.empty) fail_value("is an empty list");
    return *array;
  }

  std::vector<std::string> words() const {
    std::vector<std::string> words;
    for (const toml::node& item : list("")) {
      const std::string word = word_of(item);
      if (std::find(words.begin(), words.end(), word) != words.end())
        fail_value(fmt::format("names {} twice", word));
      words.push_back(word);
    }
    return words;
  }

  double number() const {
    if (!node_.is_number()) fail_value("expected a number, got " + kind_is(node_));
    const double value = node_.value_or(0.0);
    if (std::isnan(value) && !key_.bounds.none) fail_value("is not a number");
    if (std::isinf(value) && !key_.bounds.contains(value))
      fail_value("is infinite, which is not allowed here");
    if (!key_.bounds.contains(value)) fail_value("is out of bounds");
    // -0.0 would keep its sign in every table.
    return value == 0.0 ? 0.0 : value;
  }

  /// `count` in words and as a number, 0 for any number of entries.
  std::vector<double> numbers(const std::string& words, std::size_t count) const {
    const toml::array& array = list(" of " + words + " numbers");
    if (count > 0 && array.size() != count)
      fail_value(fmt::format("has {} entries, not {}", array.size(), count));
    if (array.size() > longest_list)
      fail_value(fmt::format("has more than {} entries", longest_list));
    std::vector<double> numbers;
    for (const toml::node& item : array)
      numbers.push_back(ValueReader(source_, key_, names_, item).number());
    return numbers;
  }

  const TomlSource& source_;
  const Key& key_;
  const std::vector<std::string>& names_;
  const toml::node& node_;
  GivenValue given_;
};

}  // namespace

GivenValue read_value(const TomlSource& source, const Key& key,
                      const std::vector<std::string>& names, const toml::node& node) {
  return ValueReader(source, key, names, node).read();
}

GivenValue checked_value(const std::string& file, const Key& key,
                         const std::variant<double, std::string>& value) {
  const auto read = [&](const std::string& text, const toml::node& node) {
    return read_value(TomlSource(text, file), key, {}, node);
  };
  if (const auto* text = std::get_if<std::string>(&value))
    return read(toml_text(*text), toml::value<std::string>(*text));
  const double number = std::get<double>(value);
  return key.kind == KeyKind::integer
             ? read(toml_text(number), toml::value<std::int64_t>(static_cast<std::int64_t>(number)))
             : read(toml_text(number), toml::value<double>(number));
}

}  // namespace rollfem::contact

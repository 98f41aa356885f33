// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/write/case_schema.hpp"

#include "case/keys/case_keys.hpp"
#include "case/keys/case_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace rollfem::result {

namespace {

using contact::Key;
using contact::KeyKind;
using Json = nlohmann::ordered_json;

/// Schema of a number within the bounds; validators read inf as a number beyond any bound.
Json number_in(const contact::Bounds& bounds, const char* type) {
  Json schema{{"type", type}};
  const char* const upper = bounds.upper_open ? "exclusiveMaximum" : "maximum";
  const bool two_sided = !bounds.magnitude || !(bounds.lower > 0.0);
  const double lower = bounds.magnitude ? -bounds.upper : bounds.lower;
  if (std::isfinite(lower)) schema["minimum"] = lower;
  if (std::isfinite(bounds.upper) && !bounds.infinite) schema[upper] = bounds.upper;
  if (bounds.zero) return {{"anyOf", {schema, {{"const", 0}}}}};
  if (two_sided) return schema;
  if (bounds.infinite) schema.erase("minimum");
  // Magnitude above the lower bound, with either sign.
  Json either = Json::array();
  either.push_back({{"maximum", -bounds.lower}});
  either.push_back({{"minimum", bounds.lower}});
  schema["anyOf"] = either;
  return schema;
}

Json list_of(Json item, int count) {
  Json schema{{"type", "array"}, {"items", std::move(item)}};
  if (count > 0) {
    schema["minItems"] = count;
    schema["maxItems"] = count;
  }
  return schema;
}

Json either(Json one, Json other) {
  Json schema;
  schema["anyOf"] = {std::move(one), std::move(other)};
  return schema;
}

Json text_of(const std::vector<std::string>& words) {
  Json schema{{"type", "string"}};
  if (!words.empty()) schema["enum"] = words;
  return schema;
}

Json value_of(const Key& key, const contact::KnownNames& known) {
  switch (key.kind) {
    case KeyKind::text:
      return text_of({});
    case KeyKind::word:
      return text_of(key.words);
    case KeyKind::words: {
      Json schema = list_of(text_of(key.choices(known)), 0);
      schema["uniqueItems"] = true;
      return schema;
    }
    case KeyKind::number:
      return number_in(key.bounds, "number");
    case KeyKind::integer:
      return number_in(key.bounds, "integer");
    case KeyKind::boolean:
      return {{"type", "boolean"}};
    case KeyKind::pair:
      return list_of(number_in(key.bounds, "number"), 2);
    case KeyKind::triple:
      return list_of(number_in(key.bounds, "number"), 3);
    case KeyKind::numbers: {
      const Json one = number_in(key.bounds, "number");
      return either(one, list_of(one, 0));
    }
    case KeyKind::lean:
      return either(number_in(key.bounds, "number"),
                    either(text_of(key.words), {{"type", "string"}, {"pattern", "^1:"}}));
  }
  return {};
}

/// Text that an editor shows for the key.
std::string description(const Key& key, const contact::KnownNames& known) {
  std::string text = key.sentence;
  if (!key.unit.empty()) text += fmt::format(" Unit: {}.", key.unit);
  text += fmt::format(" Allowed: {}.", contact::allowed_values(key, known));
  if (!key.when_absent.empty()) text += fmt::format(" Default: {}.", key.when_absent);
  return text;
}

Json section_of(const contact::Section& section, const contact::KnownNames& known) {
  Json schema{{"type", "object"}, {"description", section.sentence}};
  schema["additionalProperties"] = false;
  schema["properties"] = Json::object();
  for (const Key& key : section) {
    Json value = value_of(key, known);
    value["description"] = description(key, known);
    schema["properties"][key.name] = std::move(value);
    // Elsewhere another section may replace it, as profiles replace radii.
    if (key.required && section.repeated) schema["required"].push_back(key.name);
  }
  if (!section.repeated) return schema;
  return {{"type", "array"}, {"items", std::move(schema)}};
}

}  // namespace

std::string case_schema(const contact::KnownNames& known) {
  Json root;
  root["$schema"] = "http://json-schema.org/draft-07/schema#";
  root["title"] = "rollfem case file";
  for (const contact::Section& section : contact::case_sections()) {
    Json schema = section_of(section, known);
    if (section.name.empty()) {
      root.update(schema);
      continue;
    }
    const std::size_t dot = section.name.find('.');
    if (dot == std::string::npos) {
      root["properties"][section.name] = std::move(schema);
      continue;
    }
    Json& outer = root["properties"][section.name.substr(0, dot)];
    outer["type"] = "object";
    outer["additionalProperties"] = false;
    outer["properties"][section.name.substr(dot + 1)] = std::move(schema);
  }
  return root.dump(2) + "\n";
}

}  // namespace rollfem::result

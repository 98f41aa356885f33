// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/write/json_head.hpp"

#include "result/files/seal.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace rollfem::result {

using nlohmann::ordered_json;

ordered_json place_json(const contact::ContactPlace& place) {
  return {{"wheel", place.side()}, {"position", place.position}, {"patch", place.patch}};
}

namespace {

ordered_json number_json(double number) {
  return std::isfinite(number) ? ordered_json(number) : ordered_json(fmt::format("{}", number));
}

/// Row k of an entry: a line of text, a number, or a list of numbers.
ordered_json row_json(const Entry& entry, std::size_t k) {
  if (const auto* lines = std::get_if<std::vector<std::string>>(&entry.values)) return (*lines)[k];
  const Array& array = std::get<Array>(entry.values);
  if (array.shape.size() == 1) return number_json(array.at(k));
  ordered_json row = ordered_json::array();
  for (std::size_t c = 0; c < array.shape[1]; ++c)
    row.push_back(number_json(array.at(k * array.shape[1] + c)));
  return row;
}

std::size_t rows_of(const Entry& entry) {
  if (const auto* lines = std::get_if<std::vector<std::string>>(&entry.values))
    return lines->size();
  return std::get<Array>(entry.values).shape[0];
}

ordered_json list_json(const Tree& tree) {
  ordered_json list = ordered_json::array();
  if (*tree.listed == contact::Listed::as_table)
    for (std::size_t k = 0; k < rows_of(tree.entries.front()); ++k) {
      ordered_json& row = list.emplace_back(ordered_json::object());
      for (const Entry& entry : tree.entries) row[entry.name] = row_json(entry, k);
    }
  else
    for (const Tree& part : tree.parts) {
      ordered_json& row = list.emplace_back(ordered_json::object());
      row[tree.key] = part.name;
      row.update(json_of(part));
    }
  return list;
}

}  // namespace

ordered_json json_of(const Tree& tree, bool arrays) {
  ordered_json json = ordered_json::object();
  for (const auto& [name, value] : tree.attributes)
    if (const auto* number = std::get_if<double>(&value); number != nullptr) {
      if (!std::isnan(*number)) json[name] = number_json(*number);
    } else {
      std::visit([&json, &called = name](const auto& each) { json[called] = each; }, value);
    }
  for (const Entry& entry : tree.entries)
    if (arrays || std::holds_alternative<std::vector<std::string>>(entry.values)) {
      json[entry.name] = ordered_json::array();
      for (std::size_t k = 0; k < rows_of(entry); ++k)
        json[entry.name].push_back(row_json(entry, k));
    }
  for (const Tree& part : tree.parts)
    if (part.summed_up && part.listed != contact::Listed::numbered)
      json[part.name] = part.listed ? list_json(part) : json_of(part);
  return json;
}

std::string json_text(const ordered_json& json, int indent) {
  return sealed_json(json.dump(indent, ' ', false, ordered_json::error_handler_t::replace));
}

}  // namespace rollfem::result

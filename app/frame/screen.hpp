// SPDX-License-Identifier: LGPL-2.1-or-later
// Standard output of a command: text, nothing (--quiet), or one JSON object (--json).
#pragma once

#include "result/write/columns.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace rollfem::app {

/// Discards all text for standard output from here on.
void silence();

/// Prints the result of a command with --json, also after silence().
void print_result(const std::string& json);

/// Keys format (1), kind and program, with which every printed object begins.
nlohmann::ordered_json result_head(const std::string& kind);

/// The columns of a table as lists of numbers by name, and their units by name; empty cells become
/// null.
template <class Row>
nlohmann::ordered_json columns_json(const result::Columns<Row>& table,
                                    const std::vector<Row>& rows) {
  using Json = nlohmann::ordered_json;
  Json columns = Json::object(), units = Json::object();
  for (const auto& column : table.all()) {
    Json& list = columns[column.name] = Json::array();
    for (const Row& row : rows) {
      const std::string cell = column.cell(row);
      list.push_back(cell.empty() ? Json() : Json(std::stod(cell)));
    }
    units[column.name] = column.unit;
  }
  return {{"columns", columns}, {"units", units}};
}

}  // namespace rollfem::app
